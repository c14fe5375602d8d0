### 零件各个面的叫法。

surface_by_number = 面 { $number }
surface_by_name = 面 { $number }“{ $name }”
