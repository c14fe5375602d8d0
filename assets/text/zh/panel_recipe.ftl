### 所选面的工艺配方，以及工艺配方库。

## 面的工艺配方

recipe_panel_none = 面的工艺配方
recipe_panel_one = 面 { $surface } 的工艺配方
recipe_panel_many = { $count } 个面的工艺配方
recipe_panel_titled = { $whose }：{ $name }
recipe_panel_several = 多个
recipe_panel_select = 选择面，为其单独设定参数值
recipe_panel_different = 所选面的工艺配方不同：可在此统一指定，或进行比较
recipe_panel_recipe = 工艺配方
recipe_panel_recipe_name = 工艺配方
recipe_panel_jobs = 无：使用作业的参数值
recipe_panel_new = 新建
recipe_panel_new_name = 工艺配方 { $number }
recipe_panel_copy = 从其他面复制…
recipe_panel_copy_row = 面 { $surface }：{ $recipe }
recipe_panel_others = 更改也会应用到另外 { $count } 个面：{ $surfaces }
recipe_panel_change_makes = 在此更改参数值会新建一个工艺配方
recipe_panel_keep = 保存到我的工艺配方
recipe_panel_remove = 从作业中删除
recipe_panel_remove_tip = 使用它的面改用作业的参数值
recipe_panel_name = 名称
recipe_panel_name_field = 工艺配方名称
recipe_panel_note = 备注
recipe_panel_note_field = 工艺配方备注
recipe_panel_of_surface = 面 { $surface }：{ $what }
recipe_panel_spacing = 行距 { $least } 到 { $greatest } mm（设定 { $wanted }）
recipe_panel_more = 更多参数
recipe_panel_more_own = 更多参数（{ $count } 个单独设定）

## 工艺配方库

library_title = 工艺配方库
library_how = 将工艺配方拖到面所在的行，或应用到所选面
library_in_job = 本作业
library_mine = 我的工艺配方
library_shipped = 自带
library_job_word = 作业
library_mine_word = 我的
library_shipped_word = 自带
library_none = 暂无
library_compare = 比较…
library_compare_tip = 并排比较工艺配方
library_removed = 已删除 { $name }
library_undo = 撤销
library_undo_name = 恢复已删除的工艺配方
library_apply = 应用
library_apply_name = 应用工艺配方 { $name }（{ $shelf }）
library_apply_tip = 应用到所选面
library_duplicate = 复制
library_duplicate_name = 复制工艺配方 { $name }
library_duplicate_tip = 以新名称创建副本
library_remove_name = 删除工艺配方 { $name }（{ $shelf }）
library_remove_job_tip = 从作业中删除；使用它的面改用作业的参数值
library_remove_mine_tip = 从我的工艺配方中删除
library_saved = 已保存 { $file }
library_dragged = 工艺配方 { $name }
