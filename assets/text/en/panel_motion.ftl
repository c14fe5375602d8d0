### The plan over time: stepping, the time strip, curves, and the program's text.

## Stepping

timeline_nothing_chosen = Move a surface to the list to clean: its path appears here
timeline_no_plan = There is no plan: see the problems
timeline_stopped = Planning was stopped; { $keys } plans again
timeline_planning_at = The plan is being made: { $activity }, { $percent } %
timeline_planning = The plan is being made
timeline_no_line = No line crosses the chosen surfaces
timeline_times = { $now } / { $total }
timeline_times_tip = Hours, minutes, seconds
timeline_work = work
timeline_travel = travel
timeline_waiting = waiting
timeline_left_out = { $count } left out
timeline_play = ▶ Play
timeline_pause = Pause
timeline_speed_prefix = { "× " }
timeline_speed_tip = Multiple of the real speed
timeline_speed_name = play speed
timeline_loop = loop
timeline_pass = Pass
timeline_pass_name = pass
timeline_point = Point
timeline_point_name = point

## Target

timeline_free = free
timeline_corrected = corrected
timeline_blocked = blocked
timeline_place = pass { $pass } · point { $point }
timeline_laser_on = laser on
timeline_laser_off = laser off
timeline_grinding = grinding
timeline_not_grinding = not grinding
timeline_tilt = tilt { $angle }°
timeline_xyz = x { $x }  y { $y }  z { $z }
timeline_flange = flange { $x } { $y } { $z } mm  RZ { $rz }° RY { $ry }° RX { $rx }°
timeline_flange_tip = Pose of the flange in the robot's base

## Time strip

scrub_name = time
scrub_mark =
    { $count ->
        [one] pass { $pass } · point { $point }: { $cause }
       *[other] { $count } targets from pass { $pass } · point { $point }: { $cause }
    }
    Click to go there

## Curves

plots_seconds = { $value } s
plots_joint = J{ $joint }
plots_joints_name = curves of joints
plots_joints = Joints, ° · nearest limit { $margin }°
plots_speeds_name = curves of joint speeds
plots_speeds = Joint speed, % of full · most { $percent } % { $joint }
plots_angles_name = curves of the flange's angles
plots_angles = Flange in the base, °
plots_singularity_name = curve of the distance to singularity
plots_singularity = To singularity · least { $distance }
plots_distance = distance
plots_clearance_name = curve of the clearance
plots_clearance_none = Clearance, mm · …
plots_clearance_beyond = Clearance, mm · all beyond { $reach } mm
plots_clearance = Clearance, mm · least { $least } { $pair }
plots_nearest = nearest
plots_or_more = or more

## Program text

program_panel_heading = Program
program_panel_out_of_date = Program: out of date
program_panel_files = { $count ->
    [one] { $count } file
   *[other] { $count } files
}
program_panel_none = There is no program to show

## Going on after a stop
going_on_tip = Passes before pass { $pass } count as done; what is left becomes a program of its own
going_on_no_pass = No line was planned on this surface
going_on_chip = From pass { $pass } on ×
going_on_chip_tip = Passes before pass { $pass } count as done, and exports begin with it. Click to take all passes again.
