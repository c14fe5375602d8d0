### How a program differs from its plan.

verify_no_dialect = { $file }: is no program of any dialect known here ({ $known }); give the file that was exported
verify_plan_unwritable = the plan cannot be written in the program's dialect: { $reason }
verify_plan_needs_robot = the job has no robot, and without one a { $dialect } program cannot be written to compare with; verify with the job that the program was exported with, or name the robot in the job: robot in [cell]
verify_plan_needs_pulses = the job has no robot, and without one home is known to a yaskawa job by pulses only; verify with the job that the program was exported with, name the robot in the job (robot in [cell]), or give yaskawa.pulses_per_deg in the cell file
verify_no_program = the plan has no program
verify_plan_unreadable = the plan's own program cannot be read: { $reason }

## Files that the program was made from
verify_input_changed = { $name }: the { $what } has changed since the program was made, SHA-256 was { $was } and is { $is }
verify_input_gone = { $name }: the program was made with this { $what }, and now there is none; SHA-256 was { $was }
verify_input_new = { $name }: the program was made without this { $what }; SHA-256 is { $is }
input_part = part
input_scan = scan
input_image = image
input_camera = camera
input_hand_eye = hand-eye file
input_grinder = grinding tool
input_cell = cell
input_robot = robot
input_head = head
input_clamp = clamp
input_obstacle = obstacle

## What is wrong with a line
verify_missing = before this line the plan has: { $line }
verify_end_missing = { $lines ->
    [one] one more line of the plan is missing: { $first }
   *[other] { $lines } more lines of the plan are missing, the first: { $first }
}
verify_extra = the plan does not have: { $line }
verify_behind_end = after the end of the plan: { $line }
verify_other = { $found } where the plan has { $planned }
verify_other_words = "{ $found }" where the plan has "{ $planned }"
verify_other_meaning = the dialect's words give { $found } where the plan has { $planned }
verify_spot_off = the spot is { $mm } mm off and turned by { $deg }°
verify_joint_off = J{ $joint } stands at { $found }°, the plan has { $planned }°
verify_out_of_reach = the { $robot } cannot go there
verify_beyond_range = J{ $joint } = { $at }° is beyond its range, { $low } to { $high }°
verify_too_fast = J{ $joint } turns at { $speed }°/s, it can turn at { $most }°/s
verify_lit_by_joints = a move by joints with the laser on
verify_lit_to_unknown = a move from or to joint angles with the laser on: where it leads is known with a robot only
verify_ends_lit = the program ends with the laser on
verify_touches = { $what } with the laser on
verify_hits_facet = the beam to ({ $x }, { $y }, { $z }) hits facet { $facet } with the laser on

## What lines do
line_move = { $way } to { $goal }
line_output_on = output { $number } on
line_output_off = output { $number } off
line_group = group { $number } to { $value }
line_analogue = analogue output { $number } to { $value }
line_force = a force of { $force } N
line_wait = a wait of { $seconds } s
way_by_joints = a move by joints
way_straight = a straight move
goal_joints = the joint angles ({ $angles })
goal_flange = the flange pose { $pose }
goal_focus = the focus pose { $pose }
pace_seconds = { $seconds } s
pace_percent = { $percent } %
