### The 3D view, and what is shown in it.

## The view
view_name = 3D view
view_cube = View cube
view_front = Front
view_back = Back
view_left = Left
view_right = Right
view_top = Top
view_bottom = Bottom

## Why there is none
view_no_headless_gl = no OpenGL without a screen ({ $reason }): install libegl1 libgl1-mesa-dri (Debian, Ubuntu) or mesa-libEGL mesa-dri-drivers (Fedora)
view_egl_not_on_macos = macOS has no EGL
view_egl_failed = EGL: { $answer }
view_egl_no_device = EGL finds no device
view_unnamed_device = device
view_device_answers = { $device }: { $answer }
view_too_old = no OpenGL 3.3: the driver offers { $version } on { $renderer }; update the graphics driver, or install libegl1 libgl1-mesa-dri and start with LIBGL_ALWAYS_SOFTWARE=1
view_driver_refuses = the graphics driver refuses { $what }: { $reason }; update it, or start with LIBGL_ALWAYS_SOFTWARE=1
view_framebuffer_refused = the graphics driver cannot draw a picture of { $width } × { $height } pixels (status { $status }); update it, or start with LIBGL_ALWAYS_SOFTWARE=1
view_vertex_array = a vertex array
view_framebuffer = a framebuffer
view_background_shader = the shader for the background
view_facet_shader = the shader for facets
view_line_shader = the shader for lines
view_dot_shader = the shader for dots
view_cloud_shader = the shader for scans

## Legends
legend_over = over
legend_under = under
legend_shaded = shaded
legend_no_light = no light
legend_surplus = surplus
legend_within = within
legend_missing = missing
legend_not_scanned = not scanned
legend_spacing = { $mm } mm
legend_spacing_share = { $percent } %
