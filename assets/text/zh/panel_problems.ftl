### 规划或零件文件中的问题，以及实际行距的图例。

## 问题

problems_heading = 问题
problems_out_of_date = 问题：已过期
problems_none = 问题：无
problems_count = 问题（{ $count }）
problems_found = 零件文件的检查结果
problems_alike = 另有 { $count } 条同类问题
problems_beam_hits = 光束碰到面 { $surface }（面片 { $facet }）
problems_beam_hits_something = 光束碰到物体
problems_head_hits = 激光头碰到面 { $surface }（面片 { $facet }）
problems_head_hits_something = 激光头碰到物体
problems_tool_hits = 工具碰到面 { $surface }（面片 { $facet }）
problems_tool_hits_something = 工具碰到物体
problems_left_out = 已略去
problems_go = 转到该处
problems_show = 显示
problems_use_changed_scan = 使用已更改的扫描数据
problems_use_changed_scan_tip = 采用文件的当前内容，并重新配准扫描数据
problems_use_changed_image = 使用已更改的图像
problems_use_changed_image_tip = 采用文件的当前内容，图像上涂画和选择的内容会被清除

## 零件文件的疑点

file_treat_as_mm = 按毫米处理
file_treat_as_m = 按米处理
file_treat_as_inch = 按英寸处理
file_absorb = 并入小于 { $below } mm² 的碎面
file_dismiss = 忽略
file_dismiss_tip = 仍保留在问题列表中

## 改善建议

problems_help = 改善建议
problems_help_looking = 正在查找改善建议…
problems_help_cancelled = 查找已取消；按 { $keys } 重新规划并查找
problems_help_none = 试过的单项更改均无帮助
problems_help_undo = 更改作业并重新规划；可撤销

## 实际行距

spacing_legend = 实际行距
spacing_legend_none = 没有相邻的扫描线
spacing_legend_scale = 行距色标
spacing_legend_closer = 偏密
spacing_legend_wanted = 符合设定
spacing_legend_farther = 偏疏
spacing_legend_least = 最小 { $mm } mm，在面 { $surface }
spacing_legend_greatest = 最大 { $mm } mm，在面 { $surface }
spacing_legend_percent = 占各面设定行距的百分比（%）
