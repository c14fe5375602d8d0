### 工作站文件或机器人文件有什么问题，以及坐标系与测量值的吻合程度。

## 工作站与机器人

cell_none_for = 机器人 { $robot } 没有自带的工作站；请给出 --cell
cell_obstacle = 工作站的障碍物：{ $what }
robot_unknown = { $name } 既不是自带的机器人（{ $shipped }），也不是机器人文件
robot_kinematics = 运动学参数只能给出一次：[opw] 或 [ur]
robot_short = { $key } 为 { $value } mm，而手臂的该尺寸至少为 { $least } mm；是否误用了 m 而不是 mm？
robot_sign = signs 中有 { $value }：应为 1 或 -1
robot_limits = J{ $joint } 的 limits_deg：{ $low } 至 { $high } 不是有效的角度范围
robot_speed = J{ $joint } 的 speeds_deg_s = { $value }：应为 { $low } 至 { $high }
robot_dialect = dialect = { $dialect }：没有此名称的控制器；应为以下之一：{ $known }
robot_mesh = { $key }：{ $what }；请指定机器人文件旁的 STL 文件，或去掉此键：该连杆将以胶囊体代替
robot_mesh_facets = links.meshes 的文件共有 { $facets } 个面片，最多只能检查 { $most } 个：请降低手臂的导出精度，去掉螺栓和内部结构
robot_mesh_off = { $key }：{ $file } 偏离其关节 { $off } mm：请在机器人基座坐标系中导出，各关节处于 links.meshes.at_deg，并检查单位

## 机器人的位置

place_beyond_joint = { $key }：J{ $joint } = { $deg } 超出 { $robot } 的范围 { $low } 至 { $high }
place_high_table = bodies.table_z_mm = { $z }：工作台与机器人肩部一样高；请降低
place_laser_in_base = base_from_laser：激光器位于机器人基座内部，基座绕 1 轴宽 { $width } mm；请将激光器移出

## 数值

figure_range = { $key } = { $value }：应为 { $low } 至 { $high }
figure_positive = { $key } = { $value }：应大于 0，不超过 { $high }
figure_not_finite = { $key } 中有 { $value }：应为有限的数值
figure_head_piece = bodies.head：from_mm = { $from }，to_mm = { $to }：应为从焦点起逆着光的方向的 mm 值，小的在前
figure_obstacle = bodies.obstacles：{ $file } 的位置中有不是有限数值的内容
figure_taken = { $key } = { $number }：已被 { $by } 占用；请换一个

## 程序中的名称、行和模板

name_identifier = { $key } = { $value }：应以字母开头，后接字母、数字和 _，总长最多 { $longest } 个字符
name_capital_identifier = { $key } = { $value }：应以大写字母开头，后接大写字母、数字和 _，总长最多 { $longest } 个字符
name_capitals = { $key } = { $value }：应为大写字母、数字、- 和 _，总长最多 { $longest } 个字符
program_line = { $key } 中有 { $line }：应为 ASCII 文本，每项一行
form_version = { $key } = { $value }：应为以 // 开头的一行 ASCII 文本
form_termination = { $key } = { $value }：应为 FINE，或 CNT0 至 CNT100
form_configuration = { $key } = { $value }：应为类似 N U T, 0, 0, 0 的形式
form_unit = { $key } = { $value }：应为字母、数字、- 和 _；它将用作文件名
form_longest_name = { $key } = { $value }：应为 8 或 32
form_attributes = { $key } 中有 { $value }：NOP 之前的行以 /// 开头
form_pulses = { $key } 中有 { $value }：应为 10 至 1000000，或 -1000000 至 -10
template_lacks = { $key } = { $template } 中缺少 { $name }
template_unknown = { $key } = { $template } 中有 { $name }：应为 { $known }
template_touching = { $key } = { $template }：相邻的花括号之间应有其他字符，否则无法读回
template_blank = { $key } 为空：请给出结束力控制的语句，或将开始和结束两项都去掉
template_not_plain = { $key } = { $template }：应为一行 ASCII 文本

## 坐标系

frame_wrong = { $frame }：{ $what }
frame_tip_poses = { $frame }：tip_poses 用于确定工具尖端的位置；此处请给出 three_points 或 points
frame_range = { $key } { $value } 不在 -{ $most } 至 { $most } 之内
frame_keys = 坐标系应为 position_mm 和 rz_ry_rx_deg，或 three_points，或 points，或 tip_poses 和 rz_ry_rx_deg
fit_figure = { $value } 不可能是测量得到的数值
fit_x_near_origin = three_points：x 距 origin 仅 { $off } mm：请重新测量 x，在空间允许时尽量远
fit_xy_near_axis = three_points：xy 距 x 轴仅 { $off } mm：请重新测量 xy，明显离开该轴
fit_few_poses = tip_poses 只有 { $count } 个位姿：请以至少四个绕不同方向转动的位姿触碰同一尖端
fit_one_direction = tip_poses 中法兰只绕其方向（{ $x }, { $y }, { $z }）转动，或几乎没有转动：请用向不同侧倾斜 20° 以上的位姿重新测量
fit_no_tip = tip_poses：无法拟合出尖端：请重新测量
fit_few_pairs = points 只有 { $count } 对点：请至少测量三对，最好六对
fit_model_on_line = points：模型点在 { $width } mm 之内共线：请再测一个明显离开该直线的点
fit_measured_on_line = points：测量点在 { $width } mm 之内共线：请再测一个明显离开该直线的点
fit_no_frame = points：无法拟合出坐标系：请重新测量
calibration = 由 { $method } 得到 { $frame }：均方根偏差 { $rms } mm，最大 { $worst } mm
calibration_each = 由 { $method } 得到 { $frame }：均方根偏差 { $rms } mm，最大 { $worst } mm（{ $each }）
