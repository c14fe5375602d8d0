### 参数面板：分组、修正、面、零件。

parameters_beam = 光束
parameters_speed = 速度
parameters_targets = 路径点、引入引出
parameters_surfaces = 特征面
parameters_more_surfaces = 特征面更多设置
parameters_split = 按角度拆分所选面
parameters_split_angle = 拆分角度
parameters_part = 零件
parameters_correction = 修正
parameters_correction_tip = 光束沿法线方向会碰到零件时的处理方式
parameters_correction_name = 修正方式 { $correction }

## 零件

parameters_units = 文件单位
parameters_weld = 顶点焊接
parameters_turn = 旋转
parameters_move = 平移
parameters_place_field = { $name } { $axis }

## 选项卡

tab_name = 设置：{ $tab }
tab_lists = 列表
tab_path = 路径
tab_beam = 光束
tab_part = 零件
tab_robot = 机器人
tab_dose = 剂量
tab_scan = 扫描
tab_weld = 焊缝
