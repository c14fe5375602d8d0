### 工具：激光头、光学参数、夹具、倾角，以及剂量计算的依据。

## 激光头

tool_head = 激光头
tool_head_tip = 有激光头时，光束按光锥计算，光锥和激光头与一切物体保持安全裕量；没有时按光线计算
tool_head_none = 无：按光线计算
tool_open_head = 打开激光头…
tool_open_head_tip = 由圆柱和圆锥叠成的文件（TOML），或 STL、OBJ、PLY、3MF 文件
tool_remove_head = 移除激光头
tool_head_of_facets = 由面片构成的激光头，按其绕光束旋转一周扫过的实体计算
tool_edit_head = 编辑…
tool_edit_head_tip = 用圆柱和圆锥按比例拼成激光头，或从样例开始
head_title = 激光头
head_drawing = 激光头侧视图，按比例
head_begin_with = 从样例开始：
head_fixed_optic = 细长光学头
head_scan_head = 振镜头
head_cladding_nozzle = 熔覆喷嘴
head_sample_tip = 该类激光头的示例。请测量自己的激光头并修改数值
head_how = 高度从焦点算起，沿光束向上。粗线为工件表面。
head_add = 添加一段
head_add_tip = 在最后一段之上添加一段圆柱
head_from = 起
head_to = 止
head_radius_from = 下端半径
head_radius_to = 上端半径
head_number_name = 第 { $number } 段：{ $what }
head_remove = 移除此段
head_remove_name = 移除第 { $number } 段
head_keep = 保存并使用…
head_keep_tip = 将激光头写入单独的文件，由作业使用

## 光学参数

tool_optics = 光学参数
tool_m_squared = M² = { $value }
tool_spot = D = { $defocus } mm 处的光斑：{ $spot } mm
tool_tolerance = D = { $from } 至 { $to } mm 时偏差不超过 10%
tool_spot_is_set = 光斑设定值为 { $spot } mm
tool_take_spot = 采用 { $spot } mm
tool_take_spot_tip = 由这些光学参数得到的光斑
tool_take_defocus = D = { $defocus } mm
tool_focus_in_part = 焦点在零件内部
tool_focus_above = 焦点在面的上方
tool_too_narrow = 小于焦点处的光斑：任何 D 都达不到

## 夹具

tool_clamps = 夹具
tool_clamp = { $number } { $file }
tool_remove_clamp = 移除此夹具
tool_add_clamp = 添加夹具…
tool_add_clamp_tip = 夹具文件（STL、OBJ、PLY 或 3MF），采用零件坐标系
handles_move = 在视图中移动
tool_clamp_move_tip = 用视图中的箭头和圆环移动和转动夹具，步距 0.5 mm 和 1°
tool_clamp_move_name = 在视图中移动夹具 { $number }
tool_clamp_put = 放到面上…
tool_clamp_put_tip = 单击面、边或孔：夹具的原点放在该处，其 z 轴朝零件外
tool_clamp_put_name = 将夹具 { $number } 放到面上
tool_clamp_units = 单位
tool_clamp_units_name = 夹具 { $number } 的单位：{ $unit }
tool_clamp_at = 位置
tool_clamp_turned = 旋转
tool_clamp_field = 夹具 { $number } { $axis }

## 倾角

tool_tilt = 倾角
tool_tilt_select = 选中一个面，可单独设定其倾角
tool_tilt_surface = 面 { $surface }
tool_lead = 前倾角
tool_lead_tip = 优先采用的倾角，朝行进方向为正
tool_lean = 侧倾角
tool_lean_tip = 优先采用的倾角，朝行进方向右侧为正
tool_least_tilt = 最小倾角
tool_least_tilt_tip = 光束与法线的夹角始终不小于此值，以免反射光返回光学系统
tool_never_to = 禁止朝向
tool_never_to_tip = 光束不得倾向的各侧
tool_ahead = 前
tool_behind = 后
tool_left = 左
tool_right = 右

## 剂量

tool_dose = 剂量
tool_profile = 功率分布
tool_profile_tip = 功率在光斑内的分布方式
