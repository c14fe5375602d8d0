### What is wrong with a plan or a part's file, and the legend of the achieved spacing.

## Problems

problems_heading = Problems
problems_out_of_date = Problems: out of date
problems_none = Problems: none
problems_count = Problems ({ $count })
problems_found = Found in the part's file
problems_alike = { $count } more like these
problems_beam_hits = the beam hits surface { $surface } (facet { $facet })
problems_beam_hits_something = the beam hits something
problems_head_hits = the head hits surface { $surface } (facet { $facet })
problems_head_hits_something = the head hits something
problems_tool_hits = the tool hits surface { $surface } (facet { $facet })
problems_tool_hits_something = the tool hits something
problems_left_out = left out
problems_go = Go there
problems_show = Show it
problems_use_changed_scan = Use the changed scan
problems_use_changed_scan_tip = Takes the file as it is now; where the scan lies is looked for again
problems_use_changed_image = Use the changed image
problems_use_changed_image_tip = Takes the file as it is now; what was painted and chosen on the images goes

## What casts doubt on the part

file_treat_as_mm = Treat as millimetres
file_treat_as_m = Treat as metres
file_treat_as_inch = Treat as inches
file_absorb = Absorb islands below { $below } mm²
file_dismiss = Dismiss
file_dismiss_tip = It stays in the list of problems

## What would help

problems_help = What would help
problems_help_looking = looking for what would help…
problems_help_cancelled = the search was cancelled; { $keys } plans and searches again
problems_help_none = No single change that was tried helps
problems_help_undo = Changes the job and plans again; Undo takes it back

## Achieved spacing

spacing_legend = Achieved spacing
spacing_legend_none = no two lines lie side by side
spacing_legend_scale = scale of the spacing
spacing_legend_closer = closer
spacing_legend_wanted = as wanted
spacing_legend_farther = farther
spacing_legend_least = least { $mm } mm on surface { $surface }
spacing_legend_greatest = greatest { $mm } mm on surface { $surface }
spacing_legend_percent = % of the spacing wanted on each surface
