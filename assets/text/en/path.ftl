### Lines on surfaces.

## Why there are none, or not all
lines_spacing_not_positive = a spacing of { $mm } mm gives no lines: choose one greater than 0
lines_no_proper_facet = surface { $surface } has no facet with an area: leave it out
lines_no_plane_crosses = no section plane crosses surface { $surface }: choose another direction of the planes
lines_no_border = surface { $surface } is closed and has no border to keep a distance from: choose planes or a spiral
lines_no_such_border = surface { $surface } has no border { $border }: { $borders ->
    [one] it has one; choose it
   *[other] it has { $borders }; choose one of them
} or the whole outline
lines_none_fits = surface { $surface } is too small for a line: leave it out
lines_no_turn_fits = no turn of a spiral fits on surface { $surface } at a spacing of { $mm } mm: choose a smaller spacing or another strategy
lines_no_mean_normal = surface { $surface } has no mean normal to turn the second raster about: choose another strategy
lines_apart_from_border = { $area } mm² of surface { $surface } are not connected to the border: choose the whole outline
lines_beyond_spiral = the spiral does not reach { $area } mm² of surface { $surface }: choose another centre or another strategy

## Directions
direction_unknown = "{ $text }" is not a direction: give x, y, z, auto or three numbers DX,DY,DZ
direction_no_length = the direction { $text } has no length: give three numbers that are not all zero
