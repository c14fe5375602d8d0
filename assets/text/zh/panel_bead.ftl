### 光束熔覆的内容：尺寸、层和熔道截面。

## 组

bead_panel_none = 熔道：无
bead_panel_one_layer = 熔道：{ $width } × { $height } mm
bead_panel_layers = 熔道：{ $width } × { $height } mm，{ $layers } 层
bead_panel_metal = 金属
bead_panel_lay = 熔覆
bead_panel_lay_tip = 熔覆：光束在零件上堆出熔道
bead_panel_name = 熔道
bead_panel_back_none = 无
bead_panel_size = { $width } × { $height } mm
bead_panel_second = 每隔一层
bead_panel_across = 与其他层垂直
bead_panel_across_tip = 截面转 90°；等距线和螺旋线在各层中走向相同

## 填满一层的行距、高度或宽度

bead_panel_filled = 熔道恰好填满与其自身等高的一层（P3）
bead_panel_not_filled = 金属量可堆高 { $mean } mm，而层高规划为 { $planned } mm。要恰好填满，请设置：
bead_panel_spacing = 行距 { $mm } mm
bead_panel_height = 高度 { $mm } mm
bead_panel_width = 宽度 { $mm } mm
bead_panel_spacing_tip = 设置中心距，熔道保持不变（P3 4.1）
bead_panel_height_tip = 设置熔道高度，其宽度和行距保持不变（P3 4.1）
bead_panel_width_tip = 设置熔道宽度，其高度和行距保持不变（P3 4.1）
bead_panel_take_spacing = 采用行距 { $mm } mm
bead_panel_take_height = 采用高度 { $mm } mm
bead_panel_take_width = 采用宽度 { $mm } mm

## 截面

bead_section_told = 熔道截面：宽度 ω { $width } mm，高度 h { $height } mm，中心距 c { $centres } mm，搭接率 η { $overlap } %，波纹高度 r { $ripple } mm，堆积高度 { $build_up } mm
bead_section_width = 宽度 ω
bead_section_height = 高度 h
bead_section_centres = 中心距 c
bead_section_overlap = 搭接率 η
bead_section_ripple = 波纹高度 r
bead_section_build_up = 堆积高度
bead_section_mm = { $value } mm
bead_section_percent = { $value } %
bead_section_tip =
    按比例绘制，垂直于扫描线。
    轮廓由圆弧构成：流入凹谷的金属未计入
bead_section_drawn = 共 { $layers } 层，绘出 { $drawn } 层
bead_section_alternate = 方向垂直的层也按同向绘出
