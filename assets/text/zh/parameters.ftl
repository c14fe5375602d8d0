### 操作人员设定的数值：作业文件中的键（点改为下划线）、标签及含义。

## 特征面

surfaces_angle_deg = 分割角
    .meaning = 两侧面片的夹角达到此值的边将特征面分开
surfaces_min_area_mm2 = 碎面并入上限
    .meaning = 面积小于此值的面并入交界最平滑的相邻面；0 = 关闭
surfaces_hysteresis_deg = 滞后角
    .meaning = 达到此角度的边若与折边相连，也作为折边；0 = 关闭

## 扫描线

layers_spacing_mm = 行距
    .meaning = 相邻截面之间的距离；在斜面上扫描线间距更大
layers_cross_deg = 交叉角
    .meaning = 交叉策略中两组扫描线之间的夹角
layers_inset_mm = 内缩
    .meaning = 扫描线距面的边缘向内留出的距离；负值为越过边缘继续延伸的距离，到零件尽头为止
layers_ignore_holes_mm = 最小计入孔宽
    .meaning = 扫描线直接越过比此值窄的孔，不受内缩影响
layers_join_mm = 桥接断口上限
    .meaning = 同一扫描线上相距不超过此值的各段连成一道，断口处关光；0 = 关闭
layers_shortest_mm = 舍弃短段
    .meaning = 比此值短的扫描线段舍弃；0 = 不舍弃
layers_seam_shift_mm = 起点错开
    .meaning = 每条闭合扫描线的起点比前一条的起点后移的距离；0 = 从行程最短处开始
layers_passes = 遍数
    .meaning = 每个面加工的遍数

## 熔道

bead_width_mm = 熔道宽度
    .meaning = 熔道根部的宽度；0 = 不熔覆
bead_height_mm = 熔道高度
    .meaning = 熔道的高度，也是每层的高度；0 = 不熔覆
bead_layers = 层数
    .meaning = 叠加熔覆的层数，每层都按已堆高的零件规划
bead_start_shift_mm = 层间错开
    .meaning = 闭合扫描线的起点比其在前一层的起点后移的距离

## 光束、路径点、倾角

beam_defocus_mm = 离焦量
    .meaning = 焦点沿光束方向高出面的距离
path_chord_error_mm = 弦高误差
    .meaning = 面偏离两个路径点间直线运动的最大允许距离
path_max_step_mm = 最大步长
    .meaning = 两个路径点之间的最大运动距离
path_max_turn_deg = 最大转角
    .meaning = 两个路径点之间面法线的最大转角
beam_speed_mm_s = 速度
    .meaning = 光斑在零件上的速度
beam_air_speed_mm_s = 空行速度
    .meaning = 关光时焦点的速度
beam_power_w = 功率
    .meaning = 激光功率；写在程序开头，工作站有相应输出信号时由该信号设定
beam_frequency_khz = 脉冲频率
    .meaning = 激光脉冲的频率，写出和设定的方式与功率相同；0 = 无，或以激光器上的设定为准
beam_spot_mm = 光斑直径
    .meaning = 光斑在零件上的直径
path_max_tilt_deg = 最大倾角
    .meaning = 光束与面法线的最大夹角，用于避让搜索，以及所有带激光头的规划
beam_margin_mm = 安全裕量
    .meaning = 光锥和激光头与其他一切物体的最小距离；给定激光头后生效
path_standoff_mm = 工作距离调节范围
    .meaning = 扫描线原本受阻时，激光头可后退或前移的距离；0 = 不调节
path_tilt_rate_deg_mm = 倾角变化率
    .meaning = 避让搜索时，光束相对面法线的倾角沿扫描线变化的最大速率
path_tilt_rate_deg_s = 倾角速度
    .meaning = 按编程速度运动时，光束相对面法线的倾角变化的最大速度
optics_lens_to_focus_mm = 透镜到焦点
    .meaning = 最后一片镜片到焦点的距离；光锥从该镜片开始
optics_aperture_mm = 通光口径
    .meaning = 光束在最后一片镜片处的直径
optics_focus_spot_mm = 焦点光斑
    .meaning = 光束在焦点处的直径
optics_rayleigh_mm = 瑞利长度
    .meaning = 光斑扩大到 1.41 倍之处与焦点的距离
optics_wavelength_nm = 波长
    .meaning = 激光的波长；只影响光束质量 M²
path_lead_in_mm = 引入段
    .meaning = 光斑在扫描线之前关光起步的距离，使出光时已达到速度
path_lead_out_mm = 引出段
    .meaning = 光斑在扫描线末端之后关光、以编程速度继续前进的距离

## 零件、剂量、工作站

part_placement_scale = 缩放系数
    .meaning = 零件尺寸的系数，在单位换算之外另乘
dose_line_mm = 扫描宽度
    .meaning = 扫描线在垂直于行进方向上的宽度；光斑轮廓为线形（line）时有效
dose_low_j_cm2 = 最小剂量
    .meaning = 低于此值时面清洗不干净；0 = P/(v·d) 的一半
dose_high_j_cm2 = 最大剂量
    .meaning = 高于此值时会损伤面；0 = P/(v·d) 的两倍
dose_collateral_j_cm2 = 误照射剂量
    .meaning = 未选中的面允许受到的剂量；0 = P/(v·d) 的十分之一
cell_deviation_mm = 光斑偏差
    .meaning = 法兰作直线运动时，光斑可偏离其扫描线的距离；超出时增加路径点

## 扫描数据

scan_min_depth_mm = 缺损区阈值
    .meaning = 相对模型缺料或多料超过此值之处，视为零件的缺损区
scan_gate_mm = 最大偏差
    .meaning = 与模型的偏差超过此值的零件不予规划，因为可能不是同一零件；0 = 不限
scan_tolerance_mm = 公差
    .meaning = 向任一侧偏离模型不超过此值的点，视为位置正确
weld_even_light_px = 匀光窗口
    .meaning = 用来求像素周围光照的窗口宽度；0：光照均匀
weld_smoothing_px = 平滑
    .meaning = 取阈值之前图像平滑的程度
weld_sigmas = 高出母材表面的阈值
    .meaning = 灰度比直方图主峰高出此倍数标准差之处，算作区域
weld_opening_px = 开运算
    .meaning = 比此值窄的不算作区域
weld_closing_px = 闭运算
    .meaning = 区域中比此值窄的缝隙予以填补
weld_least_area_px = 最小面积
    .meaning = 像素数少于此值的区域舍弃
weld_pass_depth_mm = 每道深度
    .meaning = 每道的去除量；焊道高度除以此值即为道数
weld_at_once = 每次道数
    .meaning = 一个程序包含的道数；磨完后由下一组图像得出剩余量
weld_residual_mm = 残留高度
    .meaning = 焊道磨到此高度为止
weld_below_mm = 允许下凹量
    .meaning = 打磨低于焊道周围表面的深度不得超过此值
weld_removal_share = 去除量偏差
    .meaning = 某道的去除量比规划多或少达到此比例时，下一道须等待确认
weld_lead_deg = 前倾角
    .meaning = 用边缘打磨的砂轮片向前倾斜的角度
weld_arc_mm = 切入圆弧
    .meaning = 工具切入和离开表面时所走圆弧的半径
weld_force_n = 接触力
    .meaning = 工具作用在零件上的力
weld_gouge_mm = 允许过切量
    .meaning = 工具在接触处旁可切入零件的深度，用于容纳弦高误差和面片误差
weld_acceleration_mm_s2 = 加速度
    .meaning = 工具的加速度，用于计算单向、往复和螺旋策略的时间
