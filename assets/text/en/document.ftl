### What is saved: jobs, recipes, and the journal of unsaved changes.

## Jobs

job_part_gone = the part { $file } is not there; put it back, or correct `part.file` in the job
job_part_changed = the part { $file } has changed since the job was saved, so its surfaces may have other numbers; open the job in the window, or plan it: both say which surfaces were found again
job_beam_blocked = { $cell }: bodies.obstacles: { $obstacle } stands in the way of the beam, which does not move; move one of them
job_head_blocked = { $cell }: bodies.obstacles: { $obstacle } stands in the way of the head, which does not move; move one of them
job_changed_on_disk = { $file }: another window or program has changed it since it was opened here; save under another name, open it again, or overwrite it: the file as it is now becomes { $file }.bak
job_not_serialized = the job cannot be written: { $reason }
job_not_written = { $file }: cannot be written: { $reason }; choose another folder
job_not_removed = { $file }: cannot be removed: { $reason }; choose another folder

## Text of a job file

not_utf8 = is not UTF-8 text: { $reason }
job_file_later = version = { $version }: the job was made by a later clearbeam, and this one knows jobs up to version { $known }; open it with a newer clearbeam
job_file_no_version = version = { $version }: give { $known }, or leave the line out for a job of version 1
job_file_twice = { $key }: surface { $surface } is listed twice; name it once
job_file_no_number = { $key }: "{ $text }" is not a surface number; give a number like 4

## What single surfaces start from, and what they lose

start_whole = whole outline
start_border = border { $number }
dropped_border = the border of surface { $surface } was dropped
dropped_pins = { $pins ->
    [one] { $pins } pinned tilt of surface { $surface } was dropped
   *[other] { $pins } pinned tilts of surface { $surface } were dropped
}
dropped_pins_and_border = { $pins ->
    [one] { $pins } pinned tilt and the border of surface { $surface } were dropped
   *[other] { $pins } pinned tilts and the border of surface { $surface } were dropped
}

## The library of recipes

library_no_folder = no folder for recipes is known: set HOME
library_folder_not_made = { $folder }: cannot be made: { $reason }; choose another HOME
library_not_serialized = recipe "{ $name }": cannot be written: { $reason }
library_unknown = there is no recipe "{ $name }" among your own
library_not_renamed = { $file }: cannot be renamed: { $reason }; check who may write there
library_taken = recipe "{ $name }" cannot come back: another has taken its place; rename or remove that one first
library_broken = { $file }: { $why }; correct or remove the file
recipe_not_read = cannot be read: { $reason }
recipe_too_long = { $bytes } bytes are more than a recipe can have
recipe_no_name = the recipe has no name
recipe_name_taken = its name "{ $name }" is also that of { $other }

## The journal of unsaved changes

journal_no_folder = { $folder }: the journal of unsaved changes cannot be kept there: { $reason }; save often, and check the folder
journal_not_written = { $file }: unsaved changes cannot be kept there: { $reason }; save the job, then check the disk
journal_no_job = unsaved changes cannot be kept in the journal: { $what }
journal_bad_name = unsaved changes cannot be kept in the journal: { $reason }; save the job under a plain name
journal_unreadable = { $file }: was left behind by a program that ended early, and cannot be read: { $what }; look into it, then remove it
journal_no_owner = its first line does not say which job it belongs to
journal_bad_owner = first line: { $reason }
journal_damaged = it is not as it was written

## A job with all its files
package_archive = the package cannot be read: it is cut off or no package; copy it again
package_no_job = no package of a job
package_later = a later clearbeam wrote this package (schema { $schema }); take that one
package_name = the package has a file that would lie outside of its folder: { $name }; do not use it
package_too_large = the package holds more than { $most } MiB
package_occupied = it would be unpacked into { $folder }, where { $file } is another one: open the job there, or move that folder away
package_outside = it names { $file }, which lies outside of its folder; put that file beside it
package_unwritable = the package cannot be written: { $reason }
