### What long work is doing.

activity_reading = reading
activity_building_part = building the part
activity_cutting_surfaces = cutting surfaces
activity_naming_shapes = naming shapes
activity_laying_lines = laying lines
activity_planning = keeping the beam clear
activity_choosing_spins = choosing spins
activity_connecting_moves = connecting moves
activity_working_out_motion = working out the motion
activity_measuring_clearances = measuring clearances
activity_exporting = exporting
activity_packing = packing
activity_writing_program = writing the program
activity_writing_files = writing files
activity_summing_dose = computing the dose
activity_looking_for_help = looking for what would help
activity_trying_speeds = trying lower speeds
activity_trying_changes = trying changes
activity_looking_for_setup = looking for a better set-up
activity_trying_setups = trying set-ups
activity_improving_setup = improving the set-up
activity_trying_small_changes = trying small changes
activity_planning_samples = planning some passes

## In the status line
progress = { $activity } { $percent } %
activity_reading_scan = reading the scan
activity_cleaning_scan = cleaning the scan
activity_laying_scan = laying the scan on the part
activity_comparing_scan = comparing scan and part
activity_cutting_patches = cutting out worn patches
activity_reading_images = reading the images
activity_masking_image = looking for areas in the grey image
activity_measuring_bead = measuring the bead
activity_cutting_areas = making surfaces of the areas
activity_comparing_strategies = comparing the strategies of grinding
