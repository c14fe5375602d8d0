### The command line.

## Help. Options of `plan` that set parameters are told in the table of parameters.
cli_about = Plans robot laser cleaning of chosen surfaces of a part: from a part file (STL, OBJ, PLY, 3MF) to a robot program
cli_file = Part or job to open in the window
cli_lang = Language of messages and help
cli_json = Print JSON
cli_inspect = Say what a part file holds: topology, faults, feature surfaces
cli_inspect_part = The part
cli_inspect_angle = Crease angle, degrees
cli_inspect_units = Unit of the file: mm, m or inch [default: what the file states, else mm]
cli_inspect_weld = Corners that become one: auto (equal ones; to close open edges also those a rounding apart) or exact (equal ones alone)
cli_plan = Plan a job and write job, program, report and path into a folder
cli_plan_input = Part or job; several are planned one after the other, each into a folder of its own in --out
cli_plan_out = Folder for the files of the plan
cli_plan_scan = Scan of the part as it is: it is laid on the part, and patches where more than --min-depth is missing are planned; several are scans of parts alike, each planned into a folder of its own
cli_plan_jobs = How many plans of a row are made at once
cli_row_failed = not all of the row was planned; the lines say which
cli_row_same_name = two plans of the row would be written to the folder { $name }: give jobs or scans other names
cli_plan_dose = Compute the dose and write dose.ply; a job with a threshold of [dose] has it without this
cli_plan_report = Write the report as a page for people too (report.html)
cli_plan_dry_run = Write the dry run in place of the program: the same motion at { $percent } % of its speed, every output off, names of its own
cli_plan_from_pass = Write the program from pass N on, as path.csv counts them from 0, to go on after a stop; names of its own
cli_plan_overwrite = Replace files in the folder that were changed by hand, belong to another job, or were not exported
cli_plan_json = Print the report as JSON
cli_verify = Read a program back and compare it with the plan of its job
cli_verify_program = Program file; sub-programs are looked for in its folder
cli_verify_job = Job that the program was made from
cli_verify_json = Print the findings as JSON
cli_render = Draw a part, or a planned job, into a picture
cli_render_input = Part, or job to plan first
cli_render_out = Picture to write
cli_render_size = Size in pixels
cli_render_view = iso, front, back, left, right, top or bottom
cli_register = Find where a scan lies on its part
cli_register_scans = Scan: PLY, PCD, XYZ, TXT, CSV, PTS, PTX, E57 or a mesh; several are brought into the frame of the first by --markers
cli_register_nominal = Scan of a sound part to lay it on, in place of --part: a surface is laid through its points
cli_register_part = Part that was scanned
cli_register_markers = File of [[marker]] with name, scan_mm, base_mm: where the robot touched what the scan shows
cli_register_transform = Start from the model_from_scan of this file, in place of any position
cli_deviation = Compare a scan with its part: how far the part is off, and where that is wear
cli_deviation_scan = Scan: PLY, PCD, XYZ, TXT, CSV, PTS, PTX, E57 or a mesh
cli_deviation_out = PLY to write: the points on the part, with deviation_mm (above 0 outside) and depth_mm (smoothed, above 0 where material is missing)
cli_deviation_min_depth = What is missing, or too much, by more than this is a patch
cli_deviation_transform = Take model_from_scan from this file, in place of looking for it
cli_render_color = What the colours show: surface, dose or incidence

## Values that are refused
cli_not_a_color = "{ $text }": give surface, dose or incidence
cli_not_a_size = "{ $text }": give WxH, 16 to 8192 pixels each
cli_not_a_view = "{ $text }": give one of { $views }

## Failures
cli_markers_of = { $file }: { $scan }: { $what }
cli_no_json = the result cannot be written as JSON: { $reason }
cli_no_path = { $file }: its full path cannot be found: { $reason }
cli_not_planned = { $job }: cannot be planned: { $reason }
cli_part_changed = the part { $file } has changed since the job was saved, and what the job says cannot be carried over completely: { $told }; open the job in the window to see it and to choose again
cli_help_overwrite = { $why }; give --overwrite to replace them, or choose another folder
cli_help_other_folder = { $why }; choose another folder

## What is printed
cli_part_carried_over = { $file }: has changed since the job was saved; { $told }
cli_speaks_own_dialect = the { $robot } uses { $own }: give --dialect { $own }
cli_times = { $work } of work, { $travel } of travel, { $waiting } of waiting
cli_to_help = to help: { $advice }
cli_better_setup = a better set-up, with this in the job's [cell]: { $left ->
    [one] 1 target refused
   *[other] { $left } targets refused
} instead of { $before }
cli_removed = removed { $file }
cli_wrote = wrote { $file }

## What `verify` prints
verify_dry_run = named as a dry run, and compared with that: every output off, slower
verify_from_pass = named as the program from pass { $pass } on, and compared with that: the passes before it are not looked at
verify_unreadable = { $dialect }: not compared with the plan, as it cannot be read
verify_moves = { $dialect }: { $moves ->
    [one] 1 move
   *[other] { $moves } moves
}, { $lit } with the laser on
verify_furthest = furthest from the plan: { $mm } mm, { $deg }° at the spot
verify_inputs_unknown = no report.json with this program says which files it was made from, so nobody knows whether cell, robot, head and clamps are still those; give the program or its job in the folder of the export
verify_finding = { $file }:{ $line }: { $what }
verify_more = and { $count } more
verify_count = { $count ->
    [0] nothing found
    [one] 1 finding
   *[other] { $count } findings
}
cli_weld = Find a weld in a grey image and a depth image, measure it, and plan how it is ground
cli_weld_gray = Grey image: PNG, TIFF or JPEG
cli_weld_depth = Depth image of the same size: 16-bit PNG, PGM or TIFF, or a float TIFF
cli_weld_camera = Camera that took both: fx, fy, cx, cy, s, k1, k2, p1, p2, k3 in TOML, or Open3D's intrinsics
cli_weld_part = Part that the weld is on; without it the skin around the weld is the part, in the camera's frame
cli_weld_hand_eye = Where the camera stood: robot poses with target poses, or the result
cli_weld_tool = Grinding tool; without it a disc of 30 mm radius
cli_weld_pass_depth = What one pass takes off
cli_weld_residual = Height at which grinding stops
cli_weld_strategy = one-way, zigzag, spiral or along; without it beads are ground along their centre line, areas without height by a spiral
cli_weld_json = Print what was measured as JSON
give_grinding_strategy = give one-way, zigzag, spiral or along
