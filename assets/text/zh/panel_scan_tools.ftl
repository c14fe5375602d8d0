### 扫描数据的手动操作：点对、排除部位、裁剪、标签、图表、截面，以及扫描仪的位置。

scan_tool_radius = 画笔半径
scan_tool_radius_prefix = 半径{ " " }

## 点对

scan_pairs_pick = 拾取点对
scan_pairs_of_job = 按 { $count } 个点对配准
scan_pairs_forget = 清除点对
scan_pairs_forget_tip = 重新从任意位置开始配准
scan_pairs_hint = 先单击扫描数据上的一点，再单击原始模型上的同一处
scan_pairs_hint_model = 现在单击原始模型上的同一处
scan_pairs_hint_scan = 现在单击扫描数据上的同一点
scan_pairs_lay = 按这 { $count } 个点对配准
scan_pairs_too_few = 至少拾取三个点对，且不在一条直线上
scan_pairs_remove = 移除此点对
scan_pairs_remove_name = 移除点对 { $pair }
scan_pairs_row = 点对 { $pair }：相差 { $off } mm
scan_pairs_row_open = 点对 { $pair }
scan_pairs_off_laid = 扫描数据在当前位置时各点对的偏差
scan_pairs_off_themselves = 仅按点对配准时各点对的偏差

## 排除部位

scan_leave_out = 排除部位
scan_leave_out_count = 已排除 { $count } 处
scan_leave_out_clear = 取消全部排除
scan_leave_out_clear_tip = 配准时不再排除原始模型的任何部位
scan_leave_out_brush = 画笔
scan_leave_out_rubber = 橡皮擦
scan_leave_out_corners = 长方体
scan_leave_out_hint_brush = 涂抹要排除的部位（左键拖动；Ctrl + 拖动旋转视图）
scan_leave_out_hint_rubber = 擦除不再排除的部位（左键拖动；Ctrl + 拖动旋转视图）
scan_leave_out_hint_corner = 在原始模型上单击长方体的一个角点
scan_leave_out_hint_other_corner = 单击对角点
scan_leave_out_selected = 包围所选面的长方体
scan_leave_out_selected_tip = 沿坐标轴包围所选面的长方体，各侧再加宽一个半径
scan_leave_out_legend = 已排除

## 裁剪

scan_cut = 裁剪：
scan_cut_name = 用{ $what }裁剪
scan_cut_by_box = 长方体
scan_cut_by_plane = 平面
scan_cut_by_brush = 画笔
scan_cut_hint_box = 在扫描数据上单击两个对角点，或输入坐标
scan_cut_hint_other_corner = 单击对角点
scan_cut_hint_plane = 单击平面要通过的一个点；或单击三个点，这时保留零件所在的一侧
scan_cut_hint_brush = 涂抹要去除的点（左键拖动；Ctrl + 拖动旋转视图）
scan_cut_from = 从
scan_cut_to = 到
scan_cut_corner = 长方体 { $corner } { $axis }
scan_cut_keep_inside = 保留内部
scan_cut_keep_outside = 保留外部
scan_cut_across = 垂直于
scan_cut_across_name = 垂直于 { $axis } 的平面
scan_cut_flip = 换侧
scan_cut_flip_tip = 改为保留平面另一侧的点
scan_cut_shift = 平面偏移
scan_cut_shift_prefix = 偏移{ " " }
scan_cut_brush_anew = 重新涂抹
scan_cut_dropped = 去除 { $of } 个点中的 { $dropped } 个
scan_cut_add = 添加此步骤
scan_cut_add_not = 不会去除任何点，或会去除全部点
scan_cut_cancel = 取消

## 标签

scan_labels = 放置标签
scan_labels_hint = 单击一点，读取其与原始模型的偏差
scan_labels_clear = 全部删除
scan_labels_remove = 删除此标签
scan_labels_remove_name = 删除标签 { $label }
scan_labels_row = { $label }：{ $off } mm，位于 ({ $x }, { $y }, { $z })
scan_labels_mark = { $off } mm

## 图表

scan_figures = 图表
scan_figures_convergence = 配准：{ $steps } 步后均方根偏差 { $last } mm
scan_figures_convergence_name = 配准收敛曲线
scan_figures_left_over = 剩余偏差（mm，虚线：噪声 ±{ $noise } mm）
scan_figures_left_over_name = 剩余偏差直方图
scan_figures_deviation = 与原始模型的偏差（mm，虚线：缺损区起点 { $least }，公差 { $tolerance } mm）
scan_figures_deviation_name = 偏差直方图

## 截面

scan_section = 截面垂直于
scan_section_across = 垂直于 { $axis } 的截面
scan_section_place = 截面位置
scan_section_place_tip = 也可单击零件上的一处
scan_section_times = 偏差放大
scan_section_times_name = 偏差的放大倍数
scan_section_ruler = 与原始模型偏差 0.1 mm 时画成 { $mm } mm
scan_section_axis = { $axis }（mm）
scan_section_name = 零件和扫描数据的截面

## 扫描仪的位置

scan_placing = 在工作站中的位置
scan_placing_part_in_hand = 机器人手持零件：这里是扫描仪相对于法兰的位置
scan_placing_by_frame = 输入扫描仪坐标系
scan_placing_by_markers = 标记点
scan_placing_forget = 清除扫描仪位置
scan_placing_frame = 扫描仪相对于基座
scan_placing_frame_tip = 扫描数据坐标系在机器人基座坐标系中的位置
scan_placing_frame_on_flange = 扫描仪相对于法兰
scan_placing_frame_on_flange_tip = 扫描数据坐标系相对于夹持零件的法兰的位置
scan_placing_on_flange = 相对于法兰
scan_placing_marker = 标记点 { $marker }
scan_placing_marker_off = 标记点 { $marker }：相差 { $off } mm
scan_placing_in_scan = 在扫描数据中
scan_placing_in_base = 在机器人基座坐标系中（触碰测得）
scan_placing_field = 标记点 { $marker } { $frame } { $axis }
scan_placing_add = 添加标记点
scan_placing_remove = 移除标记点 { $marker }

## 面跨过损伤处的延续
scan_continue = 无原始模型：跨损伤处延续面
scan_continue_hint = 损伤就是已排除的部位。请选择其周围的面，再选择面的类型
scan_continue_tip = 所选面跨过已排除的部位延续，相对于该面缺少的材料即为磨损
scan_continue_plane = 平面
scan_continue_cylinder = 圆柱面
scan_continue_revolved = 回转面
scan_continue_extruded = 拉伸面
scan_continue_smooth = 光滑曲面
scan_continue_found = { $number }：{ $kind }，与完好点的均方根偏差 { $rms } mm，跨度 { $gap } mm，不确定度 { $spread } mm
scan_continue_remove = 取消此损伤处的面延续
