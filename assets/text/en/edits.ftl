### Steps of undo and redo: what stands behind *Undo* in the menu.

step_restored = restore unsaved changes

## Toolpath

edit_parameter = change { $parameter }
edit_direction = change direction
edit_offset = change first offset
edit_order = change order
edit_strategy = change strategy
edit_border = change border
edit_centre = change spiral centre
edit_inward = turn spiral
edit_correction = change correction
edit_bead = change bead
edit_profile = change beam profile

## Recipes

edit_recipe = change recipe { $name }
edit_remove_recipe = remove recipe { $name }
edit_duplicate_recipe = duplicate recipe { $name }
edit_rename_recipe = rename recipe { $name }
edit_give_recipe = { $count ->
    [one] give surface { $surface } recipe { $name }
   *[other] give { $count } surfaces recipe { $name }
}
edit_take_recipe = { $count ->
    [one] take recipe of surface { $surface } away
   *[other] take recipe of { $count } surfaces away
}

## Surfaces

edit_clean = { $count ->
    [one] move surface { $surface } to clean
   *[other] move { $count } surfaces to clean
}
edit_unclean = { $count ->
    [one] move surface { $surface } back
   *[other] move { $count } surfaces back
}
edit_shift = { $count ->
    [one] move surface { $surface } in the order
   *[other] move { $count } surfaces in the order
}
edit_reorder = change order of work
edit_merge = { $count ->
    [one] merge surface { $surface }
   *[other] merge { $count } surfaces
}
edit_split = split surface { $surface }
edit_cut = { $facets ->
    [one] cut { $facets } facet off surface { $surface }
   *[other] cut { $facets } facets off surface { $surface }
}
edit_put_aside = { $count ->
    [one] put surface { $surface } aside
   *[other] put { $count } surfaces aside
}
edit_take_back = { $count ->
    [one] take surface { $surface } back
   *[other] take { $count } surfaces back
}
edit_rename = rename surface { $surface }
edit_rename_several = rename { $count } surfaces
edit_surface_border = change border of surface { $surface }
edit_surface_centre = change spiral centre of surface { $surface }
edit_flip_surface = flip surface { $surface }
edit_tilt = change tilt of surface { $surface }
edit_pins = change pinned tilts of surface { $surface }

## Part, cell and tool

edit_flip_shell = flip shell { $shell }
edit_place = place part
edit_units = change unit
edit_weld = join corners otherwise
edit_changed_part = use the changed part
edit_cell = change cell
edit_robot = change robot
edit_mount = change mounting
edit_frames = change set-up
edit_dialect = change dialect
edit_spin = change spin
edit_no_head = take the head away
edit_head = change head
edit_clamps = change clamps

## Scan

edit_no_scan = take the scan away
edit_scan = change scan
edit_add_step = add cleaning step
edit_remove_step = remove cleaning step { $step }
edit_alter_step = change cleaning step { $step }
edit_no_transform = look for the scan's place again
edit_transform = place the scan on the model
edit_pairs = change picked pairs
edit_left_out = change what is left out of the fit
edit_patches = choose patches
edit_own_scan = work from the scan alone
edit_continued = change what is continued across damage
edit_together = change how scans come together
edit_scan_work = change what is worked
edit_scan_lines = change what lines are laid on
edit_base_from_scan = change the scanner's frame

## Weld

edit_no_weld = take the weld's images away
edit_weld_images = change the weld's images
edit_changed_image = use the changed image
edit_ground_pass = take the next images
edit_threshold = change the threshold
edit_paint_mask = paint the mask
edit_erase_mask = erase from the mask
edit_unpaint = take off what was painted
edit_grinding_strategy = change how areas are ground
edit_bead_strategy = change how beads are ground
edit_areas = change which areas are ground
edit_hand_eye = change where the camera stood
edit_grinding_tool = change the grinding tool
edit_goes_on = go on grinding
edit_held = hold the next pass
edit_roughness = change roughness readings
