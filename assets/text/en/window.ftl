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
menu_needs_robot = Choose a robot under Cell
command_with_step = { $name } { $step }

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
toolbar_pick_origin = Click where the origin should be · Esc ends
toolbar_lay_flat = Click the face to lay down · Esc ends
view_spiral_centre_here = Spiral centre here
view_only_with_spiral = For surfaces with the strategy spiral
view_offset_from_this_border = Offset from this border
view_only_with_offset = For surfaces with the strategy offset that have a border
view_border = border { $number } of { $count } of surface { $surface }, { $length_mm } mm long

## File dialogs
dialog_part_or_job = Part or job
dialog_part = Part
dialog_job = Job
dialog_program_folder = Folder for the program
dialog_dry_run_folder = Folder for the dry run
dialog_cell = Cell
dialog_head = Head
dialog_clamp = Clamp
dialog_scan = Scan
dialog_weld_gray = Grey image of the weld
dialog_weld_depth = Depth image of the weld
dialog_weld_camera = Camera that took both images
dialog_image = Image
dialog_camera = Camera
dialog_hand_eye = Hand-eye poses or result
dialog_grinding_tool = Grinding tool
dialog_robot = Robot
