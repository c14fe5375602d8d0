### 打磨的焊缝：图像、相机、测量结果。

weld_changed = { $file } 与保存作业时的文件不同；请放回原来的文件，或（在窗口中）改用此文件
weld_other_size = 图像为 { $now_width } × { $now_height } 像素，第一道之前的图像为 { $width } × { $height } 像素：请用同一相机在同一位置拍摄
weld_no_area = 灰度图中没有与母材表面区分开的区域：请降低阈值，或涂画该区域
weld_too_many_passes = 按此每道深度，焊道需要超过 1000 道：请加大每道深度
weld_no_skin = 从深度图中得不出各区域周围的母材表面
weld_not_on_part = 相机看到的母材表面在零件上找不到对应位置：{ $what }
weld_slack = 零件可能偏离测得的位置 { $slack } mm：手臂和工具在安全裕量之外再留 { $slack } mm
weld_no_depth_there = 掩模处没有测得深度：请重新拍摄图像，或缩小涂画范围
weld_few_points = 焊道周围只有 { $count } 个深度值，至少需要 { $least } 个：请靠近一些拍摄
weld_one_side = 只有 { $share } % 的焊道长度在两侧都测到了母材表面：拍摄时请使两侧都可见
weld_no_surface = 由焊道周围的深度值得不出表面
weld_nothing_stands = 掩模内没有高出母材表面 { $threshold } mm 的部分：没有需要磨掉的余量
weld_leaves_image = 焊道延伸到图像边缘或测量范围边缘：拍摄时请使焊道完整可见
weld_short = 焊道长 { $length } mm，太短，得不出中心线
weld_no_edges = 未找到焊道的边缘：焊道与旁边的物体连成一片
weld_unmeasured = 列 { $u }、行 { $v } 处的区域未处理：{ $what }
weld_held_removal = 上一道磨去 { $removed } mm，规划值为 { $planned } mm：下一道等待确认
weld_held_slack = 图像在零件上的位置可能偏离 { $slack } mm，各道也随之偏离：请把边或孔也拍进去，或给出相机的位置，或不使用零件；各道等待确认
weld_held_place = 图像拍摄的是零件的哪个位置尚未确定：请把边或孔也拍进去，或给出相机的位置，或不使用零件；各道等待确认
weld_held_below = 上一道磨到了焊道周围母材表面以下 { $below } mm：下一道等待确认
weld_bead = 焊道：高 { $height } mm，宽 { $width } mm，长 { $length } mm；还剩 { $passes } 道
weld_parent = 周围的母材表面：拟合误差 { $rms } mm（均方根），噪声 { $noise } mm
weld_no_bead = 没有高出母材表面的区域
weld_defect = 缺陷区域：{ $area } mm²，长宽比 { $aspect }
weld_times = { $area }，速度 { $speed } mm/s：单向 { $one_way } s，往复 { $zigzag } s，螺旋 { $spiral } s
weld_roughness = { $points } 个点的粗糙度：打磨前 { $before } µm，打磨后 { $after } µm，降低 { $fell } %
weld_area_bead = 焊道
weld_area_defect = 缺陷区域

## 图像

image_too_large = { $width } × { $height } 像素的图像过大
image_file_too_large = 作为图像，文件过大
image_no_image = 不是 PNG、TIFF、JPEG 或 PGM 图像
image_broken = 图像无法读取：{ $reason }
image_eight_bit_depth = 8 位深度图只有 256 级，不能用于测量：请导出为 16 位或浮点数
image_depth_in_colour = 这是深度图的彩色显示图：请导出深度值本身，用 16 位或浮点数
image_float_grey = 浮点灰度图没有说明多大的值为白色：请导出为 8 位或 16 位
image_other_pixels = 不支持这种像素格式：请导出为 8 位或 16 位
image_no_pixels = 图像没有像素
image_one_level = 图像所有像素的灰度都是 { $level }：图像上没有内容
image_saturated = 图像有 { $share } % 为白色：请减弱光照再拍摄
image_no_depth = 深度图的所有像素都没有深度值
image_sizes_differ = 灰度图为 { $gray_width } × { $gray_height } 像素，深度图为 { $depth_width } × { $depth_height } 像素：两者必须来自同一相机

## 相机

camera_json = 不是 Open3D 的内参文件：{ $reason }
camera_row_by_row = intrinsic_matrix 是按行写的；Open3D 按列写
camera_not_pinhole = intrinsic_matrix 不是相机的内参矩阵：其末行应为 0, 0, 1，且各轴互相垂直
camera_figure = { $key } = { $value } 不是有效的相机数值
camera_size = 该相机文件对应 { $width } × { $height } 像素的图像，而这些图像为 { $image_width } × { $image_height } 像素：这是另一台相机的文件
camera_off_middle = 相机主点位于 { $width } × { $height } 像素图像的列 { $u }、行 { $v }：这是另一台相机的文件
camera_focal = 焦距 { $focal } px 与宽 { $width } 像素的图像不符：这是另一台相机的文件

## 相机的位置

hand_eye_key_of_pose = 位姿 { $pose }：{ $key }
hand_eye_keys = 请给出 [[pose]] 及 camera = "hand" 或 "fixed"，或 flange_from_camera，或 base_from_camera，三者只取其一
hand_eye_no_flange = flange_from_camera 还需要 base_from_flange：拍摄图像时法兰的位姿
hand_eye_count = { $key } 有 { $count } 个数；矩阵应有 16 个数，按行书写
hand_eye_matrix = { $key } 不是刚体运动：{ $fault }
hand_eye_few_poses = { $count } 个位姿不足以确定相机：请取十个绕不同轴转动的位姿
hand_eye_small_turns = 各位姿之间最多只转动 { $most }°，不足以确定相机：请将法兰转动 30° 以上
hand_eye_one_axis = 所有位姿都绕同一轴（{ $x }, { $y }, { $z }）转动，相机沿该轴的位置无法确定：请让法兰也绕其他轴转动
hand_eye_no_fit = 没有与这些位姿相符的相机位置
