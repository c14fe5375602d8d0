### The lists of surfaces, and recipes side by side.

## Lists

lists_feature_surfaces = Feature surfaces
lists_to_clean = To clean
lists_filter = filter
lists_filter_surfaces = filter surfaces
lists_filter_clean = filter the list to clean
lists_shown = { $shown } of { $whole }
lists_number = No.
lists_shape = Shape
lists_area = Area mm²
lists_row = surface { $surface } { $label }
lists_name = surface name
lists_recipe = surface { $surface } has recipe { $recipe }
lists_blocked = blocked
lists_missed = missed
lists_corrected = corrected
lists_planned = planned
lists_clean = ▼ To clean
lists_back = ▲ Back
lists_earlier = Earlier
lists_later = Later

## Put aside

later_heading = Later ({ $count })
later_back = Back
later_back_name = take surface { $surface } back
later_back_tip = No longer put aside
later_clean = To clean
later_clean_name = clean surface { $surface } after all
later_clean_tip = Clean it in this job
later_area = { $area } mm²
later_row = put aside: surface { $surface } { $label }

## Comparison of recipes

compare_title = Compare recipes
compare_too_few = Choose two or more
compare_no_difference = They do not differ
compare_own = the job's own values
compare_own_column = job's own
compare_recipe = { $name } ({ $shelf })
compare_recipe_name = compare { $shelf } recipe { $name }
compare_all_rows = also rows that do not differ
compare_cell = { $label } { $value }
