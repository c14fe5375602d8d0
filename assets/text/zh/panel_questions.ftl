### 空窗口、询问和小窗口。

## 开始

start_name = clearbeam
start_claim = 只清洗您选定的面
start_drop = 将 STL 文件拖到此处
start_open = 打开…
start_steps = 1  打开零件     2  将面移入待清洗列表     3  导出程序
start_tour = 操作引导
start_tour_tip = 用示例零件完成第一个作业，从零件到程序：约五分钟
start_picture = { $file } 的图片

## 操作引导

tour_title = 操作引导
tour_step = 第 { $step } 步，共 { $of } 步
tour_turn = 这是示例零件：带凸台、凹坑和孔的平板。在视图中按住鼠标左键拖动，从各个方向观察；滚轮缩放。
tour_choose = 单击平板中间的凹坑，然后按 Enter。它会移入“待清洗列表”，并立即规划路径。
tour_space = 在“路径”中将“行距”改为其他值，例如 1 mm。扫描线和规划随之更新。
tour_watch = 查看规划：用视图下方的“播放”或方向键逐步查看。深蓝表示无干涉，橙色表示已倾斜避让，红色表示会碰到其他部位，因此不出光。
tour_robot = 在“机器人”中选择机器人。此后可达范围、限位和时间均为已知，“机器人工作站”显示手臂。
tour_export = “导出程序…”先询问文件夹，再显示将写入的内容、未完成的内容和假定条件。确认后导出。
tour_done = 作业已完成。在真实出光运行之前：请测量坐标系，导出空运行程序并观察其运行。详见手册。
tour_end = 结束引导
tour_close = 关闭
start_samples = 示例
start_recent = 最近打开
start_no_folder = { $folder }：无法创建：{ $reason }

## 未保存的更改

ask_save = 保存更改？
ask_save_before_close = 作业有未保存的更改。关闭前是否保存？
ask_save_before_open = 作业有未保存的更改。打开其他零件前是否保存？
ask_save_yes = 保存
ask_save_no = 不保存
ask_cancel = 取消
ask_saving = 正在保存…

## 错误和快捷键

ask_error = 错误
ask_close = 关闭
ask_shortcuts = 快捷键
ask_view = 视图
ask_view_mouse = 左键拖动旋转，单击选择 · 中键或右键拖动平移 · Shift 加左键拖动框选 · 滚轮以光标处为中心缩放
ask_view_mouse_cad = 中键拖动旋转，按住 Ctrl 或 Shift 时平移 · 右键拖动平移 · 左键拖动框选，单击选择 · 滚轮以光标处为中心缩放
ask_view_mouse_blender = 中键拖动旋转，按住 Shift 平移，按住 Ctrl 缩放 · 右键拖动平移 · 左键拖动框选，单击选择 · 滚轮以光标处为中心缩放
ask_view_focus = 双击面可对准该面，双击背景可显示全部

## 零件文件

ask_part_changed = 零件文件已更改
ask_part_changed_file = { $file } 不是创建此作业时所用的文件。
ask_part_moved = 内容齐全，但整个零件已移动。仅在确实有意移动时才使用。
ask_part_found = 作业中关于面的设置已全部重新对应。
ask_part_lost = 作业中关于面的设置未能全部重新对应，对应不上的将被丢弃。
ask_part_undo = 此操作不会保存任何内容，并且可以撤销。
ask_part_use = 使用更改后的零件
ask_part_other = 选择其他文件…
ask_part_gone = 找不到零件
ask_part_gone_file = 作业引用的文件是 { $file }。它是否已被移动或重命名？

## 程序异常结束后的遗留内容

ask_restore = 发现未保存的更改
ask_restore_why = 保存这些更改之前程序已结束。
ask_restore_not_saved = 尚未保存
ask_restore_row = { $job } · 最后编辑 { $when }
ask_restore_yes = 恢复
ask_restore_no = 放弃
ask_restore_later = 暂不处理
ask_when_now = 刚刚（{ $time } UTC）
ask_when_minutes = { $count } 分钟前（{ $time } UTC）
ask_when_hours = { $count } 小时前（{ $time } UTC）
ask_when_days = { $count } 天前（{ $time } UTC）

## 文件冲突

ask_job_changed = 作业文件已更改
ask_job_changed_file = { $file } 在此处打开后，已被其他程序或窗口更改。
ask_job_exists = 文件已存在
ask_job_exists_file = { $file } 已存在。
ask_backup = 覆盖时，现有文件会保留为备份（.bak）。
ask_save_as = 另存为…
ask_overwrite = 覆盖
ask_reload = 重新加载
ask_export_other = 选择其他文件夹…

## 导出前的页面
export_page_heading = 导出程序
export_page_dry_run = 导出空运行程序
export_page_from_pass = 从第 { $pass } 道起导出
export_page_folder = 文件夹
export_page_size = 规模
export_page_time = 加工长度和时间
export_page_not_done = 未完成
export_page_all_done = 待清洗列表中的面全部完成
export_page_more = 另有 { $count } 项，见问题列表
export_page_later = { $count } 个面留待其他作业处理
export_page_assumed = 假定条件
export_page_replaced = 将替换的文件
export_page_nothing_replaced = 无：文件夹中没有同名文件
export_page_conflicts = 以下文件不是此作业先前导出时的状态：
export_page_row = • { $what }
export_page_folder_there = 有同名文件夹：请选择其他文件夹
export_page_export = 导出
export_page_replace = 替换并导出
