### Options of `plan` and what is wrong with them. Words that are typed stay as they are in every language.

## What they are
option_number = { $meaning } [default: { $default }]
option_units = Unit of the file: mm, m or inch [default: what the file states, else mm]
option_weld = Corners that become one: auto (equal ones; to close open edges also those a rounding apart) or exact (equal ones alone) [default: auto]
option_surfaces = Surfaces to clean, in the order of work: all, or numbers like 4,1 [default: all]
option_direction = Normal of the section planes: x, y, z, auto or DX,DY,DZ; auto suits each surface [default: auto]
option_strategy = Lines: planes, adaptive, offset, spiral or cross [default: planes]
option_overlap = Overlap of neighbouring spots (of beads, where there are any), per cent, in place of the spacing
option_offset = First plane above the lowest point, mm, or centred [default: centred]
option_order = Order of lines: zigzag, one-way or shortest [default: zigzag]
option_correction = What is done about interference: section-plane, clearance or none [default: section-plane]
option_head = Head: a TOML stack (part: from_mm to_mm r0_mm r1_mm, from the focus on), or an STL, OBJ, PLY or 3MF file [default: the ray alone]
option_cell = Cell file [default: the shipped cell of the robot]
option_robot = Robot: { $shipped }, or a robot file [default: none, poses only]
option_mount = What the robot carries: part-in-hand or tool-in-hand [default: part-in-hand, or as the cell says]
option_dialect = Program: { $dialects } [default: nachi]
option_spin = Rotation about the beam: free or travel [default: free]

## What can be given
give_number = give a number
give_units = give mm, m or inch
give_weld = give auto or exact
give_surfaces = give all, or surface numbers like 4,1
give_surface_once = surface { $surface } stands twice in the list; name it once
give_direction = give x, y, z, auto or three numbers DX,DY,DZ that are not all 0
give_strategy = give planes, adaptive, offset, spiral or cross
give_offset = give a number of mm, or centred
give_order = give zigzag, one-way or shortest
give_correction = give section-plane, clearance or none
give_mount = give part-in-hand or tool-in-hand
give_spin = give free or travel
