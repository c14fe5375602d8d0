### 零件文件更改后，作业会怎样。

carried_moved = 整个零件在其文件中移动了 ({ $x }, { $y }, { $z })
carried_moved_and_turned = 整个零件在其文件中移动了 ({ $x }, { $y }, { $z })，并旋转了 { $turn_deg }°
carried_scaled = 全部尺寸变为原来的 { $scale } 倍：单位是否不同？
carried_all_unknown = 作业清洗所有面，但没有记录各面原来的形状；现在这些面已有变化
carried_found = 重新找到：{ $count } 个面
carried_found_renumbered = 重新找到：{ $count } 个面，其中 { $renumbered } 个面的编号已变
carried_not_found = 未找到：{ $surface }
carried_edits_lost = 未能重做：{ $count } 次合并、拆分或切出
carried_shells_lost = 未找到：{ $count } 个已翻转的壳体
lost_surface = 面 { $surface }：{ $why }
lost_named_surface = 面 { $surface }（{ $name }）：{ $why }
lost_nothing_alike = 没有与其相似的面
lost_several_alike = 有多个面过于相似，无法确定是哪一个
lost_edit_not_repeated = 它来自某次合并、拆分或切出，而该操作无法重做
lost_other_facets = 它是按面片切出的，现在面片已有变化
lost_not_remembered = 作业没有记录其原来的形状；作业由较早的版本保存
lost_several_motions = 零件已移动，且能以多种方式与自身重合
lost_part_moved = 零件已移动，在新位置上未能找到全部内容
