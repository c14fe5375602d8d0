### 扫描文件：有何错误，剔除或假定了什么，单位是否可疑。

## 无法使用的文件
scan_file_not_read = 文件无法读取：{ $reason }
scan_file_folder = 这是文件夹：请指定其中的扫描文件
scan_file_lfs = 这是 Git LFS 指针，不是扫描数据：请取得文件本身（git lfs pull）
scan_file_packed = 这是 { $kind } 压缩包：请解压后打开其中的扫描数据
scan_file_web_page = 这是网页，不是扫描数据：请下载文件本身，必要时先登录
scan_file_other = 这是 { $kind } 文件，不能作为扫描数据读取：请将扫描数据导出为 PLY、PCD、E57、PTX 或文本
scan_file_unknown = 这不是扫描数据：既不是 PLY、PCD、E57、PTX 或网格，也不是含 x、y、z 各行的文本
scan_file_no_coordinates = 文件中没有名为坐标的列，缺少 x、y、z；现有：{ $columns }
scan_file_cut_off = 文件声明有 { $promised } 个点，实际只容得下 { $present } 个：文件被截断，或文件头有误；请重新导出
scan_file_no_points = 文件中没有点；请重新导出扫描数据
scan_file_all_dropped = 没有可用的点：{ $dropped } 个点全部被剔除，其坐标不是数值，或标记为未测到
scan_file_too_far = 点 { $point } 离第一个点太远，无法计算：文件已损坏；请重新导出
scan_file_too_many = { $points } 个点超出可读取的数量；请抽稀扫描数据，或只保留零件部分
scan_file_decimal_comma = 数值用逗号作小数点（字节 { $byte }），PLY 文件不允许这样写：请用小数点导出扫描数据
pcd_no_header = 文件没有 PCD 文件头，第一行就是数据；如果内容是 x、y、z 各行，请将扩展名改为 .xyz
pcd_no_data = PCD 文件头没有 DATA 行：文件被截断；请重新导出
pcd_line = PCD 文件头第 { $line } 行无法读取；请重新导出扫描数据
pcd_type = PCD 字段 { $field } 的 TYPE、SIZE 或 COUNT 无效；请重新导出扫描数据
pcd_counts = PCD 文件头声明有 { $points } 个点，但 WIDTH × HEIGHT 为 { $grid }：其中之一有误；请重新导出扫描数据
pcd_size = PCD 文件头声明为 { $header } 字节，但压缩数据中记为 { $packed }：文件已损坏；请重新导出
pcd_packed = 压缩的点无法解压（字节 { $byte }）：文件已损坏；请重新导出
pcd_row = PCD 文件第 { $line } 行不是每个字段各有一个数值；请重新导出扫描数据
ptx_count = 此处应为整数，即点云的列数或行数；请重新导出扫描数据
ptx_pose = 此处应为位姿的三个或四个数；文件被截断或已损坏：请重新导出
ptx_no_motion = 到此处为止的矩阵不是位姿：除旋转和平移外还有其他变换；请重新导出扫描数据
ptx_point = 此处应为一个点：x、y、z、强度，如果其他点有颜色则还有颜色；请重新导出扫描数据
e57_checksum = E57 文件第 { $page } 页的校验和不符：文件已损坏；请重新复制或导出
e57_length = E57 文件声明为 { $stated } 字节，实际为 { $present } 字节：文件被截断，或末尾被追加了内容；请重新复制或导出
e57_description = E57 文件中的扫描说明（文件头和 XML）无法读取，或版本不同；请重新导出扫描数据
e57_points = E57 文件中扫描 { $scan } 的点无法读取；请重新导出扫描数据
e57_pose = E57 文件中扫描 { $scan } 的位姿无效：除旋转和平移外还有其他变换；请重新导出扫描数据
e57_not_handled = E57 文件使用了不支持的内容；请以普通直角坐标导出扫描数据

## 读取结果
scan_points_dropped = 已剔除 { $count } 个点：坐标不是数值，或为无穷大
scan_invalid_points = 已略去 { $count } 个被扫描仪标记为未测到的点
scan_count_differs = 文件声明有 { $promised } 个点，实际有 { $read } 个，已全部读取；请检查扫描数据是否完整
scan_short_rows = 已略去 { $count } 行：列数少于第一行（首次出现于第 { $line } 行）
scan_long_rows = { $count } 行的列数多于第一行，多出的列未读取（首次出现于第 { $line } 行）
scan_lines_passed_over = 已跳过 { $count } 行：不是数值行（首次出现于第 { $line } 行）
scan_bytes_passed_over = 已跳过 { $count } 个不属于任何点的字节（从字节 { $at } 起）
scan_normals_not_for_all = { $without } 个点没有法线，因此其他点的法线也未保留
scan_colours_not_for_all = { $without } 个点没有颜色，因此其他点的颜色也未保留
scan_intensities_not_for_all = { $without } 个点没有强度，因此其他点的强度也未保留
scan_columns_assumed = 各列没有名称，已按 { $columns } 读取：是否正确？
scan_assumed_xyz = x、y、z（其余列不读取）
scan_assumed_intensity = x、y、z、强度
scan_assumed_rgb = x、y、z、红、绿、蓝
scan_assumed_normal = x、y、z、法线
scan_assumed_intensity_rgb = x、y、z、强度、红、绿、蓝
scan_decimal_commas = 数值中的逗号已作为小数点读取
scan_columns_not_read = 已略去用不到的列：{ $names }
scan_element_not_read = 已略去 { $name } 的 { $count } 行；点没有缺少
scan_colours_clamped = { $count } 个颜色值超出范围，已改为最接近的有效值
scan_viewpoint = 文件给出了扫描仪的位置；各点按文件中的坐标原样读取
scan_clouds_joined = 文件中的 { $count } 个点云已按文件给出的位置合为一个
scan_corners_taken = 文件中 { $facets } 个面片的顶点已作为点读取
scan_corners_taken_but = 文件中 { $facets } 个面片的顶点已作为点读取；另有 { $dropped } 个面片无法使用

## 单位
scan_unit_of_cloud = 零件的尺寸是扫描数据的 { $ratio } 倍：扫描数据的单位是否为 { $unit }？
scan_unit_of_part = 零件的尺寸是扫描数据的 { $ratio } 倍：零件的单位是否为 { $unit }？
scan_unit_either = 零件的尺寸是扫描数据的 { $ratio } 倍：扫描数据的单位是否为 { $cloud }，或零件的单位是否为 { $part }？
