### 扫描数据在模型上的位置，以及零件与模型的偏差。

## 变换矩阵文件
transform_json = { $file }：第 { $line } 行：{ $reason }；请提供含 model_from_scan 的 JSON，十六个数逐行排列，格式与 register --json 的输出相同
transform_matrix = { $file }：model_from_scan { $fault }
matrix_not_finite = 含有非有限数值
matrix_last_row = 末行不是 0 0 0 1；请逐行书写
matrix_scales = 带有 { $factor } 倍缩放；请先统一扫描数据与零件的单位
matrix_shears = 不是旋转矩阵：各行互不垂直，或有效位数太少；请至少给出七位
matrix_mirrors = 含有镜像；请在生成该矩阵的软件中将一个轴反向

## 扫描数据无法定位的原因
register_no_model = 零件没有面积大于零的面片，扫描数据无法配准
register_too_few_points = 参与配准的点有 { $found } 个，需要 { $needed } 个；请少排除一些点，或重新扫描
register_pairs = { $pairs } 对点无法确定位置：请给出至少三对不在一条直线上的点
register_not_same_part = 这不是该零件的扫描数据：在最佳位置，点的偏差为 { $sigma } mm（不超过 { $limit } mm 才可视为噪声），{ $overlap } % 的点落在零件上；请换用正确的零件；如果零件无误，请给出三对点
scan_unit_doubt = 扫描数据的对角线长 { $cloud } mm，零件的对角线长 { $part } mm：其中之一的单位有误；{ $advice }
scan_unit_cloud = 扫描数据的单位若为 { $units }，则两者相符
scan_unit_part = 零件的单位若为 { $units }，则两者相符
scan_unit_both = 扫描数据的单位若为 { $cloud_units }，或零件的单位若为 { $part_units }，则两者相符

scan_changed = { $file }：与创建作业时所用的扫描数据不同；请恢复原文件，或改用此文件（在窗口中，或用 --scan）
scan_matrix = [scan] 中的 transform { $fault }
scan_gate_missing = ({ $x }, { $y }, { $z }) 处缺损 { $depth } mm，超过作业允许的 { $gate } mm：请检查是否为同一零件、位置是否正确；如果无误，请提高允许值
scan_gate_surplus = ({ $x }, { $y }, { $z }) 处多出 { $depth } mm，超过作业允许的 { $gate } mm：请检查是否为同一零件、位置是否正确；如果无误，请提高允许值
scan_layers = 相对于缺损深度，熔道太低：填满需要 { $layers } 层，最多可规划 1000 层；请加大熔道高度

## 定位情况
register_found = 均方根偏差 { $rms } mm，噪声 { $noise } mm；{ $overlap } % 的点落在零件上，零件的 { $coverage } % 已扫描
register_slides = 位置不定：{ $motion }{ $axis }没有约束，保持原值；请给出点对，或补扫能起约束作用的部位
register_weak = 约束不足：{ $motion }{ $axis }，误差可达 { $slack } mm
motion_turn = 绕轴转动
motion_shift = 沿轴平移
motion_screw = 绕轴螺旋运动
scan_axis = （轴向 ({ $x }, { $y }, { $z })，过点 ({ $px }, { $py }, { $pz })）
register_rivals_same = 零件对称，另有 { $rivals } 个等效位置
register_rival = 另一位置同样吻合（均方根偏差 { $rms } mm）
register_rival_telling = 另一位置同样吻合（均方根偏差 { $rms } mm）；两者在 ({ $x }, { $y }, { $z }) 附近相差最大，达 { $difference } mm
register_wear = 配准时已排除磨损部位；若计入，配准结果会偏移 { $moved } mm
register_placed = 零件在基座坐标系中的位置由 { $markers } 个标记点确定，最大偏差 { $worst } mm

## 标记点
markers_too_few = { $count ->
    [0] 没有共用的标记点
   *[other] 共用的标记点只有 { $count } 个
}：请给出至少三个不在一条直线上的标记点
markers_on_a_line = 标记点都在一条直线上，绕该直线的转动无法确定；请在直线外增加一个标记点
marker_no_number = 标记点 { $marker } 的坐标不是数值

## 零件与模型的偏差
deviation_points = 零件上有 { $points } 个点，均方根偏差 { $rms } mm，平均偏差 { $mean } mm；另有 { $off } 个点不属于零件
deviation_unscanned = 零件有 { $area } cm² 没有扫描点，该处状况未知
deviation_none = 各处偏差均不超过 { $threshold } mm
deviation_missing = 最深 { $depth } mm，位于 ({ $x }, { $y }, { $z })：缺损面积 { $area } mm²，缺损体积 { $volume } mm³
deviation_surplus = 最高 { $depth } mm，位于 ({ $x }, { $y }, { $z })：多余面积 { $area } mm²，多余体积 { $volume } mm³
deviation_layers = { $layers ->
    [1] { $layers } 层可填满，层高 { $last } mm
   *[other] { $layers } 层可填满，最后一层高 { $last } mm
}
deviation_too_small = 有 { $patches } 处缺损区太小，以扫描数据的点密度无法分辨
scan_not_placed = 扫描数据未用于工作站：扫描仪的位置未知，请给出其坐标系，或机器人触测过的标记点
scan_slack = 零件的实际位置与扫描所得可能相差 { $slack } mm：激光头和手臂（如已知）在安全裕量之外再留 { $slack } mm
scan_no_surface = { $points } 个点不足以构成面片；请多扫描一些零件表面
scan_too_wide = 有些点离其余的点太远，无法用一个面连接所有的点：请先在扫描软件中裁掉这些点

## 面在损伤处的延续
scan_damage = 损伤 { $number }：{ $what }
continue_no_region = 没有可延续的区域
continue_too_few = 完好区域只有 { $points } 个点，不足以确定一个面：请扩大区域
continue_other_kind = 完好区域不是这种类型的面：其中的点与最佳拟合面偏差 { $rms } mm；请选择其他类型，或缩小区域
continue_no_such_kind = 由完好区域得不出这种类型的面：请选择其他类型，或扩大区域
continue_arc_too_short = 完好区域包含的圆弧太短（弓高 { $rise } mm）：请多标记一些圆弧
continue_axis_open = 由完好区域得出的轴线方向不确定，偏差可达 { $spread }°：请沿轴线多标记一段
continue_gap = 损伤跨度太大，延续面的精度只有 { $spread } mm：请在损伤的更多侧标记完好区域

## 按重叠区域拼合的扫描数据
overlap_found = { $file }：{ $overlap } % 的点落在前面的扫描数据上，均方根偏差 { $rms } mm
overlap_too_few = 有 { $found } 个点，拼合扫描数据需要 { $needed } 个
overlap_none = 在最佳位置，{ $overlap } % 的点落在前面的扫描数据上，或有过多的点偏离其表面：扫描时请保证三分之一的面积重叠，或给出标记点
overlap_far = 与前面的扫描数据吻合的位置距给定位置 { $moved } mm、{ $turned }°，相差太大：请给出更准确的位置，或给出标记点
overlap_ambiguous = 与前面的扫描数据吻合的位置有 { $poses } 个：请多扫描一些重叠部分，或给出标记点
