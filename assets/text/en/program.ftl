### Why a program cannot be written or read, and what of it is not as it was wanted.

## Writing

write_no_robot = a { $dialect } program needs a robot; give --robot
write_off_is_on = { $dialect }.output_off is the same as { $dialect }.output_on; the laser would stay on
write_no_template = { $dialect }.{ $key } is empty, and one of the cell's outputs needs it; give the controller's line with { "{n}" } and { "{v}" }
write_timed_joint_move = { $dialect }: a move by joints has no duration; give its speed in per cent
write_straight_in_percent = { $dialect }: a straight move has no speed in per cent; give its duration
write_from_unknown_pose = { $dialect }: a straight move from home has a speed only with a robot; give --robot
write_home_needs_pulses = yaskawa: home is known by its joints only; give --robot, or pulses_per_deg in the cell file
write_piece_too_long = a lit piece needs { $lines } lines, and only fanuc.max_lines = { $most } go into one program; a call in the middle would let the spot stand: plan with fewer targets (--chord-error, --max-step, --max-turn)
write_program_numbers = nachi.number = { $number }: { $pages } sub-programs would go up to { $last }, and 999 is the last; give a lower number, or raise nachi.max_moves
write_too_many_positions = yaskawa: more than 100 000 positions without a pause of the laser; space the targets out

## Reading

read_at_line = { $file }, line { $line }: { $what }
read_gone = { $file }, line { $line }: calls { $called }, which is not in the same folder
read_cut_off = { $file }: ends without { $expected }; it was cut off
read_expected = "{ $found }" is not understood; expected { $expected }
read_one_more = { $first } or { $last }
read_numbers = "{ $found }": give { $count ->
    [1] a number
    [3] three numbers
    [4] four numbers
    [6] six numbers
   *[other] { $count } numbers
}
read_not_above_zero = "{ $found }": give a number above 0
read_quaternion = the quaternion has a length of { $length }; it has to be 1
read_behind_end = stands behind { $end }; take it out
read_not_as_in_cell = not as in the cell file: expected { $expected }
read_before = { $missing } has to stand before it
read_twice = { $name } stands there twice
read_undefined = there is no { $name }
read_never_called = { $name } is never called
read_circle = calls { $called } in a circle, or too deep; call each program once
read_nested_call = a sub-program calls none itself
read_bad_call = calls "{ $called }", which is no number of a program
read_outside_function = stands outside the program's function
read_count = { $of } promises { $promised }, and { $found } are there
read_count_missing = { $of } promises nothing, and { $found } are there
read_out_of_order = "{ $found }" stands where { $expected } should: a line is missing or out of order
read_no_motion_group = no DEFAULT_GROUP says which axes the program moves
read_other_motion_group = "{ $found }": a second group of axes; programs here move one arm, so give one of a single group
read_flange_speed = "{ $found }" is the flange's speed, which says nothing of the spot's; give the move its time: { $expected }
read_arc = "{ $found }": an arc cannot be checked here; give straight moves
read_no_duration = a straight move to joint angles: its duration is known only with a robot
read_from_nowhere = a straight move before any position; expected a move by joints
read_goes_on_straight = goes to joint angles, and { $file }, line { $line } goes straight on, whose duration is known only with a robot; expected a pose here, or a move by joints there
read_no_pulses_per_degree = pulses; give yaskawa.pulses_per_deg in the cell file
read_other_columns = other columns than this format's
read_unused_cells = "{ $what }" has cells filled that it does not use
read_focus_without_flange = a focus without its flange
read_no_robot_to_compare = joints and a flange, and no robot to compare them by
read_no_goal = neither joints nor a pose
read_no_timing = give seconds or percent, one of them
read_disagree = { $first } and { $second } differ by { $mm } mm and { $deg }°

## What is not as it was wanted

shortfall_leads = { $count ->
    [one] 1 lead-in or lead-out is left out: something would be touched on it
   *[other] { $count } lead-ins and lead-outs are left out: something would be touched on them
}
shortfall_short_moves = { $moves ->
    [one] 1 lit move takes { $shortest } ms, less than { $least } ms
   *[other] { $moves } lit moves take less than { $least } ms, the shortest { $shortest } ms
}, because of chord error, turn, or deviation of the spot; the controller may be slower there
shortfall_power = its power of { $value } W has to be set by hand where the program says so: give the cell outputs.power
shortfall_frequency = its frequency of { $value } kHz has to be set by hand where the program says so: give the cell outputs.frequency
