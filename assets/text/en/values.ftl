### What is wrong with the values of a job, and how they are shown.

## Numbers
number_with_unit = { $value } { $unit }
number_in_degrees = { $value }°
number_out_of_range = { $name } = { $value }: give a number from { $least } to { $greatest }
number_not_above = { $name } = { $value }: give a number above { $least }, up to { $greatest }
number_not_whole = { $name } = { $value }: give a whole number from { $least } to { $greatest }
number_range = { $least } to { $greatest }
overlap_out_of_range = overlap = { $percent }: give a number from { $least } to { $greatest } %

## Recipes
recipe_key_unknown = recipe "{ $recipe }": { $key } is not a number that a recipe can hold; the README lists those that can be set
recipe_in = recipe "{ $recipe }": { $what }
recipe_twice = there are two recipes named "{ $name }"; give one of them another name
recipe_missing = surface { $surface } has the recipe "{ $name }", which the job does not have (it has: { $known })
recipe_missing_all = surface { $surface } has the recipe "{ $name }", but the job has no recipes

## Beads
bead_half = bead.width_mm = { $width }, bead.height_mm = { $height }: give both above 0, or both 0 where nothing is laid
bead_layers_of_nothing = bead.layers = { $layers }: give bead.width_mm and bead.height_mm too; without a bead use layers.passes

## The rest of a job
dialect_unknown = dialect = "{ $name }": give one of { $known }
offset_outside = offset = { $offset }: give a number from 0 to the spacing ({ $spacing } mm), or centred; a wider strip at the rim would stay uncleaned
transform_of_scan = scan.transform { $what }

## Recipes side by side
compared_strategy = Strategy
compared_direction = Direction
compared_order = Lines
compared_start = Starts from
compared_sense = Spiral runs
compared_centre = Spiral centre
compared_number = { $label }, { $unit }
compared_middle = middle
