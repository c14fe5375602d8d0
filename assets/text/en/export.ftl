### Why a plan was not exported.

export_conflicts = { $folder }: nothing was written: { $list }
export_busy = { $folder }: another export into this folder is under way; wait for it, or choose another folder
export_name = the program would be written as "{ $name }", which is not a file name of its own within the folder; give another in the cell file
export_unwritable = the program cannot be written: { $reason }
export_unreadable = the program cannot be read back: { $reason }
export_not_the_plan = the program, read back, is not the plan: { $file }:{ $line }: { $what } ({ $findings ->
    [one] 1 finding
   *[other] { $findings } findings
}); nothing was written
export_dose = the dose cannot be computed: { $reason }

## Files in the way
conflict_changed_by_hand = { $name } was changed by hand since it was exported
conflict_other_job = { $name } belongs to the job { $job } on { $part }
conflict_no_exports = { $name } was not exported from here
conflict_earlier_version = { $name } was exported by an earlier version, which did not list its files
conflict_folder = { $name } is a folder
