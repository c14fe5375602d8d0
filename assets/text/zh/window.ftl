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
menu_needs_robot = 请在“工作站”中选择机器人
command_with_step = { $name }：{ $step }

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
toolbar_pick_origin = 单击要设为原点的位置 · Esc 结束
toolbar_lay_flat = 单击要朝下放平的面 · Esc 结束
view_spiral_centre_here = 以此处为螺旋中心
view_only_with_spiral = 仅用于策略为螺旋的面
view_offset_from_this_border = 从此边界等距
view_only_with_offset = 仅用于策略为等距且有边界的面
view_border = 面 { $surface } 的第 { $number } 条边界（共 { $count } 条），长 { $length_mm } mm

## 文件对话框
dialog_part_or_job = 零件或作业
dialog_part = 零件
dialog_job = 作业
dialog_program_folder = 程序文件夹
dialog_dry_run_folder = 空运行文件夹
dialog_cell = 工作站
dialog_head = 激光头
dialog_clamp = 夹具
dialog_scan = 扫描数据
dialog_weld_gray = 焊缝灰度图
dialog_weld_depth = 焊缝深度图
dialog_weld_camera = 拍摄两幅图像的相机
dialog_image = 图像
dialog_camera = 相机
dialog_hand_eye = 手眼标定位姿或结果
dialog_grinding_tool = 打磨工具
dialog_robot = 机器人
