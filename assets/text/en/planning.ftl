### What planning finds, and why there is no plan.

stage_panicked = a fault in the program: { $words }
part_changed = the part's file is not the one that the job was made for
