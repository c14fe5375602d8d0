### What people call the surfaces of a part.

surface_by_number = surface { $number }
surface_by_name = surface { $number } "{ $name }"
