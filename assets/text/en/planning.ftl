### Why there is no part and no plan.

stage_panicked = a fault in the program: { $words }
part_changed = the part's file is not the one that the job was made for
plan_no_surface = surface { $surface } does not exist: the part has surfaces 1 to { $last }; look at `clearbeam inspect`
plan_nothing_chosen = no surface is chosen; move at least one to the list to clean
plan_spacing_too_large = spacing = { $spacing } mm is larger than the part ({ $size } mm); give less, or the right --units
plan_spacing_too_small = spacing = { $spacing } mm would need about { $points } points on this part; give more, or the right --units
plan_part_too_large = the part is { $size } mm large; a facet far away, or the wrong --units? look at `clearbeam inspect`
from_pass_no_pass = there is no pass { $asked }: the plan has passes 0 to { $last }, by the number before their rows in path.csv
from_pass_without_passes = there is no pass { $asked }: the plan has none
from_pass_no_way = no way is found from home to pass { $pass } that keeps clear of everything; go on from another pass, or set air.entry_joints_deg in the cell file
plan_folds = surface { $surface } is too hollow for { $layers } layers or more: its facets would fold over; give fewer layers, or a smaller bead.height_mm
