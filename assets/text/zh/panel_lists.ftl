### 面的列表，以及工艺配方的比较。

## 列表

lists_feature_surfaces = 特征面
lists_to_clean = 待清洗列表
lists_filter = 筛选
lists_filter_surfaces = 筛选面
lists_filter_clean = 筛选待清洗列表
lists_shown = { $shown } / { $whole }
lists_number = 编号
lists_shape = 形状
lists_area = 面积 mm²
lists_row = 面 { $surface } { $label }
lists_name = 面的名称
lists_recipe = 面 { $surface } 采用工艺配方 { $recipe }
lists_blocked = 受阻
lists_missed = 漏扫
lists_corrected = 已修正
lists_planned = 已规划
lists_clean = ▼ 加入清洗
lists_back = ▲ 移回
lists_earlier = 提前
lists_later = 推后

## 留待处理

later_heading = 留待处理（{ $count }）
later_back = 移回
later_back_name = 移回面 { $surface }
later_back_tip = 不再留待处理
later_clean = 加入清洗
later_clean_name = 仍清洗面 { $surface }
later_clean_tip = 在本作业中清洗
later_area = { $area } mm²
later_row = 留待处理：面 { $surface } { $label }

## 工艺配方比较

compare_title = 比较工艺配方
compare_too_few = 请选择两个或更多
compare_no_difference = 没有差异
compare_own = 作业自身的值
compare_own_column = 作业自身
compare_recipe = { $name }（{ $shelf }）
compare_recipe_name = 比较工艺配方 { $name }（{ $shelf }）
compare_all_rows = 同时显示无差异的行
compare_cell = { $label }：{ $value }
