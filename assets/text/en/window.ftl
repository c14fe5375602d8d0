### The window's own words: title, status line, view, file dialogs.

## Title
window_title = { $name } – clearbeam
window_title_unsaved = ● { $name } – clearbeam
window_title_empty = clearbeam

## What was done last
window_reading = reading { $file }…
window_restoring = restoring { $part }…
window_facets_read = { $count ->
    [one] { $count } facet read
   *[other] { $count } facets read
}
window_saved = saved { $file }
window_writing_into = writing into { $folder }…
window_packing = packing job and files into { $file }
window_packed = packed the job with all its files into { $file }
window_exported = exported { $program }
window_export_cancelled = the export was cancelled
window_part_being_built = the part is being rebuilt; change the crease angle once it is there

## What does not work
window_no_finished_plan = there is no finished plan for the job as it is; wait for it, or see what is wrong
window_planning_cancelled = planning was cancelled; Ctrl+R plans again
window_part_of_another_state = the part's file is not the one that this state of the job was made for; redo, or open the job again
window_fault = { $error }; the job is untouched: save it, and Ctrl+R tries again
window_not_opened = the window cannot be opened: { $reason }; without a screen use `clearbeam plan`, or run under xvfb-run

## Menu bar
menu_needs_robot = Choose a robot first, under Robot
menu_panels = Panels ▼
menu_panels_tip = What stands beside the view
command_with_step = { $name } { $step }

## Why a command cannot be given
why_not_part = Open a part first
why_not_plan = Nothing is planned yet: move a surface to the list to clean
why_not_selected = Select a surface first
why_not_one_selected = Select exactly one surface
why_not_two_selected = Select two surfaces or more
why_not_left = The selected surfaces are on the list to clean already
why_not_listed = Select a surface on the list to clean
why_not_undo = Nothing to undo
why_not_redo = Nothing to redo
why_not_idle = Nothing is being computed
why_not_scan = Add a scan of the part first, under Part
why_not_weld = Open the images of a weld first

## Status line
status_cancel = Cancel
status_size = { $passes ->
    [one] { $passes } pass
   *[other] { $passes } passes
} · { $targets ->
    [one] { $targets } target
   *[other] { $targets } targets
}
status_corrected = { $count } corrected
status_work = { $length_mm } mm · { $time }
status_out_of_date = out of date
status_out_of_date_tip = Ctrl+R plans again
status_proven = { $moves ->
    [one] On { $moves } move with the laser on nothing can be touched
   *[other] On { $moves } moves with the laser on nothing can be touched
}
status_proven_by = { $moves ->
    [one] On { $moves } move with the laser on nothing can be touched, by { $margin_mm } mm
   *[other] On { $moves } moves with the laser on nothing can be touched, by { $margin_mm } mm
}
status_with_clearance = { $line }, least clearance { $clearance_mm } mm

## View
toolbar_show = Show ▼
toolbar_show_tip = What the view shows
toolbar_cut_axis = cut across { $axis }
toolbar_cut_place = where the part is cut
toolbar_cut_other = Other side
toolbar_pick_origin = Click where the origin should be · Esc ends
toolbar_lay_flat = Click the face to lay down · Esc ends
toolbar_measure = Click two places to measure between them · Esc ends
toolbar_paint = Paint over surfaces to select them · Ctrl drags the view · Esc ends
toolbar_put_clamp = Click where the clamp stands · Esc ends
measure_place = surface { $surface } { $label }  x { $x }  y { $y }  z { $z }
measure_distance = { $mm } mm apart  Δx { $x }  Δy { $y }  Δz { $z }
measure_parallel = parallel, { $mm } mm apart
measure_angle = angle { $angle }°
theme_dark = Dark theme
theme_light = Light theme
theme_system = Theme of the system
view_spiral_centre_here = Spiral centre here
view_only_with_spiral = For surfaces with the strategy spiral
view_offset_from_this_border = Offset from this border
view_only_with_offset = For surfaces with the strategy offset that have a border
view_border = border { $number } of { $count } of surface { $surface }, { $length_mm } mm long
legend_laser_off = laser off
legend_tip = Click to show or hide
legend_entry = lines: { $what }

## File dialogs
dialog_part_or_job = Open a part or a job
dialog_part = Choose a part
dialog_job = Save the job
dialog_program_folder = Choose a folder for the program
dialog_dry_run_folder = Choose a folder for the dry run
dialog_cell = Choose a cell file
dialog_head = Choose a laser head
dialog_save_head = Save the laser head
dialog_clamp = Choose the facets of a clamp
dialog_scan = Choose a scan
dialog_weld_gray = Choose the grey image of the weld
dialog_weld_depth = Choose its depth image
dialog_weld_camera = Choose the camera that took both images
dialog_hand_eye = Choose hand-eye poses or their result
dialog_grinding_tool = Choose a grinding tool
dialog_robot = Choose a robot file
browser_up = Folder above
browser_path = path
browser_name = Name
browser_empty = Nothing here that can be opened
browser_all = Show all files
browser_all_tip = Otherwise only these: { $endings }
browser_size = { $kilobytes } kB
browser_not_there = { $path } does not exist
browser_new_folder = New folder…
browser_new_folder_name = name of the new folder
browser_make = Make it
browser_replaces = { $name } exists already
browser_replace = Replace
browser_open = Open
browser_save = Save
browser_choose = Choose this folder
browser_choose_file = Choose a file
