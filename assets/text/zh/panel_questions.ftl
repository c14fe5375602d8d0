### 空窗口、询问和小窗口。

## 开始

start_name = clearbeam
start_claim = 只清洗您选定的面
start_drop = 将 STL 文件拖到此处
start_open = 打开…
start_steps = 1  打开零件     2  将面移入待清洗列表     3  导出程序
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
ask_view_mouse = 左键拖动旋转，单击选择 · 中键或右键拖动平移 · 滚轮以光标处为中心缩放
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
ask_export_over = 未写入任何文件
ask_export_over_folder = { $folder } 中有本次导出不得替换的文件：
ask_export_over_file = • { $conflict }
ask_export_other = 选择其他文件夹…
