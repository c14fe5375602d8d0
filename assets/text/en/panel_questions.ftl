### The empty window, questions, and small windows.

## Start

start_name = clearbeam
start_claim = Clean exactly the surfaces you choose
start_drop = Drop an STL here
start_open = Open…
start_steps = 1  open a part     2  move surfaces to the list to clean     3  export the program
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
ask_view_mouse = Left drag orbits, click selects · middle or right drag pans · wheel zooms at the cursor
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
ask_export_over = Nothing was written
ask_export_over_folder = { $folder } contains files that this export must not replace:
ask_export_over_file = • { $conflict }
ask_export_other = Choose another folder…
