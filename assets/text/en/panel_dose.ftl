### The dose in numbers.

## Kinds of colouring

dose_panel_heading = Dose
dose_panel_shown = Show the dose
dose_panel_by_dose = dose
dose_panel_by_incidence = incidence
dose_panel_by_surface = surfaces

## While there is none

dose_panel_computing = computing the dose
dose_panel_no_plan = waits for an up-to-date plan
dose_panel_not_computed = not computed; close and open the panel to try again

## Scale and shares

dose_panel_scale = colour scale
dose_panel_j_cm2 = { $dose } J/cm²
dose_panel_kj_cm2 = { $dose } kJ/cm²
dose_panel_angle = { $angle }°
dose_panel_within = { $percent }% within the window
dose_panel_under = { $percent }% under
dose_panel_over = { $percent }% over
dose_panel_shaded = { $percent }% shaded
dose_panel_window = window { $low } to { $high }
dose_panel_histogram = histogram of the dose
dose_panel_histogram_note = chosen area by dose; lines: the window

## Clicked place

dose_panel_clicked = Clicked place
dose_panel_click = click the part to see which passes reach that place
dose_panel_place = surface { $surface } at { $place }: { $dose }
dose_panel_no_beam = no beam reaches this place
dose_panel_hit = pass { $pass } at { $time }, { $angle }°, { $dose }
dose_panel_go_to_pass = Go to this pass

## What stays unclean, and what lands beside

dose_panel_not_cleanable = Not cleanable: { $area } cm²
dose_panel_too_little = Too little: { $area } cm²
dose_panel_put_aside = Put them on a second list
dose_panel_put_aside_tip = They become surfaces of their own, put aside for another job, and are not planned
dose_panel_patch = { $area } cm² of surface { $surface }: { $why }
dose_panel_show = Show it
dose_panel_smaller = { $count ->
    [one] and { $count } smaller one
   *[other] and { $count } smaller ones
}
dose_panel_beside = Outside the chosen surfaces: { $area } mm²
dose_panel_beside_over = more than { $dose }
dose_panel_beside_surface = surface { $surface }: { $area } mm², up to { $dose }
