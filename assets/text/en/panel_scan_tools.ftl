### The hand on a scan: pairs, places left out, cuts, labels, figures, the section, and where the scanner stands.

scan_tool_radius = radius of the brush
scan_tool_radius_prefix = radius{ " " }

## Pairs

scan_pairs_pick = Pick pairs
scan_pairs_of_job = laid by { $count } pairs
scan_pairs_forget = Forget the pairs
scan_pairs_forget_tip = The position is looked for from anywhere again
scan_pairs_hint = Click a point of the scan, then the same place on the model
scan_pairs_hint_model = Now click the same place on the model
scan_pairs_hint_scan = Now click the same point on the scan
scan_pairs_lay = { $count ->
    [one] Lay by this pair
   *[other] Lay by these { $count } pairs
}
scan_pairs_too_few = Pick three pairs at least, not on one line
scan_pairs_remove = Take this pair out
scan_pairs_remove_name = take pair { $pair } out
scan_pairs_row = Pair { $pair }: { $off } mm off
scan_pairs_row_open = Pair { $pair }
scan_pairs_off_laid = how far each is off where the scan lies
scan_pairs_off_themselves = how far each is off if the pairs alone lay the scan

## Places that do not count

scan_leave_out = Leave places out
scan_leave_out_count = { $count ->
    [one] 1 place does not count
   *[other] { $count } places do not count
}
scan_leave_out_clear = All count again
scan_leave_out_clear_tip = Nothing of the model is left out when the scan is laid
scan_leave_out_brush = Brush
scan_leave_out_rubber = Rubber
scan_leave_out_corners = Box
scan_leave_out_hint_brush = Paint over what should not count (left drag; Ctrl + drag turns the view)
scan_leave_out_hint_rubber = Rub off what should count again (left drag; Ctrl + drag turns the view)
scan_leave_out_hint_corner = Click one corner of the box on the model
scan_leave_out_hint_other_corner = Click the opposite corner
scan_leave_out_selected = Box around the selected surfaces
scan_leave_out_selected_tip = A box along the axes around them, wider by the radius on all sides
scan_leave_out_legend = does not count

## Cuts

scan_cut = Cut:
scan_cut_name = cut by { $what }
scan_cut_by_box = box
scan_cut_by_plane = plane
scan_cut_by_brush = brush
scan_cut_hint_box = Click two opposite corners on the scan, or type them
scan_cut_hint_other_corner = Click the opposite corner
scan_cut_hint_plane = Click a point that the plane goes through, or three: then what lies on the part's side stays
scan_cut_hint_brush = Paint over points to take them out (left drag; Ctrl + drag turns the view)
scan_cut_from = from
scan_cut_to = to
scan_cut_corner = box { $corner } { $axis }
scan_cut_keep_inside = Keep what is inside
scan_cut_keep_outside = Keep what is outside
scan_cut_across = Across
scan_cut_across_name = plane across { $axis }
scan_cut_flip = Other side
scan_cut_flip_tip = Keeps what is on the other side of the plane
scan_cut_shift = shift of the plane
scan_cut_shift_prefix = shift{ " " }
scan_cut_brush_anew = Start anew
scan_cut_dropped = takes { $dropped } of { $of } points out
scan_cut_add = Add this step
scan_cut_add_not = It would take out no point, or all of them
scan_cut_cancel = Cancel

## Labels

scan_labels = Set labels
scan_labels_hint = Click a point to read how far it is off the model
scan_labels_clear = Remove all
scan_labels_remove = Remove this label
scan_labels_remove_name = remove label { $label }
scan_labels_row = { $label }: { $off } mm at ({ $x }, { $y }, { $z })
scan_labels_mark = { $off } mm

## Figures

scan_figures = Figures
scan_figures_convergence = Fit: { $last } mm rms after { $steps } steps
scan_figures_convergence_name = plot of the fit
scan_figures_left_over = Left over, mm (dashed: noise, ±{ $noise } mm)
scan_figures_left_over_name = histogram of what is left over
scan_figures_deviation = Off the model, mm (dashed: patches from { $least }, tolerance { $tolerance } mm)
scan_figures_deviation_name = histogram of the deviation

## Section

scan_section = Section across
scan_section_across = section across { $axis }
scan_section_place = place of the section
scan_section_place_tip = Or click a place on the part
scan_section_times = Drawn larger
scan_section_times_name = how much larger the deviation is drawn
scan_section_ruler = 0.1 mm off the model is drawn as { $mm } mm
scan_section_axis = { $axis }, mm
scan_section_name = section of part and scan

## Where the scanner stands

scan_placing = In the cell
scan_placing_part_in_hand = The robot carries the part: this is where the scanner stands as seen from the flange
scan_placing_by_frame = Type the scanner's frame
scan_placing_by_markers = Markers
scan_placing_forget = Forget where it stands
scan_placing_frame = scanner in the base
scan_placing_frame_tip = Where the frame of the scan stands in the robot's base
scan_placing_frame_on_flange = scanner on the flange
scan_placing_frame_on_flange_tip = Where the frame of the scan stands as seen from the flange that holds the part
scan_placing_on_flange = as seen from the flange
scan_placing_marker = Marker { $marker }
scan_placing_marker_off = Marker { $marker }: { $off } mm off
scan_placing_in_scan = in the scan
scan_placing_in_base = in the robot's base, as touched
scan_placing_field = marker { $marker } { $frame } { $axis }
scan_placing_add = Add a marker
scan_placing_remove = remove marker { $marker }

## Damage across which the surface goes on
scan_continue = Without a model: continue across the damage
scan_continue_hint = The damage is what you left out. Select the surface around it, then choose what it is
scan_continue_tip = The selected surface goes on across what you left out, and what is missing from it is wear
scan_continue_plane = Plane
scan_continue_cylinder = Cylinder
scan_continue_revolved = Turned
scan_continue_extruded = Drawn along a line
scan_continue_smooth = Smooth
scan_continue_found = { $number }: { $kind }, { $rms } mm off the sound points (rms), { $gap } mm across, told to { $spread } mm
scan_continue_remove = The surface does not go on across this damage
