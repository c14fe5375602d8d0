### 作业和工艺配方的输入项：名称，以及路径的各输入项。

## 朗读名称时，输入项的归属

field_of_recipe = 工艺配方：{ $what }
field_of_surface = 面：{ $what }
field_reset = 重置{ $what }
field_not_taken = 未采用“{ $text }”：请输入 { $least } 至 { $greatest }
field_back = 恢复为 { $to }
field_back_to_job = 恢复为作业的值 { $to }
field_back_to_recipe_or_job = 恢复为工艺配方或作业的值

## 路径

laying_heading = 分层
laying_strategy = 策略
laying_strategy_tip = 扫描线在面上的布置方式
laying_strategy_name = 策略
laying_strategy_row = { $strategy } – { $hint }
laying_direction = 截面方向
laying_direction_tip = 截面的法线方向；auto（自动）为每个面选取合适的方向
laying_direction_name = 截面方向
laying_direction_choice = 截面方向：{ $direction }
laying_vector = 方向矢量
laying_vector_name = 方向矢量 { $axis }
laying_lines = 扫描线
laying_lines_tip = 扫描线的加工顺序，以及每条线的走向
laying_in_turn = 依次
laying_order_name = 顺序
laying_order_choice = 顺序：{ $order }
laying_start_from = 起始于
laying_start_from_tip =
    轮廓的各环从最长的开始编号，最长的为 1。
    要选取某一环，请在零件上靠近该环处右击：从此边界等距
laying_whole_outline = 整个轮廓
laying_border_name = 边界
laying_border_prefix = { "边界 " }
laying_spiral_runs = 螺旋走向
laying_spiral_name = 螺旋走向
laying_centre = 中心
laying_centre_tip = 在零件上右击：以此处为螺旋中心
laying_centre_name = 中心
laying_centre_middle = 面的中心
laying_centre_how = 在零件上右击可设定
laying_overlap = 搭接率
laying_overlap_beads =
    相邻熔道的搭接量占熔道宽度的比例；行距由此确定。
    负值：熔道互不相接
laying_overlap_spots =
    相邻光斑的搭接量占光斑直径的比例；行距由此确定。
    负值：光斑互不相接
laying_first_plane = 首个截面
laying_first_plane_centred = 居中
laying_first_plane_tip = 距各面最低点的高度，最大为一个行距
laying_first_plane_name = 首个截面的偏移
laying_rim = 边缘、衔接、遍数

## 单个面的起点

own_from = 面 { $surface } 起始于
own_tip = 为该面单独设定，优先于其工艺配方和作业中的设定
own_start = 面 { $surface } 的起点
own_more = 另有 { $count } 个单独设定的面

## 数值后的单位

unit_mm = { " mm" }
unit_percent = { " %" }
unit_deg = { "°" }
