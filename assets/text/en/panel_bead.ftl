### What the beam lays: size, layers, and the section of the beads.

## Group

bead_panel_none = Bead: none
bead_panel_one_layer = Bead: { $width } × { $height } mm
bead_panel_layers = { $layers ->
    [one] Bead: { $width } × { $height } mm, { $layers } layer
   *[other] Bead: { $width } × { $height } mm, { $layers } layers
}
bead_panel_metal = Metal
bead_panel_lay = lay a bead
bead_panel_lay_tip = Cladding: the beam lays a bead on the part
bead_panel_name = bead
bead_panel_back_none = none
bead_panel_size = { $width } × { $height } mm
bead_panel_second = Every second layer
bead_panel_across = across the others
bead_panel_across_tip = Its planes are turned by 90°; offset lines and spirals run the same way in all layers

## Spacing, height or width that fill a layer

bead_panel_filled = The beads fill a layer of their own height (P3)
bead_panel_not_filled = The metal is enough for { $mean } mm, but the layer is planned as { $planned } mm. To fill it, set:
bead_panel_spacing = Spacing { $mm } mm
bead_panel_height = Height { $mm } mm
bead_panel_width = Width { $mm } mm
bead_panel_spacing_tip = Set the distance between centres, and keep the bead as it is (P3 4.1)
bead_panel_height_tip = Set the height of the bead, and keep its width and the spacing (P3 4.1)
bead_panel_width_tip = Set the width of the bead, and keep its height and the spacing (P3 4.1)
bead_panel_take_spacing = take spacing { $mm } mm
bead_panel_take_height = take height { $mm } mm
bead_panel_take_width = take width { $mm } mm

## Section

bead_section_told = section of the beads: width ω { $width } mm, height h { $height } mm, centres c { $centres } mm, overlap η { $overlap } %, ripple r { $ripple } mm, build-up { $build_up } mm
bead_section_width = Width ω
bead_section_height = Height h
bead_section_centres = Centres c
bead_section_overlap = Overlap η
bead_section_ripple = Ripple r
bead_section_build_up = Build-up
bead_section_mm = { $value } mm
bead_section_percent = { $value } %
bead_section_tip =
    To scale, across the lines.
    The outline is that of the arcs: metal that runs into the valleys is not counted
bead_section_drawn = { $drawn } of { $layers } layers are drawn
bead_section_alternate = layers that run across are drawn as if they did not
