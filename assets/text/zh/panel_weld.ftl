### 打磨的焊缝：文件、掩模、区域、道次及图像。

weld_panel = 焊缝
weld_panel_tells_worked = 打磨的内容由焊缝图像决定：请勾选其中的区域
weld_panel_keeps_surfaces = 打磨焊缝时不可用：焊缝区域使零件的面片与文件中的不同
weld_panel_no_light = 打磨工具不会在零件上投下光

## 文件

weld_panel_open_tip = 依次选择灰度图、深度图和拍摄这两幅图的相机
weld_panel_gray = 灰度图
weld_panel_depth = 深度图
weld_panel_camera = 相机
weld_panel_images = 显示图像
weld_panel_images_tip = 并排显示带掩模的灰度图和深度图，可逐步查看，并可使用画笔  { $keys }
weld_panel_other = 其他图像…
weld_panel_take_away = 移除
weld_panel_take_away_tip = 作业不再打磨焊缝
weld_panel_hand_eye = 手眼标定
weld_panel_hand_eye_tip = 相机的位置：机器人位姿与标定板位姿，或标定结果
weld_panel_hand_eye_none = 相机的位置未知
weld_panel_tool = 工具
weld_panel_tool_tip = 砂轮片或砂带及其尺寸
weld_panel_tool_none = 随附的砂轮片
weld_panel_choose = 选择…
weld_panel_choose_name = 选择{ $what }文件
weld_panel_remove_name = 移除{ $what }文件

## 掩模

weld_panel_mask = 掩模
weld_panel_mask_numbers = 掩模步骤
weld_panel_histogram = 焊缝灰度图的直方图
weld_panel_histogram_tip = 匀光后图像的灰度，计数取对数。蓝色：主峰，即母材表面；灰色：距主峰一个标准差；橙色：阈值，可以拖动
weld_panel_mode = 母材表面灰度 { $mode }，标准差 { $sigma }
weld_panel_threshold = 阈值
weld_panel_threshold_level = 阈值的灰度
weld_panel_threshold_found = 取自直方图
weld_panel_threshold_found_tip = 高出母材表面若干个标准差，倍数在“掩模步骤”中设定
weld_panel_threshold_given = 手动

## 区域

weld_panel_areas = 区域
weld_panel_no_areas = 尚无
weld_panel_area = { $area } { $kind }
weld_panel_area_tip = 是否打磨此区域
weld_panel_grind_area = 打磨区域 { $area }
weld_panel_area_mm2 = { $area } mm²
weld_panel_area_px = { $pixels } px
weld_panel_area_high = { $size }，高 { $height } mm

## 打磨方式

weld_panel_strategy = 打磨方式
weld_panel_beads = 焊道
weld_panel_defects = 无高度的区域
weld_panel_strategy_name = { $what } { $strategy }
weld_panel_one_way = 单向
weld_panel_zigzag = 往复
weld_panel_spiral = 螺旋
weld_panel_along = 沿中心线
weld_panel_one_way_hint = 方向相同的平行线；工具在每条线末端抬离
weld_panel_zigzag_hint = 往复的平行线，在边缘处相连
weld_panel_spiral_hint = 一条螺旋线，各圈在面上间距相等
weld_panel_along_hint = 沿焊道中心线的走线
weld_panel_tool_numbers = 工具运动参数

## 道次

weld_panel_passes = 道次
weld_panel_passes_left = 还剩 { $passes } 道
weld_panel_pass = 道次
weld_panel_number = { $number }
weld_panel_level = 磨至（mm）
weld_panel_infeed = 切深（mm）
weld_panel_left_area = 面积（mm²）
weld_panel_history = 已打磨
weld_panel_before = 打磨前（mm）
weld_panel_planned = 规划（mm）
weld_panel_left = 剩余（mm）
weld_panel_next_images = 选取下一组图像…
weld_panel_next_images_tip = 此道打磨完成后：先选打磨后的灰度图，再选深度图。高度、道次和切深将重新求得，之前的图像转入历史记录
weld_panel_no_next_images = 没有剩余的道需要打磨，或尚未规划
weld_panel_go_on = 仍然继续
weld_panel_go_on_tip = 上一道的去除量虽与规划不符，仍输出下一道
weld_panel_goes_on = 经您确认，将输出下一道
weld_panel_hold = 重新暂停

