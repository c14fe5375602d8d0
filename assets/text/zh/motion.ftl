### 什么与什么干涉、机器人为何拒绝路径点，以及有什么建议。

## 发生干涉的物体

contact_pair = { $a }与{ $b }干涉
body_head = 激光头
body_part = 零件
body_table = 工作台
body_clamp = 夹具“{ $file }”
body_obstacle = 障碍物“{ $file }”
body_base = 基座
body_shoulder = 肩部
body_upper_arm = 大臂
body_forearm = 小臂
body_wrist = 手腕

## 路径点被拒绝的原因

why_out_of_reach = 无论绕光轴转角多少，都超出 { $robot } 的可达范围
why_joint_limit = J{ $joint } 需要 { $needs }°，其范围为 { $low } 至 { $high }°
why_limit_between = 在两个路径点之间，有关节会超出限位
why_joint_speed = J{ $joint } 需要以 { $needs }°/s 转动，但最高只能 { $can }°/s
why_wrist_flip = J{ $joint } 会在一步内跳变 { $jump }°：手腕翻转
why_singular = 手臂的所有位姿都接近奇异，关节会急速转动
why_branch_change = 手臂需要在一道的中途改变构型
why_no_motion = 手臂从此处起没有可以继续的连续运动
why_contact_at_home = 还在原点位时，{ $contact }：请换个位置夹持零件，或修改 air.home_joints_deg
why_no_way = 没有能让手臂和零件全程无干涉地到达此处的路线
why_not_chosen = 未选定手臂的位姿
why_hit_on_move = 法兰走直线时，光斑在（{ $x }, { $y }, { $z }）处，{ $hit }
why_hit_as_written = 按写出的程序运行时，{ $hit }
why_hit_drawn_back = 激光头退回时，{ $hit }
why_off_line = 光斑会偏离扫描线 { $off } mm

## 建议

advice_change = { $change }：{ $gains }
advice_gains = { $of } 个被拒绝的路径点中有 { $gained } 个变为可行
advice_gains_and_loses = { $of } 个被拒绝的路径点中有 { $gained } 个变为可行，另有 { $lost } 个变为不可行
advice_free_spin = 不限制绕光轴转角
advice_turn_on_flange = 将法兰上的零件绕其 { $axis } 轴转动 { $deg }°
advice_turn_on_table = 将工作台上的零件绕其 { $axis } 轴转动 { $deg }°
advice_move = 将{ $what ->
    [laser] 激光器
   *[part] 零件
}{ $direction ->
    [up] 上移
    [down] 下移
    [out] 朝远离机器人的方向移动
    [in] 朝靠近机器人的方向移动
    [left] 向左（+y）移动
   *[right] 向右（−y）移动
} { $mm } mm
advice_hold_further = 夹持零件时离法兰再远 { $mm } mm
advice_slower = 将光斑速度降到 { $speed } mm/s：这样没有关节超速
advice_sampled = （在 { $of } 个被拒绝的路径点中试算了 { $tried } 个）
