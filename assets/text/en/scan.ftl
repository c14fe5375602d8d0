### Where a scan lies on the model, and how far the part is off it.

## The file of a transform
transform_json = { $file }: line { $line }: { $reason }; give JSON with model_from_scan, sixteen numbers row by row, as register --json prints it
transform_matrix = { $file }: model_from_scan { $fault }
matrix_not_finite = has a number that is not finite
matrix_last_row = does not end with 0 0 0 1; write it row by row
matrix_scales = scales by { $factor }; give scan and part in the same unit first
matrix_shears = is no rotation: its rows are not at right angles, or have too few digits; give at least seven
matrix_mirrors = mirrors; turn the sign of one axis in the program it comes from

## Why a scan lies nowhere
register_no_model = the part has no facet with an area to lay the scan on
register_too_few_points = { $found } points take part, { $needed } are needed; leave out less, or scan again
register_pairs = { $pairs ->
    [one] one pair tells
   *[other] { $pairs } pairs tell
} no position: give three or more that are not on one line
register_not_same_part = this is not a scan of the part: at the best position its points are { $sigma } mm off (up to { $limit } mm would be its noise), and { $overlap } % of them lie on the part; give the right part, or three pairs of points if it is the right one
scan_unit_doubt = the scan's diagonal is { $cloud } mm, the part's { $part } mm: one of them is in another unit; { $advice }
scan_unit_cloud = the scan would fit in { $units }
scan_unit_part = the part would fit in { $units }
scan_unit_both = the scan would fit in { $cloud_units }, or the part in { $part_units }

scan_changed = { $file }: this is another scan than the job was made with; put the old file back, or take this one (in the window, or with --scan)
scan_matrix = transform in [scan] { $fault }
scan_gate_missing = { $depth } mm are missing at ({ $x }, { $y }, { $z }), more than the { $gate } mm that the job allows: check that this is the same part and that it lies right; if so, raise the limit
scan_gate_surplus = { $depth } mm too much at ({ $x }, { $y }, { $z }), more than the { $gate } mm that the job allows: check that this is the same part and that it lies right; if so, raise the limit
scan_layers = the bead is too low for what is missing: { $layers } layers would fill it, up to 1000 can be planned; give a higher bead

## How it lies
register_found = { $rms } mm rms, noise { $noise } mm; { $overlap } % of the points lie on the part, { $coverage } % of the part is scanned
register_slides = slides: nothing holds its { $motion } { $axis }; it stays as it was, so give pairs of points, or scan what holds it
register_weak = weakly held: { $motion } { $axis }, may be off by { $slack } mm
motion_turn = turn about
motion_shift = shift along
motion_screw = screw about
scan_axis = the axis ({ $x }, { $y }, { $z }) through ({ $px }, { $py }, { $pz })
register_rivals_same = { $rivals ->
    [one] one other position is
   *[other] { $rivals } other positions are
} the same, because the part is symmetric
register_rival = another position fits as well ({ $rms } mm rms)
register_rival_telling = another position fits as well ({ $rms } mm rms); they differ most around ({ $x }, { $y }, { $z }), by { $difference } mm
register_wear = worn places are left out; with them the fit would be off by { $moved } mm
register_placed = the part stands in the base by { $markers } markers, { $worst } mm off at most

## Markers
markers_too_few = { $count ->
    [0] no marker is shared
    [one] one marker is shared
   *[other] { $count } markers are shared
}: give three or more that are not on one line
markers_on_a_line = its markers are on one line, so the turn about it is open; add one beside the line
marker_no_number = marker { $marker } has a place that is no number

## How far the part is off
deviation_points = { $points } points on the part, { $rms } mm rms, mean { $mean } mm; { $off } points are none of it
deviation_unscanned = { $area } cm² of the part has no points; what is there is unknown
deviation_none = nothing is off by more than { $threshold } mm
deviation_missing = deepest { $depth } mm at ({ $x }, { $y }, { $z }): { $area } mm², { $volume } mm³ missing
deviation_surplus = highest { $depth } mm at ({ $x }, { $y }, { $z }): { $area } mm², { $volume } mm³ too much
deviation_layers = { $layers ->
    [one] one layer fills it,
   *[other] { $layers } layers fill it, the last one
} { $last } mm high
deviation_too_small = { $patches ->
    [one] one patch is
   *[other] { $patches } patches are
} too small for the density of the scan
scan_not_placed = nothing of the scan goes to the cell: where the scanner stands is not known, so give its frame, or markers that the robot has touched
scan_slack = the part may lie { $slack } mm off where it was scanned: head and arm, where they are known, keep { $slack } mm more than their margin
scan_no_surface = { $points } points tell no surface that facets could be laid through; scan more of the part
scan_too_wide = some of its points are far away from the rest, so that no surface can be laid through all of them: cut them off in the scanner's program first

## What goes on across a damage
scan_damage = damage { $number }: { $what }
continue_no_region = there is no region to continue
continue_too_few = the sound regions hold { $points } points, too few to tell a surface: make them larger
continue_other_kind = the sound regions are of no such surface: their points lie { $rms } mm off the best one; choose another kind, or smaller regions
continue_no_such_kind = the sound regions tell no such surface: choose another kind, or larger regions
continue_arc_too_short = the sound regions show too little of the arc (it rises by { $rise } mm): mark more of it
continue_axis_open = the sound regions leave the axis open by { $spread }°: mark a longer stretch along it
continue_gap = so far across the damage the surface is told to { $spread } mm only: mark sound regions on more sides of it

## Scans brought together by their overlap
overlap_found = { $file }: { $overlap } % of its points lie on the scans before it, { $rms } mm off them (rms)
overlap_too_few = { $found } points, { $needed } are needed to bring scans together
overlap_none = at the best position { $overlap } % of its points lie on the scans before it, or too much of it lies beside them: scan so that a third of its area is shared, or give markers
overlap_far = it fits the scans before it { $moved } mm and { $turned }° away from the position that was given, which is too far: give that better, or markers
overlap_ambiguous = it fits the scans before it in { $poses } positions: scan more of what they share, or give markers
