### The report as a page for people.

page_title = Report: { $job }
page_about = Part { $part }, planned by clearbeam { $version }
page_dry_run = The program is a dry run: all outputs are off, and the speed is { $percent }%
page_from_pass = The program goes on from pass { $pass }
page_result = Result
page_not_done = What is not done, and why
page_all_done = Everything that was chosen is done
page_no_pictures = No pictures: { $why }
picture_not_packed = the picture cannot be packed: { $reason }
page_picture_surfaces = Surfaces to clean and the path
page_picture_top = From above

## Surfaces
page_surfaces = Surfaces and settings
page_surface = Surface
page_area = Area, mm²
page_power = Power, W
page_speed = Speed, mm/s
page_spot = Spot, mm
page_defocus = Defocus, mm
page_spacing = Spacing, mm
page_passes = Passes
page_worked = Worked, mm
page_corrected = Corrected, mm
page_blocked = Blocked, mm
page_missed = Missed, mm²

## Path and interference
page_path = Path
page_interference = Interference before and after correction
page_hits_along_normal = Targets whose beam along the normal hits something
page_targets_corrected = Targets corrected
page_targets_blocked = Targets blocked
page_targets_all = Targets in all
page_clearance = Least clearance of beam and head
page_mm = { $mm } mm
page_moves_proven = Moves with the laser on, proven to touch nothing
page_margin = Margin that is proven

## Dose, scan, time
page_dose = Dose
page_no_dose = Not computed for this report
page_scan = Scan
page_time = Time
page_time_whole = Program
page_time_work = Laser on
page_time_travel = Travel
page_time_waiting = Waiting

## What it rests on
page_assumed = Assumed
page_nothing_assumed = Nothing that nobody has measured or checked
page_frames_unmeasured = Frames of the shipped cell { $cell }, examples that nobody has measured here
page_words_unchecked = Words that were not tried on a real controller or robot
page_files = Files, with their SHA-256
page_read = read: { $file }
