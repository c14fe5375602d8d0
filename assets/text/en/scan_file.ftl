### A scan's file: what is wrong with it, what was dropped or assumed, whether its unit is in doubt.

## A file that cannot be used
scan_file_not_read = the file cannot be read: { $reason }
scan_file_folder = this is a folder: name the scan's file in it
scan_file_lfs = this is a Git LFS pointer, not the scan: fetch the file itself (git lfs pull)
scan_file_packed = this is a { $kind } archive: unpack it and open the scan in it
scan_file_web_page = this is a web page, not the scan: download the file itself, signed in if need be
scan_file_other = this is a { $kind } file, which is not read as a scan: export the scan as PLY, PCD, E57, PTX or text
scan_file_unknown = this is not a scan: neither PLY, PCD, E57, PTX or a mesh, nor text with rows of x, y and z
scan_file_no_coordinates = nothing in the file is named as a coordinate; it has no x, y and z: { $columns }
scan_file_cut_off = the file promises { $promised ->
    [one] 1 point
   *[other] { $promised } points
}, but has room for { $present } alone: it was cut off, or its header is wrong; export it again
scan_file_no_points = the file holds no points; export the scan again
scan_file_all_dropped = no usable point: { $dropped ->
    [one] the only point was dropped; it
   *[other] all { $dropped } points were dropped; each
} has a coordinate that is no number, or is marked as not measured
scan_file_too_far = point { $point } lies farther from the first one than can be computed with: the file is damaged; export it again
scan_file_too_many = { $points } points are more than can be read here; thin the scan out, or cut it to the part
scan_file_decimal_comma = numbers are written with a decimal comma (byte { $byte }), which PLY files may not have: export the scan with decimal points
pcd_no_header = the file has no PCD header: its data begin at the first line; give it the ending .xyz if it is rows of x, y and z
pcd_no_data = the PCD header has no DATA line: the file was cut off; export it again
pcd_line = line { $line } of the PCD header cannot be read; export the scan again
pcd_type = the PCD field { $field } has a TYPE, SIZE or COUNT that there is none of; export the scan again
pcd_counts = the PCD header promises { $points } points, but WIDTH × HEIGHT is { $grid }: one of them is wrong; export the scan again
pcd_size = the PCD header promises { $header } bytes, but what is compressed says { $packed }: the file is damaged; export it again
pcd_packed = the compressed points cannot be unpacked (byte { $byte }): the file is damaged; export it again
pcd_row = line { $line } of the PCD file is not a row with a number for each field; export the scan again
ptx_count = a whole number should stand here: how many columns or rows the cloud has; export the scan again
ptx_pose = three or four numbers of a pose should stand here; the file was cut off or is damaged: export it again
ptx_no_motion = the matrix that ends here does not only turn and shift the points, as a pose does; export the scan again
ptx_point = a point should stand here: x, y, z, intensity, and a colour if the others have one; export the scan again
e57_checksum = page { $page } of the E57 file does not fit its checksum: the file is damaged; copy or export it again
e57_length = the E57 file says it has { $stated } bytes, but has { $present }: it was cut off, or more was written behind it; copy or export it again
e57_description = what the E57 file says of its scans (header and XML) cannot be read, or is of another version; export the scan again
e57_points = points of scan { $scan } in the E57 file cannot be read; export the scan again
e57_pose = the pose of scan { $scan } in the E57 file does not only turn and shift, as a pose does; export the scan again
e57_not_handled = the E57 file uses something that is not read here; export the scan with plain cartesian coordinates

## What was found
scan_points_dropped = { $count ->
    [one] 1 point was dropped: a coordinate is no number, or infinite
   *[other] { $count } points were dropped: a coordinate is no number, or infinite
}
scan_invalid_points = { $count ->
    [one] 1 point that the scanner marked as not measured was left out
   *[other] { $count } points that the scanner marked as not measured were left out
}
scan_count_differs = the file says it holds { $promised ->
    [one] 1 point
   *[other] { $promised } points
}, but { $read } are there; all of them were read: look whether the scan is whole
scan_short_rows = { $count ->
    [one] 1 row has fewer columns than the first and was left out (line { $line })
   *[other] { $count } rows have fewer columns than the first and were left out (the first in line { $line })
}
scan_long_rows = { $count ->
    [one] 1 row has more columns than the first; these were not read (line { $line })
   *[other] { $count } rows have more columns than the first; these were not read (the first in line { $line })
}
scan_lines_passed_over = { $count ->
    [one] 1 line is not a row of numbers and was passed over (line { $line })
   *[other] { $count } lines are not rows of numbers and were passed over (the first is line { $line })
}
scan_bytes_passed_over = { $count ->
    [one] 1 byte of the file belongs to no point and was passed over (byte { $at })
   *[other] { $count } bytes of the file belong to no point and were passed over (from byte { $at } on)
}
scan_normals_not_for_all = { $without ->
    [one] 1 point has no normal, so the normals of the others
   *[other] { $without } points have no normal, so those of the others
} were not kept
scan_colours_not_for_all = { $without ->
    [one] 1 point has no colour, so the colours of the others
   *[other] { $without } points have no colour, so those of the others
} were not kept
scan_intensities_not_for_all = { $without ->
    [one] 1 point has no intensity, so the intensities of the others
   *[other] { $without } points have no intensity, so those of the others
} were not kept
scan_columns_assumed = nothing names the columns; they were taken as { $columns }: is that right?
scan_assumed_xyz = x, y, z and others that are not read
scan_assumed_intensity = x, y, z and intensity
scan_assumed_rgb = x, y, z, red, green and blue
scan_assumed_normal = x, y, z and the normal
scan_assumed_intensity_rgb = x, y, z, intensity, red, green and blue
scan_decimal_commas = numbers were read with commas in the place of decimal points
scan_columns_not_read = columns that nothing here needs were left out: { $names }
scan_element_not_read = { $count ->
    [one] 1 row of { $name } was left out; the points are all there
   *[other] { $count } rows of { $name } were left out; the points are all there
}
scan_colours_clamped = { $count ->
    [one] 1 value of a colour was out of range and was taken as the nearest
   *[other] { $count } values of colours were out of range and were taken as the nearest
} that there is
scan_viewpoint = the file says where the scanner stood; the points were taken as they stand in it
scan_clouds_joined = the { $count } clouds of the file, each in the place that it says, became one
scan_corners_taken = the corners of the file's { $facets ->
    [one] facet
   *[other] { $facets } facets
} were taken as points
scan_corners_taken_but = the corners of the file's { $facets ->
    [one] facet
   *[other] { $facets } facets
} were taken as points; { $dropped ->
    [one] 1 more facet could not be used
   *[other] { $dropped } more facets could not be used
}

## Units
scan_unit_of_cloud = the part is { $ratio } times as large as the scan: is the scan in { $unit }?
scan_unit_of_part = the part is { $ratio } times as large as the scan: is the part in { $unit }?
scan_unit_either = the part is { $ratio } times as large as the scan: is the scan in { $cloud }, or the part in { $part }?
