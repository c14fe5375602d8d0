### The numbers that an operator sets: the key of the job file with underscores for dots, the label, and what it means.

## Feature surfaces

surfaces_angle_deg = Crease angle
    .meaning = Edges with at least this angle between their facets divide feature surfaces
surfaces_min_area_mm2 = Absorb islands below
    .meaning = Surfaces smaller than this join the neighbour across the smoothest border; 0 = off
surfaces_hysteresis_deg = Hysteresis
    .meaning = Edges with at least this angle are creases too where they continue one; 0 = off

## Lines

layers_spacing_mm = Spacing
    .meaning = Distance between section planes; on a slope the lines lie further apart
layers_cross_deg = Cross angle
    .meaning = Angle between the two rasters of the strategy cross
layers_inset_mm = Inset
    .meaning = How far lines stay inside the rim of the surface; negative: how far they run on over it, as long as the part goes on
layers_ignore_holes_mm = Holes that count
    .meaning = Lines run over holes narrower than this, whatever the inset
layers_join_mm = Bridge gaps up to
    .meaning = Pieces of a line that are no further apart than this become one pass, with the laser off over the gap; 0 = off
layers_shortest_mm = Leave out below
    .meaning = Pieces of lines shorter than this are left out; 0 = none
layers_seam_shift_mm = Shift starts by
    .meaning = How far each closed line begins behind the start of the one before; 0 = begin where the way is shortest
layers_passes = Passes
    .meaning = How many times each surface is gone over

## Bead

bead_width_mm = Bead width
    .meaning = Width of a clad bead at its foot; 0 = nothing is laid
bead_height_mm = Bead height
    .meaning = Height of a clad bead, and of a layer; 0 = nothing is laid
bead_layers = Layers
    .meaning = How many layers are laid on top of each other, each planned on the part as it has grown
bead_start_shift_mm = Shift layers by
    .meaning = How far closed lines begin behind their start in the layer before

## Beam, targets, tilt

beam_defocus_mm = Defocus distance
    .meaning = How far the focus stands above the surface, along the beam
path_chord_error_mm = Chord error
    .meaning = How far the surface may lie from the straight move between two targets
path_max_step_mm = Longest step
    .meaning = Longest move between two targets
path_max_turn_deg = Largest turn
    .meaning = Largest turn of the surface normal between two targets
beam_speed_mm_s = Speed
    .meaning = Speed of the spot on the part
beam_air_speed_mm_s = Air speed
    .meaning = Speed of the focus with the laser off
beam_power_w = Power
    .meaning = Laser power; stated at the head of the program, and set by an output if the cell has one for it
beam_frequency_khz = Pulse frequency
    .meaning = Frequency of the laser's pulses, stated and set like the power; 0 = none, or as set at the laser
beam_spot_mm = Spot diameter
    .meaning = Diameter of the spot on the part
path_max_tilt_deg = Greatest tilt
    .meaning = Greatest angle between beam and surface normal in the search for clearance, and in any plan with a head
beam_margin_mm = Margin
    .meaning = Least distance of cone and head from everything else; it counts once a head is given
path_standoff_mm = Standoff window
    .meaning = How far the head may be drawn back or pushed forward on lines that are blocked otherwise; 0 = not at all
path_tilt_rate_deg_mm = Tilt rate
    .meaning = How fast the beam may tilt against the surface normal along the line, in the search for clearance
path_tilt_rate_deg_s = Tilt speed
    .meaning = How fast the beam may tilt against the surface normal, at the programmed speed
optics_lens_to_focus_mm = Lens to focus
    .meaning = Distance from the last glass to the focus; the cone of the beam begins at that glass
optics_aperture_mm = Aperture
    .meaning = Diameter of the beam at the last glass
optics_focus_spot_mm = Spot at the focus
    .meaning = Diameter of the beam at its focus
optics_rayleigh_mm = Rayleigh length
    .meaning = Distance from the focus at which the spot is 1.41 times as wide
optics_wavelength_nm = Wavelength
    .meaning = Wavelength of the laser; only the beam quality M² depends on it
path_lead_in_mm = Lead-in
    .meaning = How far before the line the spot starts with the laser off, so that it is up to speed when the laser goes on
path_lead_out_mm = Lead-out
    .meaning = How far the spot goes on behind the end of the line with the laser off, at the programmed speed

## Part, dose, cell

part_placement_scale = Scale
    .meaning = Factor on the size of the part, on top of its unit
dose_line_mm = Scanned width
    .meaning = Width of a scanned line across the travel direction; it counts with the profile line
dose_low_j_cm2 = Least dose
    .meaning = Less than this leaves the surface unclean; 0 = half of P/(v·d)
dose_high_j_cm2 = Greatest dose
    .meaning = More than this harms the surface; 0 = twice P/(v·d)
dose_collateral_j_cm2 = Collateral dose
    .meaning = What may land on surfaces that were not chosen; 0 = a tenth of P/(v·d)
cell_deviation_mm = Deviation of the spot
    .meaning = How far the spot may leave its line where the flange moves straight; where it would go further, targets are added

## Scan

scan_min_depth_mm = Patches from
    .meaning = Where more than this is missing from the model, or too much on it, the part has a patch
scan_gate_mm = Largest deviation
    .meaning = A part that is off its model by more than this is not planned: it may be another one; 0 = no limit
scan_tolerance_mm = Tolerance
    .meaning = Points that lie off the model by no more than this, to either side, are where they ought to be
weld_even_light_px = Light window
    .meaning = Width of the window that tells the light around a pixel; 0: the light is even
weld_smoothing_px = Smoothing
    .meaning = How far the image is smoothed before the threshold
weld_sigmas = Threshold above skin
    .meaning = An area begins so many standard deviations above the main mode of the histogram
weld_opening_px = Opening
    .meaning = What is narrower than this is no area
weld_closing_px = Closing
    .meaning = Gaps in an area that are narrower than this are closed
weld_least_area_px = Least area
    .meaning = Areas of fewer pixels are left out
weld_pass_depth_mm = Depth of a pass
    .meaning = What one pass takes off; the height of the bead divided by it is the number of passes
weld_at_once = Passes at once
    .meaning = How many passes the program has; after them the next images tell what is left
weld_residual_mm = Height left
    .meaning = The height of the bead at which grinding stops
weld_below_mm = Undercut allowed
    .meaning = Nothing may be ground farther below the surface around the bead than this
weld_removal_share = Removal off by
    .meaning = Where a pass took off more or less than planned by this share, the next one waits for your word
weld_lead_deg = Lead
    .meaning = How far a disc that grinds with its rim leans forward
weld_arc_mm = Entry arc
    .meaning = Radius of the arcs on which the tool comes onto the surface and leaves it
weld_force_n = Contact force
    .meaning = Force of the tool on the part
weld_gouge_mm = Gouge allowed
    .meaning = The tool may dip into the part beside its contact by this, which covers chords and facets
weld_acceleration_mm_s2 = Acceleration
    .meaning = What the tool accelerates by, for the times of one-way, zigzag and spiral
