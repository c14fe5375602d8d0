### What is wrong with the file of a head or a contact tool.

head_stack = { $file }: { $what }; a head is a list of [[part]] with from_mm, to_mm, r0_mm and r1_mm, or an STL, OBJ, PLY or 3MF file
stack_empty = it has no part
stack_span = line { $line }: part { $part }: from_mm = { $from }, to_mm = { $to }: give -1000 to 10000, the lower first
stack_radii = line { $line }: part { $part }: r0_mm = { $r0 }, r1_mm = { $r1 }: give 0 to 2000, not both 0
contact_tool_missing = { $key } is missing: a disc has kind = "disc", radius_mm, edge_mm, thickness_mm and contact = "rim" or "face"; a belt has kind = "belt", radius_mm of its wheel and width_mm
contact_tool_needless = line { $line }: { $key } does not belong to this kind of tool: take it out
contact_tool_range = line { $line }: { $key } = { $value }: give { $low } to { $high }
