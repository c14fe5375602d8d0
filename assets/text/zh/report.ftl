### 简要报告。

## 规划的状态
standing_unproven = { $moves } 段出光运动未验证
standing_left_out = 略去 { $targets } 个路径点
standing_proven = 已验证无干涉：{ $moves } 段出光运动
standing_no_wear = 没有可加工的内容：扫描数据中没有要加工的缺损区
standing_held = 各道等待您的确认
standing_nothing_to_grind = 没有可加工的内容：没有剩余的道，也未选择其他区域
standing_no_lines = 没有可加工的内容：所选的面上没有扫描线
standing_no_lines_for = 没有可加工的内容：所选的面上没有扫描线：{ $why }
standing_no_light = 没有可加工的内容：没有出光运动
standing_all_left_out = 没有可加工的内容：全部 { $targets } 个路径点均被略去
standing_nothing_left = 没有可加工的内容：略去 { $targets } 个路径点

## 数据
report_targets = { $passes } 道，{ $targets } 个路径点：{ $free } 个无干涉，{ $corrected } 个已修正，{ $blocked } 个受阻
report_lengths = 出光 { $work } mm，受阻 { $blocked } mm，空行程 { $air } mm，用时 { $time }
report_lengths_ground = 打磨 { $work } mm，受阻 { $blocked } mm，空行程 { $air } mm，用时 { $time }
report_extremes = 最大倾角 { $tilt }°，弦高误差 { $chord } mm，面上的最大行距 { $spacing } mm
report_layers = { $layers } 层，每层都按前面各层完成后的零件形状规划并验证
report_splits = { $splits } 处断开：光束从壁的一侧转到另一侧时关光
report_order = 扫描线之间的行程为 { $way } mm，往复顺序则为 { $zigzag } mm
report_surface_blocked = { $surface }：{ $whole } mm 中有 { $blocked } mm 受阻

## 剂量
report_no_dose = 剂量：未计算；可用 --dose 计算
dose_shares = { $within }% 的面积在 { $low } 至 { $high } J/cm² 之间，{ $under }% 不足，{ $over }% 过量，{ $shaded }% 被遮挡
dose_collateral = 误照射：未选择的面上有 { $area } mm² 超过 { $most } J/cm²：{ $list }
dose_patch_thin = 剂量不足：{ $surface } 在 ({ $x }, { $y }, { $z }) 附近有 { $area } cm²，{ $why }
dose_patch_dark = 无法清洗：{ $surface } 在 ({ $x }, { $y }, { $z }) 附近有 { $area } cm²，{ $why }
dose_patches_more = 另有 { $patches } 处较小的区域，见 report.json
patch_between_lines = 位于扫描线之间，行距过大：请设为小于 { $spacing } mm
patch_too_little = 附近有扫描线，但到达的剂量过少
patch_blocked = 光束受阻
patch_blocked_by = 光束被{ $by } 阻挡
patch_shaded = 被遮挡
patch_shaded_by = 被{ $by } 遮挡
patch_missed = 附近没有扫描线
