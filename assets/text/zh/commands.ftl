### 菜单和按钮上的命令名称，以及菜单标题。

## 菜单
menu_file = 文件
menu_edit = 编辑
menu_surfaces = 特征面
menu_part = 零件
menu_view = 视图
menu_plan = 规划
menu_help = 帮助

## 文件
command_open = 打开…
command_open_scan = 打开扫描数据…
command_open_weld = 打开焊缝图像…
command_save = 保存作业
command_save_as = 作业另存为…
command_export = 导出程序…
command_export_dry_run = 导出空运行程序…
command_export_from_pass = 从此道起导出…

## 编辑
command_undo = 撤销
command_redo = 重做

## 特征面
command_clean = 加入待清洗列表
command_unclean = 移出待清洗列表
command_clean_earlier = 清洗顺序提前
command_clean_later = 清洗顺序推后
command_select_all = 全选
command_select_same_shape = 选择形状相同的面
command_select_same_normal = 选择法线相同的面
command_select_neighbours = 选择相连的面
command_select_larger = 选择面积相同或更大的面
command_select_by_painting = 涂选面…
command_select_below = 选择下一行
command_select_above = 选择上一行
command_merge = 合并所选面
command_split = 按局部角度拆分
command_rename = 重命名…
command_flip_surface = 翻转面的朝向
command_flip_shell = 翻转壳体的朝向

## 零件
command_pick_origin = 拾取面、边或孔作为原点…
command_lay_flat = 拾取一个面朝下放平…
command_measure = 测量…
command_turn_x = 绕 x 轴旋转 90°
command_turn_y = 绕 y 轴旋转 90°
command_turn_z = 绕 z 轴旋转 90°

## 视图
command_look_iso = 等轴测
command_look_front = 前视
command_look_back = 后视
command_look_left = 左视
command_look_right = 右视
command_look_top = 俯视
command_look_bottom = 仰视
command_fit = 适合窗口
command_projection = 透视/平行投影
command_hide = 隐藏所选面
command_isolate = 只显示所选面
command_show_all = 全部显示
command_path_lines = 路径线
command_pose_frames = 位姿坐标系
command_beams = 光束
command_connecting_moves = 空行程
command_before_correction = 修正前
command_plain_part = 零件不着色
command_hide_chosen = 隐藏待清洗的面
command_section_plane = 单个截面
command_cell = 机器人工作站
command_plots = 运动曲线
command_program_text = 程序文本
command_tool_bodies = 激光头和夹具
command_access_map = 可达性图
command_dose = 剂量
command_spacing = 实际行距
command_scan = 扫描点
command_dropped_points = 清理时去除的点
command_deviation_on_model = 模型上的偏差
command_scan_section = 扫描数据的截面
command_weld_images = 焊缝图像
command_weld_points = 焊道和相机
command_cut = 剖切平面
command_lists = 列表
command_settings = 设置
command_navigate_slicer = 鼠标操作：切片软件
command_navigate_cad = 鼠标操作：CAD
command_navigate_blender = 鼠标操作：Blender
command_theme = 深色/浅色/跟随系统
# 将切换到的语言，让只懂该语言的人也能找到。
command_language = English（英文）

## 规划
command_plan = 立即规划
command_cancel = 取消规划或搜索
command_better_setup = 寻找更好的装夹布置
command_play = 播放/暂停
command_next_point = 下一点
command_previous_point = 上一点
command_next_pass = 下一道
command_previous_pass = 上一道
command_first_point = 第一点
command_last_point = 最后一点

## 帮助
command_palette = 查找命令…
command_help = 快捷键
command_escape = 退出当前操作

## 显示内容说明
about_path_lines = 光斑所走的路径线
about_pose_frames = 当前道的路径点坐标系，以及少量其他坐标系
about_beams = 当前道路径点处的光束，以及少量其他光束
about_connecting_moves = 各扫描线之间的关光运动
about_before_correction = 未修正时的光束
about_plain_part = 零件以单一颜色显示
about_hide_chosen = 除待清洗面之外的全部
about_section_plane = 只显示当前道的截面，沿扫描线方向观察
about_cell = 工作站中的机器人、激光头和零件
about_plots = 关节、速度和间隙随时间的变化
about_program_text = 将要导出的程序，逐行显示
about_tool_bodies = 激光头、光束和夹具
about_access_map = 当前位置可从哪些方向到达
about_dose = 到达的能量、未清洗干净处和误照射处
about_spacing = 相邻扫描线之间的实际距离
about_scan = 扫描点，按与模型的偏差着色
about_dropped_points = 清理扫描数据时去除的点
about_deviation_on_model = 模型，按扫描数据的偏差着色
about_scan_section = 视图下方显示零件和扫描数据的截面
about_weld_images = 在窗口中显示焊缝图像及掩模
about_weld_points = 按高度显示的焊道、其中心线和相机
about_cut = 将零件剖开，以查看和拾取内部
about_lists = 特征面列表和待清洗列表
about_settings = 作业设置、问题和导出

## 查找命令
palette_hint = 输入要查找的内容
palette_row = 命令 { $command }
