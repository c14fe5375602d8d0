### The robot cell, its frames, and a better set-up.

## Cell

cell_panel_heading = Cell
cell_panel_robot = Robot
cell_panel_robot_tip = With a robot, reach, limits and time are known, and its motion can be watched
cell_panel_no_robot = None: poses only
cell_panel_robot_file = Robot file…
cell_panel_unverified = Some figures of this robot are not verified
cell_panel_unverified_tip = Check them in a robot file of your own:
cell_panel_carries = Carries
cell_panel_carries_tip = The part under a fixed laser, or the laser head over a fixed part
cell_panel_the_part = the part
cell_panel_carries_part = carries the part
cell_panel_the_head = the head
cell_panel_carries_head = carries the head
cell_panel_spin = Spin
cell_panel_spin_tip = Rotation about the beam: free, as suits the arm, or fixed to the direction of travel
cell_panel_spin_name = spin { $spin }
cell_panel_program_for = Program for
cell_panel_program_for_tip = The controller's language
cell_panel_words_unverified = No public source confirms these words and figures of it:
cell_panel_frames = Frames
cell_panel_frames_tip = Where laser, part and flange stand; connecting moves, outputs
cell_panel_cell_file = Cell file…
cell_panel_better_tip = Looks for a place of part and laser at which the robot reaches more of the work
cell_panel_better_running = The search is running
cell_panel_nothing_refused = The robot refuses no target
cell_panel_export = Export program…
cell_panel_export_from_pass = Export from pass { $pass } on…
cell_panel_export_tip = Writes program, path, report and job into a folder  { $keys }
cell_panel_not_planned = The plan is not finished

## Frames

frames_laser_in_base = Laser in the base
frames_laser_in_base_tip = Where the focus is in the robot's base; z points against the light
frames_reset_laser_in_base = reset laser in the base
frames_part_on_flange = Part on the flange
frames_part_on_flange_tip = How the part is held: its origin and axes on the flange
frames_reset_part_on_flange = reset part on the flange
frames_part_in_base = Part in the base
frames_part_in_base_tip = Where the part lies in the robot's base
frames_reset_part_in_base = reset part in the base
frames_head_on_flange = Head on the flange
frames_head_on_flange_tip = Where the focus is on the flange; z points with the light. It is set in the cell file
frames_pose = { $x } { $y } { $z } mm  RZ { $rz }° RY { $ry }° RX { $rx }°
frames_field = { $frame } { $axis }
frames_set_for_job = Set for this job, in place of the cell file's
frames_back =
    Back to the cell file's:
    { $pose }
frames_move_tip = Arrows and rings in the cell move and turn it, in steps of 0.5 mm and 1°
frames_move_not = Show the robot cell first
frames_three_points = measured by three points
frames_three_points_tip = Three points leave no residuals to judge them by
frames_measured = measured: rms { $rms } mm, worst { $worst } mm
frames_point_off = point { $number }: { $off } mm
frames_points_off = How far each point is off
frames_pose_off = pose { $number }: { $off } mm
frames_poses_off = How far each pose is off

## A better set-up

proposal_looking = Looking for a better set-up…
proposal_cancel_tip = Cancel is in the status line
proposal_none = No better set-up was found
proposal_worth = { $left } targets refused instead of { $refused } · { $after } % within reach instead of { $before } %
proposal_worth_tip = Refused targets are counted by planning with these frames; reach was checked for targets spread evenly over the work, shown as dots
proposal_shown = The cell is shown as it would stand
proposal_apply = Apply
proposal_apply_tip = Writes these frames into the job and plans again; Undo takes them back
proposal_dismiss = Dismiss
proposal_dismiss_tip = Esc
proposal_within_reach = within reach
proposal_out_of_reach = out of reach
cell_panel_page = Report as a page, too
cell_panel_page_tip = report.html: pictures, settings, what is proven, what is not done and why; to be read, printed and kept
frames_examples = Example frames: measure your own
frames_examples_tip = No cell file is given: these frames bring the sample into reach and are those of nobody's machine. Measure yours and put them in a cell file, or set them here, before any program is run
cell_panel_shipped_cell = the shipped cell of this robot
