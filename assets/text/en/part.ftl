### The part's file: what is wrong with it, what was found, what `inspect` prints.

## A file that cannot be used
stl_empty = the file is empty
stl_cut_off = the header promises { $promised } facets ({ $needed } bytes), but the file has { $present } bytes: it was cut off, or is not an STL file; export it again
stl_text_cut_off = the text ends inside a solid, after { $facets } facets (byte { $byte }): it was cut off; export it again
stl_not_stl = this is not an STL file: neither `solid` text nor a binary facet count is found
stl_no_facets = the file holds no facets; export the part again
stl_all_dropped = no usable facet: { $dropped ->
    [one] the only facet was dropped; it has { $first }
   *[other] all { $dropped } facets were dropped; the first one has { $first }
}

## What a facet has that makes it unusable
facet_nan = a NaN vertex
facet_infinite = an infinite vertex
facet_unreadable = a vertex that is not a number
facet_no_end = no endfacet
facet_not_three_vertices = more or fewer than three vertices
facet_no_area = no area

## Findings
part_implausible_size = a size of { $size } mm is implausible; in { $unit } it would be { $other } mm: use --units { $unit }
part_facets_dropped = { $count ->
    [one] 1 facet was dropped
   *[other] { $count } facets were dropped
}: { $list }
part_dropped_facet = facet { $facet } has { $fault } (byte { $byte })
part_more_dropped = and { $count } more
part_open_edges = { $count ->
    [one] 1 open edge: the surface is not closed there
   *[other] { $count } open edges: the surface is not closed there
}
part_non_manifold_edges = { $count ->
    [one] 1 edge has more than two facets; it counts as a crease
   *[other] { $count } edges have more than two facets; they count as creases
}
part_flipped_facets = { $count ->
    [one] 1 facet faced the other way and was flipped
   *[other] { $count } facets faced the other way and were flipped
}
part_duplicate_facets = { $count ->
    [one] 1 facet is a duplicate; planning skips it
   *[other] { $count } facets are duplicates; planning skips them
}
part_two_sided_facets = { $count ->
    [one] 1 facet is the other side of another
   *[other] { $count } facets are the other sides of others
}: a sheet has both its sides in the file, and each is a surface of its own
part_joined_corners = { $count ->
    [one] 1 corner was joined to another
   *[other] { $count } corners were joined to others
}, at most about { $within } mm away, to close open edges
part_degenerate_facets = { $count ->
    [one] 1 facet has no area; planning skips it
   *[other] { $count } facets have no area; planning skips them
}
part_bytes_passed_over = { $count ->
    [one] 1 byte behind the last facet was ignored
   *[other] { $count } bytes behind the last facet were ignored
}
part_solids_joined = the { $count } solids of the file were joined into one part

## What `inspect` prints
inspect_counts = { $facets ->
    [one] 1 facet
   *[other] { $facets } facets
}, { $vertices } vertices, { $edges } edges
inspect_watertight = { $shells ->
    [one] 1 shell
   *[other] { $shells } shells
}, watertight
inspect_open = { $shells ->
    [one] 1 shell
   *[other] { $shells } shells
}, not watertight
inspect_size = size { $size } mm, area { $area } mm²
inspect_volume = volume { $volume } mm³
inspect_surfaces = { $count ->
    [one] 1 feature surface
   *[other] { $count } feature surfaces
} at { $angle }°
inspect_column_surface = surface
inspect_column_facets = facets
inspect_column_area = area mm²
inspect_column_shape = shape

## Shapes
shape_plane = plane
shape_cylinder = cylinder
shape_cone = cone
shape_sphere = sphere
shape_freeform = freeform
shape_with_diameter = { $shape } Ø{ $diameter }
shape_with_angle = { $shape } { $angle }°
