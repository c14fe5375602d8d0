### The part's file: what is wrong with it, what was found, what `inspect` prints.

## A file that cannot be used
part_file_empty = the file is empty
part_file_folder = { $file } is a folder: name the part's file in it
part_file_lfs = this is a Git LFS pointer, not the part: fetch the file itself (git lfs pull)
part_file_packed = this is a { $kind } archive: unpack it and open the part in it
part_file_web_page = this is a web page, not the part: download the file itself, signed in if need be
part_file_other_model = this is a { $kind } file, which is not read: export the part as STL, OBJ, PLY or 3MF
part_file_no_model = this is a { $kind } file, not a part: open the part's STL, OBJ, PLY or 3MF file
part_file_unknown = this is not a part file: neither STL (`solid` text, or a binary facet count) nor OBJ, PLY or 3MF
part_file_decimal_comma = numbers are written with a decimal comma (byte { $byte }), which no such file may have: export the part with decimal points
part_file_no_facets = the file holds no facets; export the part again
part_file_all_dropped = no usable facet: { $dropped ->
    [one] the only facet was dropped; it has { $first }
   *[other] all { $dropped } facets were dropped; the first one has { $first }
}
part_file_point_cloud = a point cloud of { $points ->
    [one] 1 point
   *[other] { $points } points
}, not a mesh: no faces join them; export the part as a mesh
part_file_other_unit = { $file } states { $stated } as its unit, but is read in { $units }: write units = "{ $key }" where it is named
stl_cut_off = the header promises { $promised } facets ({ $needed } bytes), but the file has { $present } bytes: it was cut off, or is not an STL file; export it again
stl_count_doubtful = the header promises { $promised } facets, but { $more } more follow, and then something that is none: the file is damaged; export it again
stl_text_cut_off = the text ends inside a solid, after { $facets } facets (byte { $byte }): it was cut off; export it again
obj_vertex = line { $line }: a vertex needs three numbers, and a weight other than 0 if it has one; export the part again
obj_face = line { $line }: a face has something that is not a vertex number; export the part again
obj_no_such_vertex = line { $line }: a face has a vertex that the file does not hold: it was cut off or is damaged; export it again
ply_header_line = line { $line } of the PLY header cannot be read; export the file again
ply_no_header_end = the PLY header has no end_header: the file was cut off; export it again
ply_no_coordinates = the vertices of the PLY file have no x, y and z; export the file again
ply_no_indices = the faces of the PLY file have no list of vertices (vertex_indices); export the part again
ply_strips = the PLY file holds triangle strips, which are not read: export the part with faces
ply_cut_off = the PLY file ends before the { $promised } rows of { $element } that its header promises: it was cut off; export it again
ply_value = row { $row } of { $element } in the PLY file has something that is not a number it can have; export the file again
ply_no_such_vertex = face { $face } of the PLY file has a vertex that is none of the { $vertices } in the file: it is damaged; export it again
threemf_archive = the archive of this 3MF or ZIP file cannot be read: it was cut off or is damaged; fetch or export it again
threemf_no_entry = the 3MF file lacks { $entry }: it is damaged; export it again
threemf_unreadable = { $entry } in the 3MF file cannot be unpacked: it is damaged or encrypted; export it again
threemf_too_large = unpacked, the models of the 3MF file are larger than { $most } MiB, the most that is read: export the part coarser, or as binary STL
threemf_xml = { $entry } in the 3MF file is not XML (line { $line }): it is damaged; export it again
threemf_unit = the 3MF file has the unit { $word }, which the format does not know; export it again
threemf_units_differ = the models in the 3MF file have different units; export the part as one model
threemf_extension = the 3MF file cannot be read without the extension { $name }, which is not known here: export the part without it, or as STL
threemf_value = line { $line } of the model in the 3MF file: a number of { $element } is missing or cannot be read; export it again
threemf_no_such_vertex = object { $object } of the 3MF file has a triangle with a vertex that is none of its { $vertices }: the file is damaged; export it again
threemf_no_such_object = the 3MF file has no object { $object }, which it builds: it is damaged; export it again
threemf_too_deep = objects of the 3MF file are made of each other, or of others in too many steps; export the part as one mesh
threemf_too_many_objects = the 3MF file repeats its objects more than { $most } times; export the part alone
threemf_too_many_facets = the 3MF file repeats its objects to more than { $most } facets; export the part alone

## What a facet has that makes it unusable
facet_nan = a NaN vertex
facet_infinite = an infinite vertex
facet_unreadable = a vertex that is not a number
facet_no_end = no endfacet
facet_not_three_vertices = more or fewer than three vertices
facet_no_area = no area
facet_crosses_itself = an outline that crosses itself
facet_too_many_corners = more than 4096 corners

## Findings
part_implausible_size = a size of { $size } mm is implausible; in { $unit } it would be { $other } mm
part_implausible_in_any_unit = a size of { $size } mm is implausible, and no unit makes it plausible: look at the unit in CAD and export the part again
part_use_units = use --units { $units }
part_far_from_origin = the part lies { $distance } m from the origin, where the file's coordinates have steps of { $step } mm: move it to the origin in CAD and export it again
part_shattered = { $smaller } of { $surfaces } surfaces are smaller than the spot ({ $spot } mm²); with islands below { $below } mm² absorbed { $left ->
    [one] 1 surface is left
   *[other] { $left } surfaces are left
}
part_absorb_in_job = write min_area_mm2 = { $value } under [surfaces] of the job
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
    [one] 1 byte of the file belongs to no facet and was passed over (byte { $at })
   *[other] { $count } bytes of the file belong to no facet and were passed over (from byte { $at } on)
}
part_count_differs = the file says it holds { $promised ->
    [one] 1 facet
   *[other] { $promised } facets
}, but { $read } are there; all of them were read: look whether the part is whole, and export it again
part_unit_overridden = the file states { $stated } as its unit, but it is read in { $units }: is that meant?
part_unit_taken = the file states { $stated } as its unit, which was taken
part_lines_not_read = { $count ->
    [one] 1 line without area was left out
   *[other] { $count } lines without area were left out
}
part_points_not_read = { $count ->
    [one] 1 single point was left out
   *[other] { $count } single points were left out
}
part_free_form_not_read = { $count ->
    [one] 1 curve or surface given by a formula was left out: export the part as a mesh to have it
   *[other] { $count } curves or surfaces given by formulas were left out: export the part as a mesh to have them
}
part_unknown_lines = { $count ->
    [one] 1 line of the file begins with an unknown word and was passed over
   *[other] { $count } lines of the file begin with an unknown word and were passed over
}
part_element_not_read = { $count ->
    [one] 1 row of { $name } was left out
   *[other] { $count } rows of { $name } were left out
}
part_objects_not_built = { $count ->
    [one] 1 object of the file is not placed in its build and was left out
   *[other] { $count } objects of the file are not placed in its build and were left out
}
part_supports_not_read = { $count ->
    [one] 1 object that is a support for printing was left out
   *[other] { $count } objects that are supports for printing were left out
}
part_beams_not_read = { $count ->
    [one] 1 beam of a lattice was left out
   *[other] { $count } beams of lattices were left out
}
part_meshed = a surface was laid through its { $points } points, { $rms } mm off them (rms): edges are rounded over up to { $rounded } mm, what is smaller than { $cell } mm is not there; where nothing was scanned it has holes, and what lies behind them is kept clear of
part_side_guessed = its outside is guessed, since the points have no normals
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
