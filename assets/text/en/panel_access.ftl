### The access map, and the tilt along a line.

## Map

access_no_place = Step to a target, or point at the part
access_at_target = Access at the target: { $percent }% free
access_under_cursor = Access under the cursor: { $percent }% free
access_map = access map
access_tilt = lead { $lead }°, lean { $lean }°: { $what }
access_free = free
access_not_allowed = not allowed by the surface's tilt rule
access_blocked_by_surface = { $blocker } of surface { $surface }
access_lead = lead
access_lean = lean

## Legend

access_by_beam = the beam hits
access_by_head = the head hits
access_by_clamp = a clamp
access_forbidden = not allowed
access_normal = + the normal
access_chosen = ○ chosen: { $angle }°
access_no_target = no target here
access_none_chosen = blocked: none chosen
access_surface = surface { $surface }

## Tilt along the line

access_strip = Tilt along the line
access_strip_image = tilt along the line
access_needs_clearance = choose the correction clearance to set tilts by hand
access_drag = drag from the line to prefer another tilt
access_remove_pins = Remove all pins
access_most = +{ $angle }°
access_length = { $length } mm
