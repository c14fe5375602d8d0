### Fields of the job and of a recipe: how they are named, and those of the toolpath.

## Whose a field is, where names are read out

field_of_recipe = recipe { $what }
field_of_surface = surface { $what }
field_reset = reset { $what }
field_not_taken = “{ $text }” was not taken: give { $least } to { $greatest }
field_back = Back to { $to }
field_back_to_job = Back to the job's { $to }
field_back_to_recipe_or_job = Back to the value of the recipe or the job

## Toolpath

laying_heading = Layers
laying_strategy = Strategy
laying_strategy_tip = How lines are laid on a surface
laying_strategy_name = strategy
laying_strategy_row = { $strategy } – { $hint }
laying_direction = Direction
laying_direction_tip = Normal of the section planes; auto finds the one that suits each surface
laying_direction_name = direction
laying_direction_choice = direction { $direction }
laying_vector = Vector
laying_vector_name = direction vector { $axis }
laying_lines = Lines
laying_lines_tip = The order in which lines are worked, and which way each is run
laying_in_turn = in turn
laying_order_name = order
laying_order_choice = order { $order }
laying_start_from = Start from
laying_start_from_tip =
    The loops of the outline are numbered from the longest, which is 1.
    To choose one, right click near it on the part: Offset from this border
laying_whole_outline = whole outline
laying_border_name = border
laying_border_prefix = { "border " }
laying_spiral_runs = Spiral runs
laying_spiral_name = spiral
laying_centre = Centre
laying_centre_tip = Right click on the part: Spiral centre here
laying_centre_name = centre
laying_centre_middle = middle of the surface
laying_centre_how = Right click on the part to set it
laying_overlap = Overlap
laying_overlap_beads =
    How much neighbouring beads overlap, as a share of their width; it sets the spacing.
    Negative: the beads do not meet
laying_overlap_spots =
    How much neighbouring spots overlap, as a share of their diameter; it sets the spacing.
    Negative: the spots do not meet
laying_first_plane = First plane
laying_first_plane_centred = centred
laying_first_plane_tip = Above the lowest point of the surfaces, at most one spacing
laying_first_plane_name = first offset
laying_rim = Rim, joins, passes

## Starts of single surfaces

own_from = Surface { $surface } from
own_tip = Set for this surface, whatever its recipe and the job say
own_start = start of { $surface }
own_more = { $count ->
    [one] and { $count } more surface of its own
   *[other] and { $count } more surfaces of their own
}

## Units behind numbers

unit_mm = { " mm" }
unit_percent = { " %" }
unit_deg = { "°" }
