### 作业参数值的错误，以及数值的显示方式。

## 数值
number_with_unit = { $value } { $unit }
number_in_degrees = { $value }°
number_out_of_range = { $name } = { $value }：请给出 { $least } 到 { $greatest } 之间的数
number_not_above = { $name } = { $value }：请给出大于 { $least }、不超过 { $greatest } 的数
number_not_whole = { $name } = { $value }：请给出 { $least } 到 { $greatest } 之间的整数
number_range = { $least } 到 { $greatest }
overlap_out_of_range = overlap = { $percent }：请给出 { $least } 到 { $greatest } % 之间的数

## 工艺配方
recipe_key_unknown = 工艺配方“{ $recipe }”：{ $key } 不是工艺配方可以包含的数值；可设置的项目见 README
recipe_in = 工艺配方“{ $recipe }”：{ $what }
recipe_twice = 有两个工艺配方都名为“{ $name }”；请重命名其中一个
recipe_missing = 面 { $surface } 使用工艺配方“{ $name }”，但作业中没有（现有：{ $known }）
recipe_missing_all = 面 { $surface } 使用工艺配方“{ $name }”，但作业中没有任何工艺配方

## 熔道
bead_half = bead.width_mm = { $width }，bead.height_mm = { $height }：两者都应大于 0；不熔覆时两者都为 0
bead_layers_of_nothing = bead.layers = { $layers }：还须给出 bead.width_mm 和 bead.height_mm；没有熔道时请用 layers.passes

## 作业的其他内容
dialect_unknown = dialect = "{ $name }"：请给出 { $known } 之一
offset_outside = offset = { $offset }：请给出 0 到行距（{ $spacing } mm）之间的数，或 centred；否则边缘会留下更宽的未清洗带
transform_of_scan = scan.transform { $what }

## 工艺配方比较
compared_strategy = 策略
compared_direction = 截面方向
compared_order = 扫描线
compared_start = 起始于
compared_sense = 螺旋走向
compared_centre = 螺旋中心
compared_number = { $label }（{ $unit }）
compared_middle = 面的中心
