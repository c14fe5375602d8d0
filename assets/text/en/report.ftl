### The report in a few lines.

## How a plan stands
standing_unproven = { $moves ->
    [one] 1 lit move not proven
   *[other] { $moves } lit moves not proven
}
standing_left_out = { $targets ->
    [one] 1 target left out
   *[other] { $targets } targets left out
}
standing_proven = { $moves ->
    [one] proven free: 1 lit move
   *[other] proven free: { $moves } lit moves
}
standing_no_wear = nothing to do: the scan shows no patch to work
standing_held = the passes wait for your word
standing_nothing_to_grind = nothing to do: no pass is left, and no other area is chosen
standing_no_lines = nothing to do: no line lies on the chosen surfaces
standing_no_lines_for = nothing to do: no line lies on the chosen surfaces: { $why }
standing_no_light = nothing to do: no move has the laser on
standing_all_left_out = { $targets ->
    [one] nothing to do: its only target is left out
   *[other] nothing to do: all { $targets } targets left out
}
standing_nothing_left = { $targets ->
    [one] nothing to do: 1 target left out
   *[other] nothing to do: { $targets } targets left out
}

## Figures
report_targets = { $passes ->
    [one] 1 pass
   *[other] { $passes } passes
}, { $targets ->
    [one] 1 target
   *[other] { $targets } targets
}: { $free } free, { $corrected } corrected, { $blocked } blocked
report_lengths = { $work } mm with the laser on, { $blocked } mm blocked, { $air } mm in the air, { $time }
report_lengths_ground = { $work } mm ground, { $blocked } mm blocked, { $air } mm in the air, { $time }
report_extremes = largest tilt { $tilt }°, chord error { $chord } mm, spacing on the surface up to { $spacing } mm
report_layers = { $layers } layers, each planned and proven on the part as the layers before leave it
report_splits = { $splits ->
    [one] 1 split: the laser is off while the beam turns from one side of a wall to the other
   *[other] { $splits } splits: the laser is off while the beam turns from one side of a wall to the other
}
report_order = { $way } mm of way between the lines, { $zigzag } mm in a zigzag
report_surface_blocked = { $surface }: { $blocked } mm of { $whole } mm blocked

## Dose
report_no_dose = dose: not looked at; --dose computes it
dose_shares = { $within }% of the area within { $low } to { $high } J/cm², { $under }% under, { $over }% over, { $shaded }% shaded
dose_collateral = { $area } mm² of surfaces that were not chosen get more than { $most } J/cm²: { $list }
dose_patch_thin = too little: { $area } cm² of { $surface } around ({ $x }, { $y }, { $z }), { $why }
dose_patch_dark = not cleanable: { $area } cm² of { $surface } around ({ $x }, { $y }, { $z }), { $why }
dose_patches_more = { $patches ->
    [one] and 1 smaller patch, in report.json
   *[other] and { $patches } smaller patches, in report.json
}
patch_between_lines = between lines, spacing too wide: give less than { $spacing } mm
patch_too_little = lines come near, and too little lands
patch_blocked = the beam is blocked
patch_blocked_by = blocked by { $by }
patch_shaded = shaded
patch_shaded_by = shaded by { $by }
patch_missed = no line comes near
