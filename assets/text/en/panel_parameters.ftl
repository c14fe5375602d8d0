### The panel of parameters: its groups, the correction, surfaces, the part.

parameters_beam = Beam
parameters_speed = Speed
parameters_targets = Targets, leads
parameters_surfaces = Feature surfaces
parameters_more_surfaces = More on surfaces
parameters_split = Split selected surface at
parameters_split_angle = split angle
parameters_part = Part
parameters_correction = Correction
parameters_correction_tip = What is done where the beam along the normal hits the part
parameters_correction_name = correction { $correction }

## Part

parameters_units = Unit of the file
parameters_weld = Join corners
parameters_turn = Turn
parameters_move = Move
parameters_place_field = { $name } { $axis }

## Tabs

tab_name = settings: { $tab }
tab_lists = Lists
tab_path = Path
tab_beam = Beam
tab_part = Part
tab_robot = Robot
tab_dose = Dose
tab_scan = Scan
tab_weld = Weld
