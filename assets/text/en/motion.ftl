### What touches what, why the robot refuses targets, and what would help.

## Bodies that touch

contact_pair = { $a } against { $b }
body_head = head
body_part = part
body_table = table
body_clamp = clamp { $file }
body_obstacle = obstacle { $file }
body_base = base
body_shoulder = shoulder
body_upper_arm = upper arm
body_forearm = forearm
body_wrist = wrist

## Why a target is refused

why_out_of_reach = out of reach of the { $robot } at any spin
why_joint_limit = J{ $joint } would need { $needs }°, its range is { $low } to { $high }°
why_limit_between = between two targets a joint would leave its range
why_joint_speed = J{ $joint } would have to turn at { $needs }°/s, and can do { $can }°/s
why_wrist_flip = J{ $joint } would jump by { $jump }° in one step: the wrist flips
why_singular = every pose of the arm is next to a singularity, where joints would race
why_branch_change = the arm would have to change its branch in the middle of a pass
why_no_motion = no continuous motion of the arm leads on from here
why_contact_at_home = { $contact } already at home: hold the part elsewhere, or change air.home_joints_deg
why_no_way = no way leads here on which arm and part keep clear of everything
why_not_chosen = no pose of the arm was chosen
why_hit_on_move = as the flange goes straight, with the spot at ({ $x }, { $y }, { $z }), { $hit }
why_hit_as_written = as the program is written, { $hit }
why_hit_drawn_back = as the head is drawn back, { $hit }
why_off_line = the spot would leave its line by { $off } mm

## What would help

advice_change = { $change }: { $gains }
advice_gains = { $gained } of { $of } refused targets become possible
advice_gains_and_loses = { $gained } of { $of } refused targets become possible, { $lost ->
    [one] { $lost } other is lost
   *[other] { $lost } others are lost
}
advice_free_spin = leave the spin free
advice_turn_on_flange = turn the part on the flange about its { $axis } by { $deg }°
advice_turn_on_table = turn the part on the table about its { $axis } by { $deg }°
advice_move = put { $what ->
    [laser] the laser
   *[part] the part
} { $mm } mm { $direction ->
    [up] higher
    [down] lower
    [out] further from the robot
    [in] nearer to the robot
    [left] to the left (+y)
   *[right] to the right (−y)
}
advice_hold_further = hold the part { $mm } mm further from the flange
advice_slower = slow the spot down to { $speed } mm/s: then no joint is too fast
advice_sampled = (tried on { $tried } of the { $of } refused targets)
