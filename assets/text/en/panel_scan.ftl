### The scan of the part as it is: files, cleaning, where it lies, what is worn.

scan_panel = Scan
scan_panel_tells_worked = the scan tells what is worked: tick its patches
scan_panel_keeps_surfaces = not while there is a scan: where it has patches the part has other facets than its file

## Files

scan_panel_add = Add scan…
scan_panel_open_tip = Points of the part as it is (PLY, PCD, XYZ, TXT, CSV, PTS, PTX, E57 or STL)
scan_panel_shared = The files share a frame
scan_panel_overlap = Bring them together
scan_panel_overlap_tip = Each file is laid on those before it by the area that they share
scan_panel_own = Work from this scan alone
scan_panel_own_tip = The part is a scan, and there is no other model: lines go through its points, and what was not scanned is kept clear of
scan_panel_remove = Take this file out of the scan
scan_panel_units = Unit
scan_panel_units_name = scan in { $units }

## Cleaning

scan_panel_points = { $read } points read, { $left } left
scan_panel_clean = Clean:
scan_panel_add_outliers = + outliers
scan_panel_add_thinning = + thinning
scan_panel_add_smoothing = + smoothing
scan_panel_outliers = Outliers
scan_panel_thinning = Thinning
scan_panel_smoothing = Smoothing
scan_panel_cut_box = Cut by a box
scan_panel_cut_plane = Cut by a plane
scan_panel_erased = Erased
scan_panel_neighbours = neighbours
scan_panel_sigma = standard deviations
scan_panel_sigmas = σ
scan_panel_voxel = voxel
scan_panel_radius = radius
scan_panel_step_field = cleaning step { $step } { $what }
scan_panel_counts = { $before } → { $after }
scan_panel_remove_step = Take this step out
scan_panel_remove_step_name = take cleaning step { $step } out

## Where it lies

scan_panel_lies = On the model
scan_panel_given = The job gives the position
scan_panel_in_doubt = Look at the position before you keep it
scan_panel_keep = Keep this position
scan_panel_keep_tip = The position is saved with the job and no longer looked for
scan_panel_matrix = Position as numbers
scan_panel_take_matrix = Take this position
scan_panel_no_matrix = give the sixteen numbers of model_from_scan, row by row
scan_panel_look_again = Look for it again
scan_panel_look_again_tip = The job forgets the position, and it is looked for
scan_panel_take_rival = Take this one
scan_panel_take_rival_name = take position { $rival }

## What is worn

scan_panel_deviation = Off the model
scan_panel_work = Work on:
scan_panel_work_patches = what is missing
scan_panel_work_surfaces = the chosen surfaces
scan_panel_work_surfaces_tip = Where the scan found the part, and clear of what is too much on it
scan_panel_lines = Lines lie on:
scan_panel_lines_model = the model
scan_panel_lines_points = the points of the scan
scan_panel_lines_points_tip = Where planes tell the lines, they follow the part as it was scanned
scan_panel_missing = { $patch }: { $depth } mm deep, { $area } mm², { $volume } mm³
scan_panel_surplus = { $depth } mm too much, { $area } mm², { $volume } mm³
scan_panel_show = Show it
scan_panel_work_tip = Whether this patch is worked
scan_panel_work_name = work patch { $patch }
scan_panel_smaller = and { $count } that are smaller
scan_panel_patch_name = patch { $patch }

## Colours in the view

scan_panel_legend = Off the model, mm
scan_panel_scale = scale of the deviation
