### What is wrong with a cell file or a robot file, and how well frames fit what was measured.

## Cell and robot

cell_none_for = there is no shipped cell for robot { $robot }; give --cell
cell_obstacle = an obstacle of the cell: { $what }
robot_unknown = { $name } is neither a shipped robot ({ $shipped }) nor a robot file
robot_kinematics = give the kinematics once, as [opw] or as [ur]
robot_short = { $key } is { $value } mm long, and that of an arm at least { $least } mm; metres instead of mm?
robot_sign = signs has { $value }: give 1 or -1
robot_limits = limits_deg of J{ $joint }: { $low } to { $high } is no range of degrees
robot_speed = speeds_deg_s of J{ $joint } = { $value }: give { $low } to { $high }
robot_dialect = dialect = { $dialect }: no controller is known by that name; give one of { $known }
robot_mesh = { $key }: { $what }; name an STL file beside the robot file, or leave the key out: then a capsule stands for the link
robot_mesh_facets = the files of links.meshes have { $facets } facets together, and { $most } can be looked at: export the arm more coarsely, without bolts and insides
robot_mesh_off = { $key }: { $file } is { $off } mm off its joint: export it in the coordinates of the robot's base, with the joints at links.meshes.at_deg, and check its unit

## Where the robot stands

place_beyond_joint = { $key }: J{ $joint } = { $deg } is beyond { $low } to { $high } of { $robot }
place_high_table = bodies.table_z_mm = { $z }: the table stands as high as the robot's shoulder; lower it
place_laser_in_base = base_from_laser: the laser stands inside the robot's base, which is { $width } mm wide about axis 1; move it out

## Figures

figure_range = { $key } = { $value }: give { $low } to { $high }
figure_positive = { $key } = { $value }: give more than 0, up to { $high }
figure_not_finite = { $key } has { $value }: give finite numbers
figure_head_piece = bodies.head: from_mm = { $from }, to_mm = { $to }: give mm from the focus against the light, the lower first
figure_obstacle = bodies.obstacles: the place of { $file } has something that is not a finite number
figure_taken = { $key } = { $number }: { $by } has it already; give another

## Names, lines and templates of programs

name_identifier = { $key } = { $value }: give a letter, then letters, digits and _, at most { $longest } in all
name_capital_identifier = { $key } = { $value }: give a capital, then capitals, digits and _, at most { $longest } in all
name_capitals = { $key } = { $value }: give capitals, digits, - and _, at most { $longest } in all
program_line = { $key } has { $line }: give lines of ASCII, one each
form_version = { $key } = { $value }: give a line of ASCII that begins with //
form_termination = { $key } = { $value }: give FINE, or CNT0 to CNT100
form_configuration = { $key } = { $value }: give something like N U T, 0, 0, 0
form_unit = { $key } = { $value }: give letters, digits, - and _; it becomes a file name
form_longest_name = { $key } = { $value }: give 8 or 32
form_attributes = { $key } has { $value }: lines before NOP begin with ///
form_pulses = { $key } has { $value }: give 10 to 1000000, or -1000000 to -10
template_lacks = { $key } = { $template } has no { $name }
template_unknown = { $key } = { $template } has { $name }: give { $known }
template_touching = { $key } = { $template }: put something between the braces, or it cannot be read back
template_blank = { $key } is empty: give the words that end the force, or take both out
template_not_plain = { $key } = { $template }: give one line of ASCII

## Frames

frame_wrong = { $frame }: { $what }
frame_tip_poses = { $frame }: tip_poses tell where a tool's tip is; give three_points or points here
frame_range = { $key } { $value } is not from -{ $most } to { $most }
frame_keys = a frame is position_mm and rz_ry_rx_deg, or three_points, or points, or tip_poses and rz_ry_rx_deg
fit_figure = { $value } is not a number that can have been measured
fit_x_near_origin = three_points: x is { $off } mm from origin: measure x again, as far out as there is room
fit_xy_near_axis = three_points: xy is { $off } mm off the x axis: measure xy again, well beside the axis
fit_few_poses = tip_poses has { $count ->
    [one] { $count } pose
   *[other] { $count } poses
}: touch the same tip in at least four, turned about different directions
fit_one_direction = tip_poses turn the flange only about its direction ({ $x }, { $y }, { $z }), or hardly at all: measure again with poses tilted by 20 degrees and more to different sides
fit_no_tip = tip_poses: no tip fits: measure again
fit_few_pairs = points has { $count ->
    [one] { $count } pair
   *[other] { $count } pairs
}: measure at least three, better six
fit_model_on_line = points: the model points lie on one line within { $width } mm: measure another one, well beside it
fit_measured_on_line = points: the measured points lie on one line within { $width } mm: measure another one, well beside it
fit_no_frame = points: no frame fits: measure again
calibration = { $frame } from { $method }: { $rms } mm rms, { $worst } mm at worst
calibration_each = { $frame } from { $method }: { $rms } mm rms, { $worst } mm at worst ({ $each })
