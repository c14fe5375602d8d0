### 零件文件：有什么问题、发现了什么、`inspect` 输出什么。

## 无法使用的文件
part_file_empty = 文件为空
part_file_folder = { $file } 是文件夹：请指定其中的零件文件
part_file_lfs = 这是 Git LFS 指针，不是零件：请获取文件本身（git lfs pull）
part_file_packed = 这是 { $kind } 压缩包：请解压后打开其中的零件
part_file_web_page = 这是网页，不是零件：请下载文件本身，必要时先登录
part_file_other_model = 这是 { $kind } 文件，不支持读取：请将零件导出为 STL、OBJ、PLY 或 3MF
part_file_no_model = 这是 { $kind } 文件，不是零件：请打开零件的 STL、OBJ、PLY 或 3MF 文件
part_file_unknown = 这不是零件文件：既不是 STL（`solid` 文本，或二进制面片数），也不是 OBJ、PLY 或 3MF
part_file_decimal_comma = 数值用逗号作小数点（字节位置 { $byte }），此类文件不允许这样写：请以句点作小数点重新导出零件
part_file_no_facets = 文件中没有面片；请重新导出零件
part_file_all_dropped = 没有可用的面片：共 { $dropped } 个面片，已全部丢弃；第一个的问题：{ $first }
part_file_point_cloud = 这是含 { $points } 个点的点云，不是网格：点之间没有面相连；请将零件导出为网格
part_file_other_unit = { $file } 声明的单位为 { $stated }，却按 { $units } 读入：请在引用该文件处写入 units = "{ $key }"
stl_cut_off = 文件头声明有 { $promised } 个面片（{ $needed } 字节），但文件只有 { $present } 字节：文件不完整，或不是 STL 文件；请重新导出
stl_count_doubtful = 文件头声明有 { $promised } 个面片，但其后还有 { $more } 个，再往后的内容不是面片：文件已损坏；请重新导出
stl_text_cut_off = 文本在一个 solid 内部中断，此前有 { $facets } 个面片（字节位置 { $byte }）：文件不完整；请重新导出
obj_vertex = 第 { $line } 行：顶点需要三个数值，如有权重则不能为 0；请重新导出零件
obj_face = 第 { $line } 行：面中有不是顶点编号的内容；请重新导出零件
obj_no_such_vertex = 第 { $line } 行：面引用了文件中没有的顶点：文件不完整或已损坏；请重新导出
ply_header_line = PLY 文件头的第 { $line } 行无法读取；请重新导出文件
ply_no_header_end = PLY 文件头没有 end_header：文件不完整；请重新导出
ply_no_coordinates = PLY 文件的顶点没有 x、y 和 z；请重新导出文件
ply_no_indices = PLY 文件的面没有顶点列表（vertex_indices）；请重新导出零件
ply_strips = PLY 文件含有三角形带，不支持读取：请以面的形式导出零件
ply_cut_off = PLY 文件头声明 { $element } 有 { $promised } 行，但文件提前结束：文件不完整；请重新导出
ply_value = PLY 文件中 { $element } 的第 { $row } 行有不允许的数值或非数值内容；请重新导出文件
ply_no_such_vertex = PLY 文件的面 { $face } 引用的顶点不在文件的 { $vertices } 个顶点之中：文件已损坏；请重新导出
threemf_archive = 此 3MF 或 ZIP 文件的压缩包无法读取：文件不完整或已损坏；请重新获取或导出
threemf_no_entry = 3MF 文件缺少 { $entry }：文件已损坏；请重新导出
threemf_unreadable = 3MF 文件中的 { $entry } 无法解压：文件已损坏或已加密；请重新导出
threemf_too_large = 3MF 文件的模型解压后超过可读取的上限 { $most } MiB：请降低零件的导出精度，或导出为二进制 STL
threemf_xml = 3MF 文件中的 { $entry } 不是 XML（第 { $line } 行）：文件已损坏；请重新导出
threemf_unit = 3MF 文件的单位为 { $word }，该格式中没有此单位；请重新导出
threemf_units_differ = 3MF 文件中各模型的单位不同；请将零件导出为一个模型
threemf_extension = 读取此 3MF 文件需要扩展 { $name }，本程序不支持：请不带该扩展导出零件，或导出为 STL
threemf_value = 3MF 文件中模型的第 { $line } 行：{ $element } 缺少数值或数值无法读取；请重新导出
threemf_no_such_vertex = 3MF 文件的对象 { $object } 有三角形引用了其 { $vertices } 个顶点之外的顶点：文件已损坏；请重新导出
threemf_no_such_object = 3MF 文件的构建项引用了对象 { $object }，但文件中没有该对象：文件已损坏；请重新导出
threemf_too_deep = 3MF 文件的对象循环引用，或嵌套层数过多；请将零件导出为一个网格
threemf_too_many_objects = 3MF 文件重复使用其对象超过 { $most } 次；请只导出该零件
threemf_too_many_facets = 3MF 文件重复使用其对象，面片超过 { $most } 个；请只导出该零件

