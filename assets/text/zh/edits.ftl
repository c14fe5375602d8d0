### 撤销和重做的步骤：菜单中“撤销”之后的文字。

step_restored = 恢复未保存的更改

## 路径

edit_parameter = 更改{ $parameter }
edit_direction = 更改截面方向
edit_offset = 更改首个截面的偏移
edit_order = 更改顺序
edit_strategy = 更改策略
edit_border = 更改边界
edit_centre = 更改螺旋中心
edit_inward = 反转螺旋走向
edit_correction = 更改修正方式
edit_bead = 更改熔道
edit_profile = 更改光斑功率分布

## 工艺配方

edit_recipe = 更改工艺配方“{ $name }”
edit_remove_recipe = 删除工艺配方“{ $name }”
edit_duplicate_recipe = 复制工艺配方“{ $name }”
edit_rename_recipe = 重命名工艺配方“{ $name }”
edit_give_recipe = { $count ->
    [1] 为面 { $surface } 指定工艺配方“{ $name }”
   *[other] 为 { $count } 个面指定工艺配方“{ $name }”
}
edit_take_recipe = { $count ->
    [1] 取消面 { $surface } 的工艺配方
   *[other] 取消 { $count } 个面的工艺配方
}

## 特征面

edit_clean = { $count ->
    [1] 将面 { $surface } 加入待清洗列表
   *[other] 将 { $count } 个面加入待清洗列表
}
edit_unclean = { $count ->
    [1] 将面 { $surface } 移出待清洗列表
   *[other] 将 { $count } 个面移出待清洗列表
}
edit_shift = { $count ->
    [1] 调整面 { $surface } 的顺序
   *[other] 调整 { $count } 个面的顺序
}
edit_reorder = 更改加工顺序
edit_merge = { $count ->
    [1] 合并面 { $surface }
   *[other] 合并 { $count } 个面
}
edit_split = 拆分面 { $surface }
edit_cut = 从面 { $surface } 切出 { $facets } 个面片
edit_put_aside = { $count ->
    [1] 将面 { $surface } 留待处理
   *[other] 将 { $count } 个面留待处理
}
edit_take_back = { $count ->
    [1] 移回面 { $surface }
   *[other] 移回 { $count } 个面
}
edit_rename = 重命名面 { $surface }
edit_rename_several = 重命名 { $count } 个面
edit_surface_border = 更改面 { $surface } 的边界
edit_surface_centre = 更改面 { $surface } 的螺旋中心
edit_flip_surface = 翻转面 { $surface }
edit_tilt = 更改面 { $surface } 的倾角
edit_pins = 更改面 { $surface } 的固定倾角

## 零件、工作站和工具

edit_flip_shell = 翻转壳体 { $shell }
edit_place = 摆放零件
edit_units = 更改单位
edit_weld = 更改顶点焊接方式
edit_changed_part = 使用已更改的零件
edit_cell = 更改工作站
edit_robot = 更改机器人
edit_mount = 更改安装方式
edit_frames = 更改装夹布置
edit_dialect = 更改机器人语言
edit_spin = 更改绕光轴转角
edit_no_head = 移除激光头
edit_head = 更改激光头
edit_clamps = 更改夹具

## 扫描数据

edit_no_scan = 移除扫描数据
edit_scan = 更改扫描数据
edit_add_step = 添加清理步骤
edit_remove_step = 删除清理步骤 { $step }
edit_alter_step = 更改清理步骤 { $step }
edit_no_transform = 重新配准扫描数据
edit_transform = 确定扫描数据在模型上的位置
edit_pairs = 更改拾取的点对
edit_left_out = 更改配准时排除的部位
edit_patches = 选择缺损区
edit_own_scan = 仅按扫描数据加工
edit_continued = 更改跨损伤延续的面
edit_together = 更改多份扫描数据的拼接方式
edit_scan_work = 更改加工对象
edit_scan_lines = 更改扫描线所依据的表面
edit_base_from_scan = 更改扫描仪坐标系

## 焊缝

edit_no_weld = 移除焊缝图像
edit_weld_images = 更改焊缝图像
edit_changed_image = 使用已更改的图像
edit_ground_pass = 选取下一组图像
edit_threshold = 更改阈值
edit_paint_mask = 涂画掩模
edit_erase_mask = 擦除掩模
edit_unpaint = 清除涂画
edit_grinding_strategy = 更改区域的打磨方式
edit_bead_strategy = 更改焊道的打磨方式
edit_areas = 更改要打磨的区域
edit_hand_eye = 更改相机位置
edit_grinding_tool = 更改打磨工具
edit_goes_on = 继续打磨
edit_held = 暂停下一道
edit_roughness = 更改粗糙度读数
