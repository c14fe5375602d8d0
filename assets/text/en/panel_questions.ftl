### The empty window, questions, and small windows.

## Start

start_name = clearbeam
start_claim = Clean exactly the surfaces you choose
start_drop = Drop an STL here
start_open = Open…
start_steps = 1  open a part     2  move surfaces to the list to clean     3  export the program
start_tour = Guided tour
start_tour_tip = The first job, from the part to the program, on a sample: five minutes
start_picture = picture of { $file }

## Guided tour

tour_title = Guided tour
tour_step = Step { $step } of { $of }
tour_turn = This is a sample: a plate with a boss, a crater and holes. Drag in the view with the left mouse button to look at it from all sides; the wheel zooms.
tour_choose = Click the crater in the middle of the plate, and press Enter. It moves to the list *To clean*, and its path is planned at once.
tour_space = Under *Path*, set *Spacing* to another value, 1 mm say. Lines and plan follow.
tour_watch = Look at the plan: *Play* below the view, or the arrow keys, step through it. Dark blue is free, orange was tilted out of the way, red would hit something and stays off.
tour_robot = Under *Robot*, choose a robot. Now reach, limits and time are known, and *Robot cell* shows the arm.
tour_export = *Export program…* asks for a folder, and shows what will be written, what is not done, and what is assumed. Look at it, then export.
tour_done = That was the whole job. Before a real program runs with the laser on: measure your frames, export the dry run, and watch it. The manual says how.
tour_end = End the tour
tour_close = Close
start_samples = Samples
start_recent = Recent
start_no_folder = { $folder }: cannot be made: { $reason }

## Unsaved changes

ask_save = Save changes?
ask_save_before_close = The job has unsaved changes. Save them before closing?
ask_save_before_open = The job has unsaved changes. Save them before opening another part?
ask_save_yes = Save
ask_save_no = Don't save
ask_cancel = Cancel
ask_saving = saving…

## Errors and shortcuts

ask_error = Error
ask_close = Close
ask_shortcuts = Shortcuts
ask_view = View
ask_view_mouse = Left drag orbits, click selects · middle or right drag pans · Shift and left drag selects by a box · wheel zooms at the cursor
ask_view_mouse_cad = Middle drag orbits, with Ctrl or Shift it pans · right drag pans · left drag selects by a box, click selects · wheel zooms at the cursor
ask_view_mouse_blender = Middle drag orbits, with Shift it pans, with Ctrl it zooms · right drag pans · left drag selects by a box, click selects · wheel zooms at the cursor
ask_view_focus = Double click a surface to focus it, or the background to show all

## The part's file

ask_part_changed = The part's file has changed
ask_part_changed_file = { $file } is not the file that the job was made for.
ask_part_moved = Everything is there, but the whole part has moved. Use it only if that was intended.
ask_part_found = Everything that the job says about surfaces was found again.
ask_part_lost = Not everything that the job says about surfaces was found again. What is not found is dropped.
ask_part_undo = Nothing is saved by this, and it can be undone.
ask_part_use = Use the changed part
ask_part_other = Choose another file…
ask_part_gone = The part is not there
ask_part_gone_file = The job names { $file }. Has it been moved or renamed?

## Leftovers of a program that was killed

ask_restore = Unsaved changes were found
ask_restore_why = The program ended before these were saved.
ask_restore_not_saved = not saved yet
ask_restore_row = { $job } · last edit { $when }
ask_restore_yes = Restore
ask_restore_no = Discard
ask_restore_later = Not now
ask_when_now = just now ({ $time } UTC)
ask_when_minutes = { $count ->
    [one] { $count } minute ago ({ $time } UTC)
   *[other] { $count } minutes ago ({ $time } UTC)
}
ask_when_hours = { $count ->
    [one] { $count } hour ago ({ $time } UTC)
   *[other] { $count } hours ago ({ $time } UTC)
}
ask_when_days = { $count ->
    [one] { $count } day ago ({ $time } UTC)
   *[other] { $count } days ago ({ $time } UTC)
}

## Files in the way

ask_job_changed = The job file has changed
ask_job_changed_file = { $file } was changed by another program or window since it was opened here.
ask_job_exists = The file already exists
ask_job_exists_file = { $file } already exists.
ask_backup = Overwriting keeps the present file as a backup (.bak).
ask_save_as = Save as…
ask_overwrite = Overwrite
ask_reload = Reload
ask_export_other = Choose another folder…

## The page before an export
export_page_heading = Export program
export_page_dry_run = Export dry run
export_page_from_pass = Export from pass { $pass } on
export_page_folder = Folder
export_page_size = Size
export_page_time = Work and time
export_page_not_done = Not done
export_page_all_done = Everything on the list to clean is done
export_page_more = and { $count } more, in the list of problems
export_page_later = { $count ->
    [one] { $count } surface is put aside for another job
   *[other] { $count } surfaces are put aside for another job
}
export_page_assumed = Assumed
export_page_replaced = Replaced in the folder
export_page_nothing_replaced = Nothing: no file of these names is there
export_page_conflicts = These are not as an earlier export of this job left them:
export_page_row = • { $what }
export_page_folder_there = A folder stands in the way: choose another
export_page_export = Export
export_page_replace = Replace and export
