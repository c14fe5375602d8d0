### What is wrong with a part's file.

stl_empty = the file is empty
stl_cut_off = the header promises { $promised } facets ({ $needed } bytes), but the file has { $present } bytes: it was cut off, or is not an STL file; export it again
stl_text_cut_off = the text ends inside a solid, after { $facets } facets (byte { $byte }): it was cut off; export it again
stl_not_stl = this is not an STL file: neither `solid` text nor a binary facet count is found
stl_no_facet = no usable facet: { $dropped } facets were read and all dropped (first: { $first })
