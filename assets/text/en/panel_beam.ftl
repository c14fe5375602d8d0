### The tool: head, optics, clamps, tilt; and what the dose is computed with.

## Head

tool_head = Head
tool_head_tip = With a head the beam is a cone, and cone and head keep their margin from everything; without one it is a ray
tool_head_none = none: a ray
tool_open_head = Open head…
tool_open_head_tip = A stack of cylinders and cones (TOML), or an STL, OBJ, PLY or 3MF file
tool_remove_head = Remove the head
tool_head_of_facets = A head of facets counts as the solid that it sweeps when turned about the beam
tool_edit_head = Edit…
tool_edit_head_tip = Put the head together from cylinders and cones, drawn to scale, or begin with a sample
head_title = Laser head
head_drawing = The head from the side, to scale
head_begin_with = Begin with:
head_fixed_optic = Slim optic
head_scan_head = Scan head
head_cladding_nozzle = Cladding nozzle
head_sample_tip = An example of this kind. Measure your own head and change the numbers
head_how = Heights are measured from the focus, upwards along the beam. The thick line is the surface.
head_add = Add a piece
head_add_tip = Adds a cylinder on top of the last piece
head_from = from
head_to = to
head_radius_from = radius below
head_radius_to = radius above
head_number_name = Piece { $number }: { $what }
head_remove = Remove this piece
head_remove_name = Remove piece { $number }
head_keep = Save and use…
head_keep_tip = Writes the head into a file of its own, which the job then uses

## Optics

tool_optics = Optics
tool_m_squared = M² = { $value }
tool_spot = Spot at D = { $defocus } mm: { $spot } mm
tool_tolerance = within 10% from D = { $from } to { $to } mm
tool_spot_is_set = The spot is set to { $spot } mm
tool_take_spot = Take { $spot } mm
tool_take_spot_tip = The spot that these optics give
tool_take_defocus = D = { $defocus } mm
tool_focus_in_part = The focus in the part
tool_focus_above = The focus above the surface
tool_too_narrow = smaller than the spot at the focus: no D gives it

## Clamps

tool_clamps = Clamps
tool_clamp = { $number } { $file }
tool_remove_clamp = Remove this clamp
tool_add_clamp = Add clamp…
tool_add_clamp_tip = A file of a clamp (STL, OBJ, PLY or 3MF), in the part's frame
handles_move = Move in the view
tool_clamp_move_tip = Arrows and rings in the view move and turn the clamp, in steps of 0.5 mm and 1°
tool_clamp_move_name = move clamp { $number } in the view
tool_clamp_put = Put on a face…
tool_clamp_put_tip = Click a face, edge or hole: the clamp's origin goes there, its z axis out of the part
tool_clamp_put_name = put clamp { $number } on a face
tool_clamp_units = Unit
tool_clamp_units_name = unit of clamp { $number }: { $unit }
tool_clamp_at = At
tool_clamp_turned = Turned
tool_clamp_field = clamp { $number } { $axis }

## Tilt

tool_tilt = Tilt
tool_tilt_select = Select one surface to give it a tilt of its own
tool_tilt_surface = Surface { $surface }
tool_lead = Lead
tool_lead_tip = Preferred tilt towards the travel
tool_lean = Lean
tool_lean_tip = Preferred tilt to the right of the travel
tool_least_tilt = Least tilt
tool_least_tilt_tip = The beam never stands closer to the normal than this, so that no reflection returns into the optics
tool_never_to = Never to
tool_never_to_tip = Sides to which the beam must not be tilted
tool_ahead = ahead
tool_behind = behind
tool_left = left
tool_right = right

## Dose

tool_dose = Dose
tool_profile = Profile
tool_profile_tip = How the power is spread over the spot
