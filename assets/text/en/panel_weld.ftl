### A weld that is ground: its files, mask, areas, passes, and its images.

weld_panel = Weld
weld_panel_tells_worked = the weld's images tell what is ground: tick its areas
weld_panel_keeps_surfaces = not while a weld is ground: its areas give the part other facets than its file has
weld_panel_no_light = a grinding tool lays no light on the part

## Files

weld_panel_open_tip = A grey image, then its depth image, then the camera that took both
weld_panel_gray = Grey image
weld_panel_depth = Depth image
weld_panel_camera = Camera
weld_panel_images = Show images
weld_panel_images_tip = Grey and depth side by side with the mask, step by step, and the brush  { $keys }
weld_panel_other = Other images…
weld_panel_take_away = Take away
weld_panel_take_away_tip = The job grinds no weld any more
weld_panel_hand_eye = Hand-eye
weld_panel_hand_eye_tip = Where the camera stood: robot poses with target poses, or the result
weld_panel_hand_eye_none = nobody knows where the camera stood
weld_panel_tool = Tool
weld_panel_tool_tip = A disc or a belt with its measures
weld_panel_tool_none = the shipped disc
weld_panel_choose = Choose…
weld_panel_choose_name = choose the file of { $what }
weld_panel_remove_name = take the file of { $what } away

## Mask

weld_panel_mask = Mask
weld_panel_mask_numbers = Steps of the mask
weld_panel_histogram = histogram of the weld's grey image
weld_panel_histogram_tip = Levels of the evened image, counts as logarithms. Blue: the main mode, the skin; grey: one standard deviation from it; orange: the threshold, which can be dragged
weld_panel_mode = Skin at level { $mode }, standard deviation { $sigma }
weld_panel_threshold = Threshold
weld_panel_threshold_level = level of the threshold
weld_panel_threshold_found = from the histogram
weld_panel_threshold_found_tip = So many standard deviations above the skin as the steps of the mask say
weld_panel_threshold_given = by hand

## Areas

weld_panel_areas = Areas
weld_panel_no_areas = none yet
weld_panel_area = { $area } { $kind }
weld_panel_area_tip = Whether this area is ground
weld_panel_grind_area = grind area { $area }
weld_panel_area_mm2 = { $area } mm²
weld_panel_area_px = { $pixels } px
weld_panel_area_high = { $size }, { $height } mm high

## How it is ground

weld_panel_strategy = How it is ground
weld_panel_beads = Beads
weld_panel_defects = Areas without height
weld_panel_strategy_name = { $what } { $strategy }
weld_panel_one_way = one-way
weld_panel_zigzag = zigzag
weld_panel_spiral = spiral
weld_panel_along = along
weld_panel_one_way_hint = Parallel lines, all in one sense; the tool leaves at the end of each
weld_panel_zigzag_hint = Parallel lines back and forth, joined at the rim
weld_panel_spiral_hint = One spiral, its turns equally far apart on the surface
weld_panel_along_hint = Lines along the centre line of the bead
weld_panel_tool_numbers = How the tool is led

## Passes

weld_panel_passes = Passes
weld_panel_passes_left = { $passes ->
    [one] 1 pass left
   *[other] { $passes } passes left
}
weld_panel_pass = Pass
weld_panel_number = { $number }
weld_panel_level = Down to, mm
weld_panel_infeed = Infeed, mm
weld_panel_left_area = Area, mm²
weld_panel_history = Ground so far
weld_panel_before = Before, mm
weld_panel_planned = Planned, mm
weld_panel_left = Left, mm
weld_panel_next_images = Take next images…
weld_panel_next_images_tip = The pass was ground: the grey image after it, then the depth image. Height, passes and infeed are found anew, and the images before become history
weld_panel_no_next_images = there is no pass left to be ground, or it is not planned yet
weld_panel_go_on = Go on all the same
weld_panel_go_on_tip = The next pass is given out though the last one took off other than it should
weld_panel_goes_on = The next pass is given out on your word
weld_panel_hold = Hold it again

## Bead

weld_panel_bead = Bead
weld_panel_mm = { $number } mm
weld_panel_greatest_height = Greatest height
weld_panel_mean_width = Width
weld_panel_length = Length
weld_panel_noise = Noise of the depths
weld_panel_parent_rms = Skin off its points (rms)
weld_panel_bead_plots = Height and width along it
weld_panel_height_along = Height along the centre line, mm
weld_panel_width_along = Width along the centre line, mm
weld_panel_heights = Points by their height, mm
weld_panel_height_plot = height along the bead
weld_panel_width_plot = width along the bead
weld_panel_heights_plot = histogram of heights
weld_panel_legend = Height of the bead, mm
weld_panel_height_scale = scale of the bead's height

## Strategies compared

weld_panel_times = Strategies compared
weld_panel_no_times = Times are there once the areas are planned
weld_panel_speed = mm/s
weld_panel_seconds = { $seconds } s
weld_panel_lifts = Lifts
weld_panel_lifts_tip = How often the tool leaves the surface on the way
weld_panel_times_chart = times of the strategies: { $what }
weld_panel_take_quickest = Take the quickest: { $strategy }
weld_panel_take_quickest_name = take the quickest: { $what }
weld_panel_quickest_taken = it is taken already

## Roughness

weld_panel_roughness = Roughness
weld_panel_point = Point
weld_panel_before_um = Before, µm
weld_panel_after_um = After, µm
weld_panel_before_at = roughness before at point { $point }
weld_panel_after_at = roughness after at point { $point }
weld_panel_measured = measured…
weld_panel_measured_tip = Enter what was measured after grinding
weld_panel_measure_after = measured after at point { $point }
weld_panel_add_point = Add point
weld_panel_remove_point = Take this point out
weld_panel_remove_point_name = take point { $point } out
weld_panel_roughness_mean = Mean of { $points ->
    [one] 1 point
   *[other] { $points } points
}: { $before } µm before, { $after } µm after, { $fell } % less

## Images

weld_panel_images_title = Images of the weld
weld_panel_no_images = The images are being read
weld_panel_step = Step
weld_panel_step_gray = grey image
weld_panel_step_evened = light evened out
weld_panel_step_smoothed = smoothed
weld_panel_step_above = above the threshold
weld_panel_step_opened = opened
weld_panel_step_closed = closed
weld_panel_step_painted = painted
weld_panel_step_areas = areas
weld_panel_step_edges = edges
weld_panel_pan = Shift
weld_panel_pan_tip = A drag shifts the images; the wheel enlarges them
weld_panel_add = Add
weld_panel_add_tip = A drag paints onto the mask, with the right button it erases; the middle button shifts
weld_panel_erase = Erase
weld_panel_erase_tip = A drag erases from the mask, with the right button it paints; the middle button shifts
weld_panel_radius_prefix = radius{ " " }
weld_panel_px = { " px" }
weld_panel_radius = radius of the brush on the mask
weld_panel_unpaint = Take off what was painted
weld_panel_not_painted = nothing was painted
weld_panel_whole = Whole
weld_panel_whole_tip = Shows the whole images again
weld_panel_gray_image = grey image of the weld
weld_panel_depth_image = depth image of the weld
weld_panel_no_pixel = Column, row, grey level and depth stand here
weld_panel_pixel = Column { $column }, row { $row }: level { $level }, depth { $depth } mm
weld_panel_pixel_hole = Column { $column }, row { $row }: level { $level }, no depth
weld_panel_depth_legend = Depth, mm
weld_panel_depth_scale = scale of the depths
