### 没有零件、没有规划的原因。

stage_panicked = 软件内部错误：{ $words }
part_changed = 零件文件与创建作业时所用的不同
plan_no_surface = 面 { $surface } 不存在：零件的面为 1 至 { $last }；请用 `clearbeam inspect` 查看
plan_nothing_chosen = 未选择面；请至少将一个面移入待清洗列表
plan_spacing_too_large = spacing = { $spacing } mm 大于零件（{ $size } mm）；请减小，或改正 --units
plan_spacing_too_small = spacing = { $spacing } mm 在此零件上约需 { $points } 个点；请加大，或改正 --units
plan_part_too_large = 零件尺寸为 { $size } mm；是否有远离零件的面片，或 --units 有误？请用 `clearbeam inspect` 查看
from_pass_no_pass = 没有第 { $asked } 道：规划有第 0 至 { $last } 道，编号见 path.csv 各行行首
from_pass_without_passes = 没有第 { $asked } 道：规划中没有任何道
from_pass_no_way = 找不到从原点位到第 { $pass } 道的无干涉空行程；请从其他道继续，或在工作站文件中设置 air.entry_joints_deg
plan_folds = 面 { $surface } 内凹太深，无法堆 { $layers } 层或更多：面片会翻折重叠；请减少层数，或减小 bead.height_mm
