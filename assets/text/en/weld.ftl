### A weld that is ground: its images, its camera, what was measured.

weld_changed = { $file } is another file than when the job was saved; put the old file back, or use this one (in the window)
weld_other_size = the images have { $now_width } × { $now_height } pixels, and those before the first pass { $width } × { $height }: take them with the same camera from the same place
weld_no_area = no area stands out from the skin in the grey image: lower the threshold, or paint the area
weld_too_many_passes = the bead takes more than 1000 passes of this depth: give a greater depth of a pass
weld_no_skin = the depth image tells no skin around the areas
weld_not_on_part = the skin that the camera sees lies nowhere on the part: { $what }
weld_slack = the part may lie { $slack } mm off where it was seen: arm and tool keep { $slack } mm more than their margin
weld_no_depth_there = nothing was measured in depth where the mask is: take the images again, or paint less
weld_few_points = only { $count } depths around the bead, { $least } are needed: take the images from nearer
weld_one_side = the skin was measured on both sides along { $share } % of the bead only: take the images so that both sides are seen
weld_no_surface = the depths around the bead tell no surface
weld_nothing_stands = nothing stands { $threshold } mm above the skin under the mask: there is nothing to grind off
weld_leaves_image = the bead reaches the rim of the image, or of what was measured: take the images so that all of it is seen
weld_short = the bead is { $length } mm long, too short for a centre line
weld_no_edges = the edges of the bead were not found: it runs into something beside it
weld_unmeasured = the area at column { $u }, row { $v } was left alone: { $what }
weld_held_removal = the last pass took off { $removed } mm where { $planned } mm were planned: the next one waits for your word
weld_held_slack = the images may lie { $slack } mm off on the part, and the passes with them: photograph an edge or a hole as well, state where the camera stood, or leave the part out; they wait for your word
weld_held_place = where on the part the images were taken is open: photograph an edge or a hole as well, state where the camera stood, or leave the part out; the passes wait for your word
weld_held_below = the last pass went { $below } mm below the skin around the bead: the next one waits for your word
weld_bead = bead: { $height } mm high, { $width } mm wide, { $length } mm long; { $passes ->
    [one] 1 pass
   *[other] { $passes } passes
} left
weld_parent = skin around it: { $rms } mm off its points (root mean square), noise { $noise } mm
weld_no_bead = no area stands above the skin
weld_defect = defect area: { $area } mm², { $aspect } times as long as wide
weld_times = { $area } at { $speed } mm/s: one-way { $one_way } s, zigzag { $zigzag } s, spiral { $spiral } s
weld_roughness = roughness at { $points ->
    [one] 1 point
   *[other] { $points } points
}: { $before } µm before, { $after } µm after, { $fell } % less
weld_area_bead = bead
weld_area_defect = defect area

## Images

image_too_large = an image of { $width } × { $height } pixels is too large
image_file_too_large = the file is too large for an image
image_no_image = this is no PNG, TIFF, JPEG or PGM image
image_broken = the image cannot be read: { $reason }
image_eight_bit_depth = a depth image of 8 bits has 256 steps and measures nothing: export it with 16 bits or as floats
image_depth_in_colour = this is a coloured picture of a depth image: export the depths themselves, 16 bits or floats
image_float_grey = a grey image of floats does not say what is white: export it with 8 or 16 bits
image_other_pixels = pixels of this kind are not read: export 8 or 16 bits
image_no_pixels = the image has no pixels
image_one_level = all pixels of the image have the level { $level }: there is nothing on it
image_saturated = { $share } % of the image is white: take it with less light
image_no_depth = the depth image has no depth at any pixel
image_sizes_differ = the grey image has { $gray_width } × { $gray_height } pixels and the depth image { $depth_width } × { $depth_height }: both have to be of one camera

## Camera

camera_json = these are not Open3D's intrinsics: { $reason }
camera_row_by_row = intrinsic_matrix stands row by row; Open3D writes it column by column
camera_not_pinhole = intrinsic_matrix is none of a camera: its last row is 0, 0, 1, and its axes are square to each other
camera_figure = { $key } = { $value } is no figure of a camera
camera_size = the camera is for images of { $width } × { $height } pixels, and these have { $image_width } × { $image_height }: it is another camera's file
camera_off_middle = the camera looks through column { $u }, row { $v } of an image of { $width } × { $height } pixels: it is another camera's file
camera_focal = a focal length of { $focal } px is none for images { $width } pixels wide: it is another camera's file

## Where the camera stood

hand_eye_key_of_pose = pose { $pose }: { $key }
hand_eye_keys = give [[pose]] with camera = "hand" or "fixed", or flange_from_camera, or base_from_camera, and one of these alone
hand_eye_no_flange = flange_from_camera needs base_from_flange: where the hand was when the images were taken
hand_eye_count = { $key } has { $count ->
    [one] 1 number
   *[other] { $count } numbers
}; a matrix has 16, row by row
hand_eye_matrix = { $key } is no motion: { $fault }
hand_eye_few_poses = { $count ->
    [one] 1 pose tells
   *[other] { $count } poses tell
} no camera: take ten, turned about different axes
hand_eye_small_turns = the poses are turned by { $most }° against each other at most, which tells no camera: turn the hand by 30° and more
hand_eye_one_axis = all poses are turned about one axis ({ $x }, { $y }, { $z }), which leaves the camera open along it: turn the hand about others, too
hand_eye_no_fit = no place of the camera fits the poses
