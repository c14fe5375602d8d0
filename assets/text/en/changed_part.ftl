### What becomes of a job whose part's file has changed.

carried_moved = the whole part has moved by ({ $x }, { $y }, { $z }) in its file
carried_moved_and_turned = the whole part has moved by ({ $x }, { $y }, { $z }) in its file and turned by { $turn_deg }°
carried_scaled = everything is { $scale } times as large: another unit?
carried_all_unknown = the job cleans all surfaces and does not say what they looked like; they are different now
carried_found = found again: { $count ->
    [one] { $count } surface
   *[other] { $count } surfaces
}
carried_found_renumbered = found again: { $count ->
    [one] { $count } surface
   *[other] { $count } surfaces
}, { $renumbered } of them under another number
carried_not_found = not found: { $surface }
carried_edits_lost = not repeated: { $count ->
    [one] { $count } merge, split or cut
   *[other] { $count } merges, splits or cuts
}
carried_shells_lost = not found: { $count ->
    [one] { $count } flipped shell
   *[other] { $count } flipped shells
}
lost_surface = surface { $surface }: { $why }
lost_named_surface = surface { $surface } ({ $name }): { $why }
lost_nothing_alike = nothing like it is there
lost_several_alike = several are too much alike to tell which one it is
lost_edit_not_repeated = it comes from a merge, split or cut that cannot be repeated
lost_other_facets = it was cut out facet by facet, and the facets are different now
lost_not_remembered = the job does not say what it looked like; it was saved by an earlier version
lost_several_motions = the part has moved, and fits onto itself in several ways
lost_part_moved = the part has moved, and not everything was found in its new place