## 焊道

weld_panel_bead = 焊道
weld_panel_mm = { $number } mm
weld_panel_greatest_height = 最大高度
weld_panel_mean_width = 宽度
weld_panel_length = 长度
weld_panel_noise = 深度噪声
weld_panel_parent_rms = 母材表面拟合误差（均方根）
weld_panel_bead_plots = 沿焊道的高度和宽度
weld_panel_height_along = 沿中心线的高度（mm）
weld_panel_width_along = 沿中心线的宽度（mm）
weld_panel_heights = 测点的高度分布（mm）
weld_panel_height_plot = 沿焊道的高度
weld_panel_width_plot = 沿焊道的宽度
weld_panel_heights_plot = 高度直方图
weld_panel_legend = 焊道高度（mm）
weld_panel_height_scale = 焊道高度色标

## 策略比较

weld_panel_times = 策略比较
weld_panel_no_times = 区域规划完成后显示时间
weld_panel_speed = mm/s
weld_panel_seconds = { $seconds } s
weld_panel_lifts = 抬离次数
weld_panel_lifts_tip = 工具在途中离开面的次数
weld_panel_times_chart = 各策略的时间：{ $what }
weld_panel_take_quickest = 采用最快的：{ $strategy }
weld_panel_take_quickest_name = 采用最快的：{ $what }
weld_panel_quickest_taken = 已经采用

## 粗糙度

weld_panel_roughness = 粗糙度
weld_panel_point = 点
weld_panel_before_um = 打磨前（µm）
weld_panel_after_um = 打磨后（µm）
weld_panel_before_at = 点 { $point } 打磨前的粗糙度
weld_panel_after_at = 点 { $point } 打磨后的粗糙度
weld_panel_measured = 实测…
weld_panel_measured_tip = 输入打磨后的实测值
weld_panel_measure_after = 点 { $point } 打磨后的实测值
weld_panel_add_point = 添加点
weld_panel_remove_point = 移除此点
weld_panel_remove_point_name = 移除点 { $point }
weld_panel_roughness_mean = { $points } 个点的平均值：打磨前 { $before } µm，打磨后 { $after } µm，降低 { $fell } %

## 图像

weld_panel_images_title = 焊缝图像
weld_panel_no_images = 正在读取图像
weld_panel_step = 步骤
weld_panel_step_gray = 灰度图
weld_panel_step_evened = 匀光
weld_panel_step_smoothed = 平滑
weld_panel_step_above = 高于阈值
weld_panel_step_opened = 开运算
weld_panel_step_closed = 闭运算
weld_panel_step_painted = 涂画
weld_panel_step_areas = 区域
weld_panel_step_edges = 边缘
weld_panel_pan = 平移
weld_panel_pan_tip = 拖动平移图像；滚轮缩放图像
weld_panel_add = 添加
weld_panel_add_tip = 拖动添加掩模，按右键拖动擦除；按中键拖动平移
weld_panel_erase = 擦除
weld_panel_erase_tip = 拖动擦除掩模，按右键拖动添加；按中键拖动平移
weld_panel_radius_prefix = 半径{ " " }
weld_panel_px = { " px" }
weld_panel_radius = 掩模画笔的半径
weld_panel_unpaint = 清除涂画
weld_panel_not_painted = 没有涂画内容
weld_panel_whole = 全图
weld_panel_whole_tip = 重新显示整幅图像
weld_panel_gray_image = 焊缝的灰度图
weld_panel_depth_image = 焊缝的深度图
weld_panel_no_pixel = 此处显示列、行、灰度和深度
weld_panel_pixel = 列 { $column }，行 { $row }：灰度 { $level }，深度 { $depth } mm
weld_panel_pixel_hole = 列 { $column }，行 { $row }：灰度 { $level }，无深度
weld_panel_depth_legend = 深度（mm）
weld_panel_depth_scale = 深度色标