## 面片不可用的原因
facet_nan = 有 NaN 顶点
facet_infinite = 有无穷大的顶点
facet_unreadable = 有不是数值的顶点
facet_no_end = 没有 endfacet
facet_not_three_vertices = 顶点多于或少于三个
facet_no_area = 没有面积
facet_crosses_itself = 轮廓自相交
facet_too_many_corners = 顶点多于 4096 个

## 检查结果
part_implausible_size = 尺寸 { $size } mm 不合理；若单位为 { $unit }，则为 { $other } mm
part_implausible_in_any_unit = 尺寸 { $size } mm 不合理，换成任何单位也不合理：请在 CAD 中检查单位并重新导出零件
part_use_units = 请使用 --units { $units }
part_far_from_origin = 零件距原点 { $distance } m，文件坐标在该处的最小间隔为 { $step } mm：请在 CAD 中将零件移到原点并重新导出
part_shattered = { $surfaces } 个面中有 { $smaller } 个小于光斑（{ $spot } mm²）；并入 { $below } mm² 以下的碎面后剩下 { $left } 个面
part_absorb_in_job = 请在作业的 [surfaces] 下写入 min_area_mm2 = { $value }
part_facets_dropped = 丢弃了 { $count } 个面片：{ $list }
part_dropped_facet = 面片 { $facet } { $fault }（字节位置 { $byte }）
part_more_dropped = 另有 { $count } 个
part_open_edges = 有 { $count } 条开放边：面在该处不封闭
part_non_manifold_edges = 有 { $count } 条边连接两个以上的面片，按折边处理
part_flipped_facets = 有 { $count } 个面片朝向相反，已翻转
part_duplicate_facets = 有 { $count } 个重复面片，规划时跳过
part_two_sided_facets = 有 { $count } 个面片是其他面片的背面：文件中的薄板含正反两面，各自作为单独的面
part_joined_corners = 为闭合开放边，{ $count } 个顶点已与其他顶点合并，相距最多约 { $within } mm
part_degenerate_facets = 有 { $count } 个面片没有面积，规划时跳过
part_bytes_passed_over = 文件中有 { $count } 个字节不属于任何面片，已跳过（从字节位置 { $at } 起）
part_count_differs = 文件声明有 { $promised } 个面片，实际有 { $read } 个，已全部读入：请检查零件是否完整，并重新导出
part_unit_overridden = 文件声明的单位为 { $stated }，却按 { $units } 读入：是否有意如此？
part_unit_taken = 已采用文件声明的单位 { $stated }
part_lines_not_read = 未读入 { $count } 条没有面积的线
part_points_not_read = 未读入 { $count } 个孤立点
part_free_form_not_read = 未读入 { $count } 个由公式定义的曲线或曲面：如需要，请将零件导出为网格
part_unknown_lines = 文件中有 { $count } 行以未知关键字开头，已跳过
part_element_not_read = 未读入 { $name } 的 { $count } 行
part_objects_not_built = 文件中有 { $count } 个对象不在构建项中，未读入
part_supports_not_read = 未读入 { $count } 个打印支撑对象
part_beams_not_read = 未读入 { $count } 根晶格杆件
part_meshed = 已由 { $points } 个点生成曲面，与点的偏差为 { $rms } mm（均方根）：边被圆化，范围最大 { $rounded } mm，小于 { $cell } mm 的细节不保留；未扫描处留有孔洞，规划时避开孔洞后方的空间
part_side_guessed = 点没有法线，外侧是推测的
part_solids_joined = 文件中的 { $count } 个实体已合并为一个零件

## `inspect` 的输出
inspect_counts = { $facets } 个面片，{ $vertices } 个顶点，{ $edges } 条边
inspect_watertight = { $shells } 个壳体，封闭
inspect_open = { $shells } 个壳体，不封闭
inspect_size = 尺寸 { $size } mm，面积 { $area } mm²
inspect_volume = 体积 { $volume } mm³
inspect_surfaces = { $count } 个特征面（分割角 { $angle }°）
inspect_column_surface = 面
inspect_column_facets = 面片数
inspect_column_area = 面积 mm²
inspect_column_shape = 形状

## 形状
shape_plane = 平面
shape_cylinder = 圆柱面
shape_cone = 圆锥面
shape_sphere = 球面
shape_freeform = 自由曲面
shape_with_diameter = { $shape } Ø{ $diameter }
shape_with_angle = { $shape } { $angle }°
