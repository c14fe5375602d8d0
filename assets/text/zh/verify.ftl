### 程序与规划的差异。

verify_no_dialect = { $file }：不是任何已知机器人语言（{ $known }）的程序；请给出导出的文件
verify_plan_unwritable = 无法用该程序的机器人语言写出规划：{ $reason }
verify_plan_needs_robot = 作业中没有机器人，因此无法写出用于比较的 { $dialect } 程序；请用导出该程序时的作业核对，或在作业中指定机器人：[cell] 中的 robot
verify_plan_needs_pulses = 作业中没有机器人，此时 yaskawa 程序的原点位只能由脉冲值得知；请用导出该程序时的作业核对，或在作业中指定机器人（[cell] 中的 robot），或在工作站文件中给出 yaskawa.pulses_per_deg
verify_no_program = 规划中没有程序
verify_plan_unreadable = 无法读取规划自身的程序：{ $reason }

## 生成程序所用的文件
verify_input_changed = { $name }：程序生成后{ $what }已更改，SHA-256 原为 { $was }，现为 { $is }
verify_input_gone = { $name }：程序生成时使用了此{ $what }，现在却没有；SHA-256 原为 { $was }
verify_input_new = { $name }：程序生成时没有使用此{ $what }；SHA-256 为 { $is }
input_part = 零件
input_scan = 扫描数据
input_image = 图像
input_camera = 相机
input_hand_eye = 手眼标定文件
input_grinder = 打磨工具
input_cell = 工作站
input_robot = 机器人
input_head = 激光头
input_clamp = 夹具
input_obstacle = 障碍物

## 程序行的错误
verify_missing = 此行之前，规划中还有：{ $line }
verify_end_missing = 规划中还有 { $lines } 行缺失，其中第一行：{ $first }
verify_extra = 规划中没有：{ $line }
verify_behind_end = 在规划结束之后：{ $line }
verify_other = 此处：{ $found }，规划：{ $planned }
verify_other_words = 此处：“{ $found }”，规划：“{ $planned }”
verify_other_meaning = 按机器人语言的写法解读：{ $found }，规划：{ $planned }
verify_spot_off = 光斑偏离 { $mm } mm，并转过 { $deg }°
verify_joint_off = J{ $joint } 位于 { $found }°，规划中为 { $planned }°
verify_out_of_reach = { $robot } 无法到达该处
verify_beyond_range = J{ $joint } = { $at }° 超出其范围 { $low } 至 { $high }°
verify_too_fast = J{ $joint } 的转速为 { $speed }°/s，最高为 { $most }°/s
verify_lit_by_joints = 出光时作关节运动
verify_lit_to_unknown = 出光时从关节角度出发或运动到关节角度：只有给定机器人才能确定其走向
verify_ends_lit = 程序结束时仍在出光
verify_touches = 出光时{ $what }
verify_hits_facet = 出光时，射向 ({ $x }, { $y }, { $z }) 的光束碰到面片 { $facet }

## 程序行的动作
line_move = { $way }到{ $goal }
line_output_on = 输出信号 { $number } 接通
line_output_off = 输出信号 { $number } 断开
line_group = 组输出 { $number } 设为 { $value }
line_analogue = 模拟输出 { $number } 设为 { $value }
line_force = 力 { $force } N
line_wait = 等待 { $seconds } s
way_by_joints = 关节运动
way_straight = 直线运动
goal_joints = 关节角度 ({ $angles })
goal_flange = 法兰位姿 { $pose }
goal_focus = 焦点位姿 { $pose }
pace_seconds = { $seconds } s
pace_percent = { $percent } %
