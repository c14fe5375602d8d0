### Lines on surfaces.

## Why there are none, or not all
lines_spacing_not_positive = without a spacing greater than 0 there are no lines
lines_no_proper_facet = no facet has an area: leave the surface out
lines_no_plane_crosses = no section plane crosses it: choose another direction of the planes
lines_no_border = it is closed and has no border to keep a distance from: choose planes or a spiral
lines_no_such_border = there is no border { $border }: { $borders ->
    [one] the surface has one; choose it
   *[other] the surface has { $borders }; choose one of them
} or the whole outline
lines_none_fits = it is too small for a line: leave it out
lines_no_turn_fits = no turn of a spiral fits at a spacing of { $mm } mm: choose a smaller spacing or another strategy
lines_no_mean_normal = it has no mean normal to turn the second raster about: choose another strategy
lines_apart_from_border = { $area } mm² are not connected to the border: choose the whole outline
lines_beyond_spiral = the spiral does not reach { $area } mm²: choose another centre or another strategy

## Directions
direction_unknown = "{ $text }" is not a direction: give x, y, z, auto or three numbers DX,DY,DZ
direction_no_length = the direction { $text } has no length: give three numbers that are not all zero
