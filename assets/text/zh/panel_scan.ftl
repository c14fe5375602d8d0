### 零件的扫描数据：文件、清理、配准位置、磨损。

scan_panel = 扫描数据
scan_panel_tells_worked = 加工部位由扫描数据决定：请勾选其缺损区
scan_panel_keeps_surfaces = 有扫描数据时不可用：缺损区处零件的面片与文件中的不同

## 文件

scan_panel_add = 添加扫描数据…
scan_panel_open_tip = 零件实际形状的点云（PLY、PCD、XYZ、TXT、CSV、PTS、PTX、E57 或 STL）
scan_panel_shared = 各文件坐标系相同
scan_panel_overlap = 拼接各文件
scan_panel_overlap_tip = 每个文件按与前面各文件的重叠区域拼接上去
scan_panel_own = 仅按此扫描数据加工
scan_panel_own_tip = 零件就是扫描数据，没有其他模型：扫描线沿扫描点布置，并避开未扫描到的部位
scan_panel_remove = 从扫描数据中移除此文件
scan_panel_units = 单位
scan_panel_units_name = 扫描数据单位 { $units }

## 清理

scan_panel_points = 读取 { $read } 个点，保留 { $left } 个
scan_panel_clean = 清理：
scan_panel_add_outliers = + 离群点
scan_panel_add_thinning = + 抽稀
scan_panel_add_smoothing = + 平滑
scan_panel_outliers = 离群点
scan_panel_thinning = 抽稀
scan_panel_smoothing = 平滑
scan_panel_cut_box = 长方体裁剪
scan_panel_cut_plane = 平面裁剪
scan_panel_erased = 擦除
scan_panel_neighbours = 邻点数
scan_panel_sigma = 标准差倍数
scan_panel_sigmas = σ
scan_panel_voxel = 体素
scan_panel_radius = 半径
scan_panel_step_field = 清理步骤 { $step } { $what }
scan_panel_counts = { $before } → { $after }
scan_panel_remove_step = 移除此步骤
scan_panel_remove_step_name = 移除清理步骤 { $step }

## 配准位置

scan_panel_lies = 在原始模型上的位置
scan_panel_given = 位置由作业给定
scan_panel_in_doubt = 固定位置之前请先检查
scan_panel_keep = 固定此位置
scan_panel_keep_tip = 位置随作业保存，不再重新配准
scan_panel_matrix = 位置数值
scan_panel_take_matrix = 采用此位置
scan_panel_no_matrix = 请按行给出 model_from_scan 的十六个数
scan_panel_look_again = 重新配准
scan_panel_look_again_tip = 作业清除已保存的位置，并重新配准
scan_panel_take_rival = 采用这个
scan_panel_take_rival_name = 采用位置 { $rival }

## 磨损

scan_panel_deviation = 与原始模型的偏差
scan_panel_work = 加工：
scan_panel_work_patches = 缺损部位
scan_panel_work_surfaces = 选定的面
scan_panel_work_surfaces_tip = 只加工扫描到的部位，并避开零件上的多余材料
scan_panel_lines = 扫描线位于：
scan_panel_lines_model = 原始模型
scan_panel_lines_points = 扫描点
scan_panel_lines_points_tip = 由平面确定的扫描线，会贴合扫描到的零件形状
scan_panel_missing = { $patch }：深 { $depth } mm，{ $area } mm²，{ $volume } mm³
scan_panel_surplus = 多余 { $depth } mm，{ $area } mm²，{ $volume } mm³
scan_panel_show = 显示
scan_panel_work_tip = 是否加工此缺损区
scan_panel_work_name = 加工缺损区 { $patch }
scan_panel_smaller = 另有 { $count } 个更小的
scan_panel_patch_name = 缺损区 { $patch }

## 视图中的颜色

scan_panel_legend = 与原始模型的偏差（mm）
scan_panel_scale = 偏差色标
