### 程序为何无法写出或读取，以及哪些内容未达到要求。

## 写出

write_no_robot = { $dialect } 程序需要机器人；请给出 --robot
write_off_is_on = { $dialect }.output_off 与 { $dialect }.output_on 相同；激光会一直出光
write_no_template = { $dialect }.{ $key } 为空，而工作站的一个输出信号要用到它；请填写控制器的语句，其中含 { "{n}" } 和 { "{v}" }
write_timed_joint_move = { $dialect }：关节运动不能指定时间；请以百分比给出速度
write_straight_in_percent = { $dialect }：直线运动不能以百分比指定速度；请给出时间
write_from_unknown_pose = { $dialect }：从原点位开始的直线运动，须有机器人才能确定速度；请给出 --robot
write_home_needs_pulses = yaskawa：原点位只有关节角；请给出 --robot，或在工作站文件中给出 pulses_per_deg
write_piece_too_long = 一段连续出光需要 { $lines } 行，而一个程序只能容纳 fanuc.max_lines = { $most } 行；在中途调用子程序会使光斑停住：请减少路径点后重新规划（--chord-error、--max-step、--max-turn）
write_program_numbers = nachi.number = { $number }：{ $pages } 个子程序会编号到 { $last }，而最大为 999；请减小该编号，或增大 nachi.max_moves
write_too_many_positions = yaskawa：激光无停顿的一段超过 100 000 个位置；请加大路径点间距

## 读取

read_at_line = { $file }，第 { $line } 行：{ $what }
read_gone = { $file }，第 { $line } 行：调用的 { $called } 不在同一文件夹中
read_cut_off = { $file }：结尾没有 { $expected }；文件不完整
read_expected = 无法识别“{ $found }”；应为 { $expected }
read_one_more = { $first } 或 { $last }
read_numbers = “{ $found }”：请给出 { $count } 个数值
read_not_above_zero = “{ $found }”：请给出大于 0 的数值
read_quaternion = 四元数的模为 { $length }；应为 1
read_behind_end = 位于 { $end } 之后；请删除
read_not_as_in_cell = 与工作站文件不符；应为 { $expected }
read_before = 在此之前必须有 { $missing }
read_twice = { $name } 重复出现
read_undefined = { $name } 不存在
read_never_called = { $name } 从未被调用
read_circle = 调用 { $called } 形成循环，或嵌套过深；每个程序只应调用一次
read_nested_call = 子程序不能再调用子程序
read_bad_call = 调用的“{ $called }”不是程序编号
read_outside_function = 位于程序的函数之外
read_count = { $of } 声明的数量为 { $promised }，实际有 { $found } 个
read_count_missing = { $of } 没有声明数量，实际有 { $found } 个
read_out_of_order = “{ $found }”处应为 { $expected }：缺少一行或顺序有误
read_no_motion_group = 没有 DEFAULT_GROUP 说明程序控制哪些轴
read_other_motion_group = “{ $found }”：含第二个运动组；此处的程序只控制一个手臂，请给出单一运动组的程序
read_flange_speed = “{ $found }”是法兰的速度，不能说明光斑的速度；请给出该运动的时间：{ $expected }
read_arc = “{ $found }”：此处无法核对圆弧；请给出直线运动
read_no_duration = 到关节角的直线运动：须有机器人才能确定时间
read_from_nowhere = 直线运动之前没有任何位置；应为关节运动
read_goes_on_straight = 运动到关节角，而 { $file } 第 { $line } 行接着作直线运动，须有机器人才能确定其时间；此处应为位姿，或该行应为关节运动
read_no_pulses_per_degree = 位置为脉冲值；请在工作站文件中给出 yaskawa.pulses_per_deg
read_other_columns = 列与此格式不符
read_unused_cells = “{ $what }”填写了它不使用的单元格
read_focus_without_flange = 有焦点而没有对应的法兰
read_no_robot_to_compare = 同时有关节角和法兰，但没有机器人来核对两者
read_no_goal = 既没有关节角，也没有位姿
read_no_timing = 请给出 seconds 或 percent 中的一个
read_disagree = { $first } 与 { $second } 相差 { $mm } mm 和 { $deg }°

## 未达到要求的内容

shortfall_leads = 已省去 { $count } 个引入段或引出段：在其上会碰到物体
shortfall_short_moves = { $moves } 个出光运动的时间不足 { $least } ms，最短为 { $shortest } ms，原因是弦高误差、转角或光斑偏差；控制器在这些位置可能会减速
shortfall_power = 该面的功率 { $value } W 须在程序提示处手动设定：请为工作站配置 outputs.power
shortfall_frequency = 该面的频率 { $value } kHz 须在程序提示处手动设定：请为工作站配置 outputs.frequency
