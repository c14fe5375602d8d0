### What people are to know of a plan, the worst first, and what helps.

## Not proven
notice_unproven_beam = { $moves ->
    [one] 1 lit move is not proven: the beam would hit { $surface }
   *[other] { $moves } lit moves are not proven: the beam would hit { $surface }
}
notice_unproven_head = { $moves ->
    [one] 1 lit move is not proven: the head would hit { $surface }
   *[other] { $moves } lit moves are not proven: the head would hit { $surface }
}
notice_unproven_beam_clamp = { $moves ->
    [one] 1 lit move is not proven: the beam would hit a clamp
   *[other] { $moves } lit moves are not proven: the beam would hit a clamp
}
notice_unproven_head_clamp = { $moves ->
    [one] 1 lit move is not proven: the head would hit a clamp
   *[other] { $moves } lit moves are not proven: the head would hit a clamp
}
notice_unproven_abrasive = { $moves ->
    [one] 1 lit move is not proven: the grinding tool would come too close to { $surface }
   *[other] { $moves } lit moves are not proven: the grinding tool would come too close to { $surface }
}
notice_unproven_gouge = { $moves ->
    [one] 1 lit move is not proven: the grinding tool would cut into { $surface } beside its contact
   *[other] { $moves } lit moves are not proven: the grinding tool would cut into { $surface } beside its contact
}
notice_unproven_abrasive_clamp = { $moves ->
    [one] 1 lit move is not proven: the grinding tool would come too close to a clamp
   *[other] { $moves } lit moves are not proven: the grinding tool would come too close to a clamp
}
remedy_not_proven = do not run the program; `clearbeam verify` names the lines; try another correction, or leave the surface out

## Not done
notice_no_wear = the scan shows no patch to work: nothing is missing by more than the least depth
notice_held = the passes wait for your word, so there is no program
notice_nothing_to_grind = no pass is left, and no other area is chosen, so there is no program
notice_no_lines = nothing to do, so there is no program: no line lies on the chosen surfaces
notice_no_lines_for = nothing to do, so there is no program: no line lies on the chosen surfaces ({ $area } mm²): { $why }
notice_no_lines_on = { $surface }: no line on its { $area } mm²: { $why }
notice_all_left_out = nothing to do, so there is no program: all targets are left out: { $list }
notice_by_surface = { $targets } (blocked by { $surface })
notice_by_cause = { $targets } ({ $cause })
notice_blocked_by = { $surface }: { $targets ->
    [one] 1 target
   *[other] { $targets } targets
} blocked by { $by }
notice_blocked_for_head = { $surface }: { $targets ->
    [one] 1 target
   *[other] { $targets } targets
} blocked by { $by }, which the head would hit
notice_blocked_for_tool = { $surface }: { $targets ->
    [one] 1 target
   *[other] { $targets } targets
} blocked by { $by }, which the tool would hit
notice_blocked = { $surface }: { $targets ->
    [one] 1 target
   *[other] { $targets } targets
} blocked
notice_refused = { $surface }: { $targets ->
    [one] 1 target
   *[other] { $targets } targets
} refused: { $why }
notice_example = such as pass { $pass }, point { $point }: { $why }
notice_missed_by_planes = { $surface }: { $missed } of { $area } mm² missed by the planes
notice_missed_by_lines = { $surface }: { $missed } of { $area } mm² missed by the lines
why_beam = the beam would hit something
why_robot = the arm or the part would hit something
why_head = the head would hit something
why_obstacle = an obstacle would be hit
why_reach = out of the robot's reach
why_far_from_flange = the part lies too far from the flange to keep the spot on its line
why_limit = a joint would leave its limits
why_speed = a joint would be too fast
why_singularity = the arm would be singular
remedy_no_lines = choose other surfaces, a smaller spacing, or another direction
remedy_slack = the part may lie { $slack } mm off where it was seen, and the tool keeps that clear as well: scan or photograph an edge or a hole that holds it there, or leave the part's file out
remedy_grinding = grind first what stands there, or take a smaller tool
remedy_correct = let the beam be tilted: choose the correction section-plane or clearance
remedy_clearance = choose the correction clearance
remedy_tilt = allow a greater tilt, or clean it in another set-up
remedy_obstacle = move the obstacle or the part
remedy_turn_part = turn or move the part a little
remedy_reach = move the part nearer to the middle of the robot's reach
remedy_far_from_flange = move the part nearer to the flange, or to the origin in CAD
remedy_limit = turn or move the part, or let the spin be free
remedy_speed = choose a lower speed
remedy_missed_by_planes = try direction auto
remedy_missed_by_lines = choose a smaller spacing or another strategy

## What takes the last line of a surface
taken_by_direction = the section planes lie along it
taken_by_spacing = none fits at a spacing of { $mm } mm
taken_by_turn = no turn of a spiral fits at a spacing of { $mm } mm
taken_by_no_border = it is closed, and has no border that lines could follow
taken_by_border = there is no border { $border }: { $borders ->
    [one] the surface has one
   *[other] the surface has { $borders }
}
taken_by_facets = no facet has an area
taken_by_inset = the inset of { $mm } mm leaves none
taken_by_holes = the inset of { $mm } mm from its holes leaves none
taken_by_shortest = no piece is as long as the { $mm } mm from which pieces are kept

## What gives it lines
change_direction = use direction { $direction }
change_spacing = use a spacing of { $mm } mm
change_inset = use an inset of { $mm } mm
change_ignored_holes = pass over holes up to { $mm } mm
change_shortest = keep pieces from { $mm } mm
change_whole_outline = start from the whole outline
change_strategy = use the strategy { $strategy }
cure = { $change }: that gives lines to { $surfaces }
cure_and_more = { $list } and { $more } more
cure_in_recipe = { $change } in the recipe { $recipe }: that gives lines to { $surfaces }

## Not as wanted
notice_slow = { $surface }: { $moves ->
    [one] on 1 lit move the spot is slower than the { $wanted } mm/s that are set
   *[other] on { $moves } lit moves the spot is slower than the { $wanted } mm/s that are set
}, so it works there for longer: the controller's words allow { $possible } mm/s at pass { $pass }, point { $point }
notice_fast = { $surface }: { $moves ->
    [one] on 1 lit move the spot is faster than the { $wanted } mm/s that are set
   *[other] on { $moves } lit moves the spot is faster than the { $wanted } mm/s that are set
}, so it works there for less time: the controller has no word for less than { $possible } mm/s at pass { $pass }, point { $point }
remedy_slow = set a lower speed, or choose the correction clearance, which turns the beam less quickly
remedy_fast = set a higher speed, or another dialect
notice_remark = { $surface }: { $remark }
remark_layers_alike = all layers run alike: there is no direction across its planes
remark_stops_at_rim = { $ends ->
    [one] 1 line end stops
   *[other] { $ends } line ends stop
} at the rim: there is a sharp edge or the end of the part, and the spot must stay on the part
remark_no_lines = no line in layer { $layer } on its { $area } mm²: { $why }
remark_too_short = { $pieces ->
    [one] 1 piece of { $length } mm is shorter
   *[other] { $pieces } pieces of { $length } mm together are shorter
} than { $shortest } mm and left out

## Found
notice_part_changed = the part's file has changed since the job was saved; all that is to be cleaned was found again
notice_renumbered = { $old } is { $new } now
notice_surfaces_renumbered = surface { $list }
notice_surfaces_lost = not found: surface { $list }
remedy_part_changed = look at the surfaces in the window, and save the job
