### 窗口用语：标题、状态栏、视图、文件对话框。

## 标题
window_title = { $name } – clearbeam
window_title_unsaved = ● { $name } – clearbeam
window_title_empty = clearbeam

## 最近的操作
window_reading = 正在读取 { $file }…
window_restoring = 正在恢复 { $part }…
window_facets_read = 已读取 { $count } 个面片
window_saved = 已保存 { $file }
window_writing_into = 正在写入 { $folder }…
window_packing = 正在把作业及文件打包到 { $file }
window_packed = 已把作业及全部文件打包到 { $file }
window_exported = 已导出 { $program }
window_export_cancelled = 导出已取消
window_part_being_built = 正在重建零件；完成后再更改分割角

## 无法执行
window_no_finished_plan = 作业的当前状态没有完成的规划；请等待规划完成，或查看问题
window_planning_cancelled = 规划已取消；按 Ctrl+R 重新规划
window_part_of_another_state = 零件文件不是作业此状态所用的文件；请重做，或重新打开作业
window_fault = { $error }；作业未受影响：请先保存，再按 Ctrl+R 重试
window_not_opened = 无法打开窗口：{ $reason }；没有屏幕时请使用 `clearbeam plan`，或在 xvfb-run 下运行

## 菜单栏
menu_needs_robot = 请先在“机器人”中选择机器人
menu_panels = 面板 ▼
menu_panels_tip = 视图旁边显示的内容
command_with_step = { $name }：{ $step }

## 命令不可用的原因
why_not_part = 请先打开零件
why_not_plan = 尚无规划：请将面移入待清洗列表
why_not_selected = 请先选择一个面
why_not_one_selected = 请只选择一个面
why_not_two_selected = 请选择两个或更多的面
why_not_left = 所选面已在待清洗列表中
why_not_listed = 请选择待清洗列表中的面
why_not_undo = 没有可撤销的操作
why_not_redo = 没有可重做的操作
why_not_idle = 没有正在进行的计算
why_not_scan = 请先在“零件”中添加扫描数据
why_not_weld = 请先打开焊缝图像

## 状态栏
status_cancel = 取消
status_size = { $passes } 道 · { $targets } 个路径点
status_corrected = { $count } 个已修正
status_work = { $length_mm } mm · { $time }
status_out_of_date = 已过期
status_out_of_date_tip = 按 Ctrl+R 重新规划
status_proven = { $moves } 段出光运动已验证无干涉
status_proven_by = { $moves } 段出光运动已验证无干涉，安全裕量 { $margin_mm } mm
status_with_clearance = { $line }，最小间隙 { $clearance_mm } mm

## 视图
toolbar_show = 显示 ▼
toolbar_show_tip = 选择视图的显示内容
toolbar_cut_axis = 垂直于 { $axis } 剖切
toolbar_cut_place = 剖切位置
toolbar_cut_other = 另一侧
toolbar_pick_origin = 单击要设为原点的位置 · Esc 结束
toolbar_lay_flat = 单击要朝下放平的面 · Esc 结束
toolbar_measure = 单击两处以测量其间距离 · Esc 结束
toolbar_paint = 在面上涂过即可选择 · 按住 Ctrl 拖动视图 · Esc 结束
toolbar_put_clamp = 单击夹具的安放位置 · Esc 结束
measure_place = 面 { $surface } { $label }  x { $x }  y { $y }  z { $z }
measure_distance = 相距 { $mm } mm  Δx { $x }  Δy { $y }  Δz { $z }
measure_parallel = 平行，相距 { $mm } mm
measure_angle = 夹角 { $angle }°
theme_dark = 深色主题
theme_light = 浅色主题
theme_system = 跟随系统主题
view_spiral_centre_here = 以此处为螺旋中心
view_only_with_spiral = 仅用于策略为螺旋的面
view_offset_from_this_border = 从此边界等距
view_only_with_offset = 仅用于策略为等距且有边界的面
view_border = 面 { $surface } 的第 { $number } 条边界（共 { $count } 条），长 { $length_mm } mm
legend_laser_off = 关光
legend_tip = 单击可显示或隐藏
legend_entry = 线：{ $what }

## 文件对话框
dialog_part_or_job = 打开零件或作业
dialog_part = 选择零件
dialog_job = 保存作业
dialog_program_folder = 选择程序文件夹
dialog_dry_run_folder = 选择空运行文件夹
dialog_cell = 选择工作站文件
dialog_head = 选择激光头
dialog_save_head = 保存激光头
dialog_clamp = 选择夹具文件
dialog_scan = 选择扫描数据
dialog_weld_gray = 选择焊缝灰度图
dialog_weld_depth = 选择焊缝深度图
dialog_weld_camera = 选择拍摄两幅图像的相机
dialog_hand_eye = 选择手眼标定位姿或结果
dialog_grinding_tool = 选择打磨工具
dialog_robot = 选择机器人文件
browser_up = 上级文件夹
browser_path = 路径
browser_name = 名称
browser_empty = 此处没有可打开的文件
browser_all = 显示所有文件
browser_all_tip = 否则只显示：{ $endings }
browser_size = { $kilobytes } kB
browser_not_there = { $path } 不存在
browser_new_folder = 新建文件夹…
browser_new_folder_name = 新文件夹名称
browser_make = 创建
browser_replaces = { $name } 已存在
browser_replace = 替换
browser_open = 打开
browser_save = 保存
browser_choose = 选择此文件夹
browser_choose_file = 请选择文件
