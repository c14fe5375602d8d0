### Names of the commands, as menus and buttons say them, and titles of the menus.

## Menus
menu_file = File
menu_edit = Edit
menu_surfaces = Surfaces
menu_part = Part
menu_view = View
menu_plan = Plan
menu_help = Help

## File
command_open = Open…
command_open_scan = Open scan…
command_open_weld = Open weld images…
command_save = Save job
command_save_as = Save job as…
command_export = Export program…
command_export_dry_run = Export dry run…
command_export_from_pass = Export from this pass on…

## Edit
command_undo = Undo
command_redo = Redo

## Surfaces
command_clean = Move to clean
command_unclean = Move back
command_clean_earlier = Clean earlier in the order
command_clean_later = Clean later in the order
command_select_all = Select all
command_select_same_shape = Select same shape
command_select_same_normal = Select same normal
command_select_neighbours = Select connected
command_select_larger = Select as large or larger
command_select_by_painting = Select by painting…
command_select_below = Select the next row
command_select_above = Select the row above
command_merge = Merge selected
command_split = Split by the local angle
command_rename = Rename…
command_flip_surface = Flip side of surface
command_flip_shell = Flip side of shell

## Part
command_pick_origin = Origin at a picked face, edge or hole…
command_lay_flat = Lay a picked face down…
command_measure = Measure…
command_turn_x = Turn 90° about x
command_turn_y = Turn 90° about y
command_turn_z = Turn 90° about z

## View
command_look_iso = Iso
command_look_front = Front
command_look_back = Back
command_look_left = Left
command_look_right = Right
command_look_top = Top
command_look_bottom = Bottom
command_fit = Fit
command_projection = Perspective or parallel
command_hide = Hide selected
command_isolate = Show only selected
command_show_all = Show all
command_path_lines = Path lines
command_pose_frames = Pose frames
command_beams = Beams
command_connecting_moves = Connecting moves
command_before_correction = Before correction
command_plain_part = Part without colours
command_hide_chosen = Hide surfaces to clean
command_section_plane = One section plane
command_cell = Robot cell
command_plots = Motion plots
command_program_text = Program text
command_tool_bodies = Head and clamps
command_access_map = Access map
command_dose = Dose
command_spacing = Achieved spacing
command_scan = Points of the scan
command_dropped_points = Points that cleaning took out
command_deviation_on_model = Deviation on the model
command_scan_section = Section of the scan
command_weld_images = Images of the weld
command_weld_points = Bead and camera
command_cut = Clipping plane
command_lists = Lists
command_settings = Settings
command_navigate_slicer = Mouse as in a slicer
command_navigate_cad = Mouse as in CAD
command_navigate_blender = Mouse as in Blender
command_theme = Dark, light or system theme
# What it goes over to, so that those who read only that can find it.
command_language = 中文 (Chinese)

## Plan
command_plan = Plan now
command_cancel = Cancel planning or search
command_better_setup = Find a better set-up
command_play = Play or pause
command_next_point = Next point
command_previous_point = Previous point
command_next_pass = Next pass
command_previous_pass = Previous pass
command_first_point = First point
command_last_point = Last point

## Help
command_palette = Find a command…
command_help = Shortcuts
command_escape = Step out

## What a toggle shows
about_path_lines = The lines that the spot follows
about_pose_frames = The frames of the targets of the current pass, and a few of the others
about_beams = The beams at the targets of the current pass, and a few of the others
about_connecting_moves = The moves between lines, with the laser off
about_before_correction = The beams as they would stand without correction
about_plain_part = The part in one colour
about_hide_chosen = Everything but the surfaces to clean
about_section_plane = The section plane of the current pass alone, seen along its lines
about_cell = Robot, head and part as they stand in the cell
about_plots = Joints, speeds and clearance over time
about_program_text = The program, line by line, as it is exported
about_tool_bodies = The head, the beam and the clamps
about_access_map = From which directions the current place can be reached
about_dose = The energy that lands, what stays unclean, and what is hit beside
about_spacing = How far neighbouring lines really are apart
about_scan = The points of the scan, coloured by how far they are off the model
about_dropped_points = The points that cleaning took out of the scan
about_deviation_on_model = The model, coloured by how far the scan is off it
about_scan_section = A section through part and scan, below the view
about_weld_images = The images of the weld with its mask, in a window
about_weld_points = The bead by its height, its centre line and the camera
about_cut = The part cut open, to see and pick what is inside
about_lists = The feature surfaces, and those to clean
about_settings = The settings of the job, its problems and the export

## Finding a command
palette_hint = Type what you are looking for
palette_row = command { $command }
