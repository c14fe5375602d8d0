### 规划结果的提示，最严重的在前，以及相应的建议。

## 未验证
notice_unproven_beam = { $moves } 段出光运动未验证：光束会碰到{ $surface }
notice_unproven_head = { $moves } 段出光运动未验证：激光头会碰到{ $surface }
notice_unproven_beam_clamp = { $moves } 段出光运动未验证：光束会碰到夹具
notice_unproven_head_clamp = { $moves } 段出光运动未验证：激光头会碰到夹具
notice_unproven_abrasive = { $moves } 段出光运动未验证：打磨工具会过于靠近{ $surface }
notice_unproven_gouge = { $moves } 段出光运动未验证：打磨工具会在接触处旁边过切{ $surface }
notice_unproven_abrasive_clamp = { $moves } 段出光运动未验证：打磨工具会过于靠近夹具
remedy_not_proven = 请勿运行程序；`clearbeam verify` 会列出相应的程序行；请换一种修正方式，或不加工该面

## 未完成
notice_no_wear = 扫描数据中没有需要加工的缺损区：缺料深度均未超过缺损区阈值
notice_held = 各道正在等待确认，因此没有程序
notice_nothing_to_grind = 没有剩余的道，也没有选择其他区域，因此没有程序
notice_no_lines = 没有可加工的内容，因此没有程序：所选的面上没有扫描线
notice_no_lines_for = 没有可加工的内容，因此没有程序：所选的面（{ $area } mm²）上没有扫描线：{ $why }
notice_no_lines_on = { $surface }：{ $area } mm² 上没有扫描线：{ $why }
notice_all_left_out = 没有可加工的内容，因此没有程序：所有路径点都被略去：{ $list }
notice_by_surface = { $targets } 个（受阻于{ $surface }）
notice_by_cause = { $targets } 个（{ $cause }）
notice_blocked_by = { $surface }：{ $targets } 个路径点受阻于{ $by }
notice_blocked_for_head = { $surface }：{ $targets } 个路径点受阻：激光头会碰到{ $by }
notice_blocked_for_tool = { $surface }：{ $targets } 个路径点受阻：工具会碰到{ $by }
notice_blocked = { $surface }：{ $targets } 个路径点受阻
notice_refused = { $surface }：{ $targets } 个路径点被拒绝：{ $why }
notice_example = 例如第 { $pass } 道第 { $point } 点：{ $why }
notice_missed_by_planes = { $surface }：{ $area } mm² 中有 { $missed } mm² 被截面漏扫
notice_missed_by_lines = { $surface }：{ $area } mm² 中有 { $missed } mm² 被扫描线漏扫
why_beam = 光束会碰到其他物体
why_robot = 手臂或零件会碰到其他物体
why_head = 激光头会碰到其他物体
why_obstacle = 会碰到障碍物
why_reach = 超出机器人可达范围
why_far_from_flange = 零件离法兰太远，光斑无法保持在扫描线上
why_limit = 有关节会超出限位
why_speed = 有关节会超速
why_singularity = 手臂会处于奇异位置
remedy_no_lines = 请选择其他面、更小的行距或另一个截面方向
remedy_slack = 零件可能偏离测得的位置 { $slack } mm，工具因此多留同样大小的间隙：请补扫或补拍能确定其位置的边或孔，或不使用零件文件
remedy_grinding = 请先磨掉挡在那里的部分，或换用更小的工具
remedy_correct = 请允许光束倾斜：修正方式选择 section-plane（截面）或 clearance（避让）
remedy_clearance = 修正方式请选择 clearance（避让）
remedy_tilt = 请允许更大的倾角，或换一种装夹布置来清洗
remedy_obstacle = 请移动障碍物或零件
remedy_turn_part = 请稍微转动或移动零件
remedy_reach = 请将零件移近机器人可达范围的中部
remedy_far_from_flange = 请将零件移近法兰，或在 CAD 中移近原点
remedy_limit = 请转动或移动零件，或将绕光轴转角设为 free（自由）
remedy_speed = 请选择更低的速度
remedy_missed_by_planes = 请尝试将截面方向设为 auto（自动）
remedy_missed_by_lines = 请选择更小的行距或另一种策略

## 面上没有扫描线的原因
taken_by_direction = 截面与面平行
taken_by_spacing = 行距 { $mm } mm 时一条也放不下
taken_by_turn = 行距 { $mm } mm 时螺旋一圈也放不下
taken_by_no_border = 面是封闭的，没有可供扫描线跟随的边界
taken_by_border = 没有边界 { $border }：该面共有 { $borders } 条边界
taken_by_facets = 没有面积大于零的面片
taken_by_inset = 内缩 { $mm } mm 后没有剩余
taken_by_holes = 从孔内缩 { $mm } mm 后没有剩余
taken_by_shortest = 各段都短于保留下限 { $mm } mm

## 使面有扫描线的更改
change_direction = 将截面方向改为 { $direction }
change_spacing = 将行距改为 { $mm } mm
change_inset = 将内缩改为 { $mm } mm
change_ignored_holes = 忽略不超过 { $mm } mm 的孔
change_shortest = 保留 { $mm } mm 及更长的线段
change_whole_outline = 从整个轮廓开始
change_strategy = 将策略改为“{ $strategy }”
cure = { $change }：由此生成扫描线的有{ $surfaces }
cure_and_more = { $list } 以及另外 { $more } 个面
cure_in_recipe = 在工艺配方“{ $recipe }”中{ $change }：由此生成扫描线的有{ $surfaces }

## 与设定不符
notice_slow = { $surface }：{ $moves } 段出光运动的光斑速度低于设定的 { $wanted } mm/s，作用时间因此变长：控制器指令在第 { $pass } 道第 { $point } 点最高只允许 { $possible } mm/s
notice_fast = { $surface }：{ $moves } 段出光运动的光斑速度高于设定的 { $wanted } mm/s，作用时间因此变短：控制器指令在第 { $pass } 道第 { $point } 点无法低于 { $possible } mm/s
remedy_slow = 请设定更低的速度，或选择光束转动较慢的修正方式 clearance（避让）
remedy_fast = 请设定更高的速度，或换一种机器人语言
notice_remark = { $surface }：{ $remark }
remark_layers_alike = 各层走向相同：没有与其截面交叉的方向
remark_stops_at_rim = { $ends } 个扫描线端点止于边缘：那里是锐边或零件末端，光斑必须留在零件上
remark_no_lines = 第 { $layer } 层的 { $area } mm² 上没有扫描线：{ $why }
remark_too_short = { $pieces } 段（共长 { $length } mm）短于 { $shortest } mm，已略去

## 已找到
notice_part_changed = 零件文件在保存作业之后有改动；待清洗的面已全部重新找到
notice_renumbered = { $old } 现为 { $new }
notice_surfaces_renumbered = 面 { $list }
notice_surfaces_lost = 未找到：面 { $list }
remedy_part_changed = 请在窗口中查看各面，然后保存作业
