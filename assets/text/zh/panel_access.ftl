### 可达性图，以及沿扫描线的倾角。

## 图

access_no_place = 请步进到某个路径点，或将光标指向零件
access_at_target = 路径点处可达性：{ $percent }% 无干涉
access_under_cursor = 光标处可达性：{ $percent }% 无干涉
access_map = 可达性图
access_tilt = 前倾角 { $lead }°，侧倾角 { $lean }°：{ $what }
access_free = 无干涉
access_not_allowed = 该面的倾角规则不允许
access_blocked_by_surface = { $blocker }（面 { $surface }）
access_lead = 前倾角
access_lean = 侧倾角

## 图例

access_by_beam = 光束碰到
access_by_head = 激光头碰到
access_by_clamp = 碰到夹具
access_forbidden = 不允许
access_normal = + 法线
access_chosen = ○ 选定：{ $angle }°
access_no_target = 此处没有路径点
access_none_chosen = 受阻：未选定倾角
access_surface = 面 { $surface }

## 沿扫描线的倾角

access_strip = 沿扫描线的倾角
access_strip_image = 沿扫描线的倾角
access_needs_clearance = 要手动设定倾角，请将修正方式选为“避让”
access_drag = 从曲线处拖动，可优先采用其他倾角
access_remove_pins = 移除全部固定倾角
access_most = +{ $angle }°
access_length = { $length } mm
