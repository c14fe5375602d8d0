### 选项的名称。文件和命令行中使用的词不在此列。

## 策略

choice_planes = 平面
choice_adaptive = 自适应
choice_offset = 等距
choice_spiral = 螺旋
choice_cross = 交叉
choice_planes_hint = 间隔相同的平行平面
choice_adaptive_hint = 平面，斜坡处加密
choice_offset_hint = 沿边界的扫描线
choice_spiral_hint = 一条扫描线，始终出光
choice_cross_hint = 两组相互交叉的扫描线

## 扫描线

choice_direction_auto = 自动
choice_zigzag = 往复
choice_one_way = 单向
choice_shortest = 最短
choice_inwards = 向内
choice_outwards = 向外

## 光束

choice_correction_none = 无
choice_correction_section_plane = 截面
choice_correction_clearance = 避让
choice_gaussian = 高斯
choice_top_hat = 平顶
choice_line = 线形

## 零件和工作站

choice_mm = mm
choice_m = m
choice_inch = 英寸
choice_weld_auto = 舍入误差以内
choice_weld_auto_about = 开放边上只相差舍入误差的顶点，若合并后可使边闭合，则合为一个顶点
choice_weld_exact = 仅坐标相同
choice_weld_exact_about = 只有坐标相同的顶点才合为一个顶点
choice_spin_free = 自由
choice_spin_travel = 随行进方向
