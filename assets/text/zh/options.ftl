### `plan` 的选项及其问题。需要输入的词在任何语言中都保持不变。

## 选项的含义
option_number = { $meaning } [默认：{ $default }]
option_units = 文件的单位：mm、m 或 inch [默认：文件声明的单位，否则为 mm]
option_weld = 顶点焊接：auto（相同的顶点；为闭合开放边，也包括只差舍入误差的顶点）或 exact（仅相同的顶点）[默认：auto]
option_surfaces = 待清洗的面，按加工顺序：all，或编号，如 4,1 [默认：all]
option_direction = 截面的法线：x、y、z、auto 或 DX,DY,DZ；auto 为每个面选取合适的方向 [默认：auto]
option_strategy = 扫描线：planes、adaptive、offset、spiral 或 cross [默认：planes]
option_overlap = 相邻光斑（有熔道时为相邻熔道）的搭接率，百分比，用来代替行距
option_offset = 第一个截面高出最低点的距离，mm，或 centred [默认：centred]
option_order = 扫描线的顺序：zigzag、one-way 或 shortest [默认：zigzag]
option_correction = 干涉的处理方式：section-plane、clearance 或 none [默认：section-plane]
option_head = 激光头：TOML 列表（part：from_mm to_mm r0_mm r1_mm，从焦点算起），或 STL、OBJ、PLY 或 3MF 文件 [默认：仅光线]
option_cell = 工作站文件 [默认：机器人自带的工作站]
option_robot = 机器人：{ $shipped }，或机器人文件 [默认：无，仅位姿]
option_mount = 机器人手持的对象：part-in-hand 或 tool-in-hand [默认：part-in-hand，或按工作站文件]
option_dialect = 程序：{ $dialects } [默认：nachi]
option_spin = 绕光轴转角：free 或 travel [默认：free]

## 可以给出的值
give_number = 应为数值
give_units = 应为 mm、m 或 inch
give_weld = 应为 auto 或 exact
give_surfaces = 应为 all，或面的编号，如 4,1
give_surface_once = 面 { $surface } 在列表中出现两次；只能写一次
give_direction = 应为 x、y、z、auto 或不全为 0 的三个数值 DX,DY,DZ
give_strategy = 应为 planes、adaptive、offset、spiral 或 cross
give_offset = 应为以 mm 计的数值，或 centred
give_order = 应为 zigzag、one-way 或 shortest
give_correction = 应为 section-plane、clearance 或 none
give_mount = 应为 part-in-hand 或 tool-in-hand
give_spin = 应为 free 或 travel
