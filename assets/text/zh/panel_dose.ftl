### 剂量数值。

## 着色方式

dose_panel_heading = 剂量
dose_panel_shown = 显示剂量
dose_panel_by_dose = 剂量
dose_panel_by_incidence = 入射角
dose_panel_by_surface = 面

## 尚无剂量时

dose_panel_computing = 正在计算剂量
dose_panel_no_plan = 等待最新的规划
dose_panel_not_computed = 未计算；请关闭并重新打开此面板再试

## 色标和比例

dose_panel_scale = 色标
dose_panel_j_cm2 = { $dose } J/cm²
dose_panel_kj_cm2 = { $dose } kJ/cm²
dose_panel_angle = { $angle }°
dose_panel_within = { $percent }% 在窗口内
dose_panel_under = { $percent }% 低于窗口
dose_panel_over = { $percent }% 高于窗口
dose_panel_shaded = { $percent }% 被遮挡
dose_panel_window = 窗口 { $low } 至 { $high }
dose_panel_histogram = 剂量直方图
dose_panel_histogram_note = 所选面积按剂量的分布；竖线：窗口

## 单击处

dose_panel_clicked = 单击处
dose_panel_click = 单击零件，查看哪些道照射到该处
dose_panel_place = 面 { $surface }，{ $place }：{ $dose }
dose_panel_no_beam = 没有光束照射到该处
dose_panel_hit = 第 { $pass } 道，{ $time }，{ $angle }°，{ $dose }
dose_panel_go_to_pass = 转到该道

## 未洗净处和误照射

dose_panel_not_cleanable = 无法清洗：{ $area } cm²
dose_panel_too_little = 剂量不足：{ $area } cm²
dose_panel_put_aside = 移到第二列表
dose_panel_put_aside_tip = 这些部位成为单独的面，留待其他作业处理，不参与规划
dose_panel_patch = 面 { $surface } 的 { $area } cm²：{ $why }
dose_panel_show = 显示该处
dose_panel_smaller = 另有 { $count } 处较小的
dose_panel_beside = 所选面以外：{ $area } mm²
dose_panel_beside_over = 超过 { $dose }
dose_panel_beside_surface = 面 { $surface }：{ $area } mm²，最大 { $dose }
