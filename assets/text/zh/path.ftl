### 面上的扫描线。

## 为何没有扫描线，或不完整
lines_spacing_not_positive = 行距不大于 0 时没有扫描线
lines_no_proper_facet = 所有面片都没有面积：请去掉此面
lines_no_plane_crosses = 没有截面与此面相交：请选择其他截面方向
lines_no_border = 此面是封闭的，没有可以等距的边界：请选择平面或螺旋
lines_no_such_border = 没有边界 { $border }：此面有 { $borders } 条边界；请选择其中一条，或选择整个轮廓
lines_none_fits = 此面太小，放不下一条扫描线：请去掉此面
lines_no_turn_fits = 行距为 { $mm } mm 时放不下一圈螺旋：请选择更小的行距或其他策略
lines_no_mean_normal = 此面没有平均法线，第二组扫描线无法绕其转动：请选择其他策略
lines_apart_from_border = 有 { $area } mm² 与该边界不相连：请选择整个轮廓
lines_beyond_spiral = 螺旋覆盖不到 { $area } mm²：请选择其他中心或其他策略

## 方向
direction_unknown = “{ $text }”不是方向：应为 x、y、z、auto 或三个数值 DX,DY,DZ
direction_no_length = 方向 { $text } 没有长度：应为不全为零的三个数值
