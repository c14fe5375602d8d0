### The recipe of the selected surfaces, and the library of recipes.

## Recipe of a surface

recipe_panel_none = Recipe of a surface
recipe_panel_one = Recipe of surface { $surface }
recipe_panel_many = { $count ->
    [one] Recipe of { $count } surface
   *[other] Recipe of { $count } surfaces
}
recipe_panel_titled = { $whose }: { $name }
recipe_panel_several = several
recipe_panel_select = Select surfaces to give them values of their own
recipe_panel_different = They have different recipes: give them one here, or compare them
recipe_panel_recipe = Recipe
recipe_panel_recipe_name = recipe
recipe_panel_jobs = none: the job's values
recipe_panel_new = a new one
recipe_panel_new_name = Recipe { $number }
recipe_panel_copy = Copy from surface…
recipe_panel_copy_row = surface { $surface }: { $recipe }
recipe_panel_others = { $count ->
    [one] Changes apply to surface { $surfaces } too
   *[other] Changes apply to surfaces { $surfaces } too
}
recipe_panel_change_makes = Changing a value here makes a new recipe
recipe_panel_keep = Save to my recipes
recipe_panel_remove = Remove from the job
recipe_panel_remove_tip = Its surfaces take the job's values
recipe_panel_name = Name
recipe_panel_name_field = recipe name
recipe_panel_note = Note
recipe_panel_note_field = recipe note
recipe_panel_of_surface = surface { $surface }: { $what }
recipe_panel_spacing = spacing { $least } to { $greatest } mm (wanted { $wanted })
recipe_panel_more = More values
recipe_panel_more_own = More values ({ $count } of its own)

## Library

library_title = Recipe library
library_how = Drag a recipe onto a surface's row, or apply it to the selected surfaces
library_in_job = In this job
library_mine = My recipes
library_shipped = Shipped
library_job_word = job
library_mine_word = mine
library_shipped_word = shipped
library_none = none yet
library_compare = Compare…
library_compare_tip = Recipes side by side
library_removed = Removed { $name }
library_undo = Undo
library_undo_name = bring the removed recipe back
library_apply = Apply
library_apply_name = apply { $shelf } recipe { $name }
library_apply_tip = To the selected surfaces
library_duplicate = Duplicate
library_duplicate_name = duplicate recipe { $name }
library_duplicate_tip = Make a copy with a new name
library_remove_name = remove { $shelf } recipe { $name }
library_remove_job_tip = Remove it from the job; its surfaces take the job's values
library_remove_mine_tip = Remove it from my recipes
library_saved = saved { $file }
library_dragged = recipe { $name }
