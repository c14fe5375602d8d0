### Names of choices. The words that files and the command line take are no text.

## Strategies

choice_planes = planes
choice_adaptive = adaptive
choice_offset = offset
choice_spiral = spiral
choice_cross = cross
choice_planes_hint = parallel planes, equally far apart
choice_adaptive_hint = planes, closer together on slopes
choice_offset_hint = lines that follow the border
choice_spiral_hint = one line, the laser stays on
choice_cross_hint = two rasters across each other

## Lines

choice_direction_auto = auto
choice_zigzag = zigzag
choice_one_way = one-way
choice_shortest = shortest
choice_inwards = inwards
choice_outwards = outwards

## Beam

choice_correction_none = none
choice_correction_section_plane = section-plane
choice_correction_clearance = clearance
choice_gaussian = gaussian
choice_top_hat = top-hat
choice_line = line

## Part and cell

choice_mm = mm
choice_m = m
choice_inch = inch
choice_weld_auto = a rounding apart
choice_weld_auto_about = Corners of open edges that are a rounding apart become one where that closes edges
choice_weld_exact = equal only
choice_weld_exact_about = Only corners with equal coordinates become one
choice_spin_free = free
choice_spin_travel = travel
