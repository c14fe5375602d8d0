### 耗时操作的进度。

activity_reading = 正在读取
activity_building_part = 正在生成零件
activity_cutting_surfaces = 正在分割面
activity_naming_shapes = 正在识别形状
activity_laying_lines = 正在生成扫描线
activity_planning = 正在避让光束
activity_choosing_spins = 正在选择绕光轴转角
activity_connecting_moves = 正在生成空行程
activity_working_out_motion = 正在计算运动
activity_measuring_clearances = 正在计算间隙
activity_exporting = 正在导出
activity_packing = 正在打包
activity_writing_program = 正在写入程序
activity_writing_files = 正在写入文件
activity_summing_dose = 正在计算剂量
activity_looking_for_help = 正在查找建议
activity_trying_speeds = 正在尝试更低的速度
activity_trying_changes = 正在尝试更改
activity_looking_for_setup = 正在查找更好的装夹布置
activity_trying_setups = 正在尝试装夹布置
activity_improving_setup = 正在优化装夹布置
activity_trying_small_changes = 正在尝试微调
activity_planning_samples = 正在试规划部分道

## 状态栏
progress = { $activity } { $percent } %
activity_reading_scan = 正在读取扫描数据
activity_cleaning_scan = 正在清理扫描数据
activity_laying_scan = 正在将扫描数据配准到零件
activity_comparing_scan = 正在比较扫描数据与零件
activity_cutting_patches = 正在提取缺损区
activity_reading_images = 正在读取图像
activity_masking_image = 正在灰度图中查找区域
activity_measuring_bead = 正在测量焊道
activity_cutting_areas = 正在由区域生成面
activity_comparing_strategies = 正在比较打磨策略
