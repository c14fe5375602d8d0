### 命令行。

## 帮助。`plan` 中设定参数的选项见参数表。
cli_about = 规划机器人激光清洗零件上所选的面：从零件文件（STL、OBJ、PLY、3MF）到机器人程序
cli_file = 要在窗口中打开的零件或作业
cli_lang = 消息和帮助的语言
cli_json = 输出 JSON
cli_inspect = 列出零件文件的内容：拓扑、缺陷、特征面
cli_inspect_part = 零件
cli_inspect_angle = 分割角，单位：度
cli_inspect_units = 文件的单位：mm、m 或 inch [默认：文件中注明的单位，否则为 mm]
cli_inspect_weld = 顶点焊接：auto（合并坐标相同的顶点；为闭合开放边，也合并仅差舍入误差的顶点）或 exact（仅合并坐标相同的顶点）
cli_plan = 规划作业，并将作业、程序、报告和路径写入文件夹
cli_plan_input = 零件或作业；给出多个时依次规划，各自写入 --out 下的单独文件夹
cli_plan_out = 存放规划文件的文件夹
cli_plan_scan = 零件实际状态的扫描数据：配准到零件上，并规划其中缺损超过 --min-depth 的缺损区；给出多个时视为同类零件的扫描数据，各自规划并写入单独文件夹
cli_plan_jobs = 批量规划时同时进行的规划数
cli_row_failed = 本批未全部规划完成；未完成的见各行输出
cli_row_same_name = 本批有两个规划会写入同一文件夹 { $name }：请为作业或扫描数据另取名称
cli_plan_dose = 计算剂量并写出 dose.ply；作业的 [dose] 中有阈值时，不加此选项也会计算
cli_plan_report = 同时把报告写成供人阅读的页面（report.html）
cli_plan_dry_run = 写出空运行程序来代替正式程序：运动相同，速度为其 { $percent } %，所有输出信号关闭，使用单独的文件名
cli_plan_from_pass = 写出从第 N 道开始的程序（道号从 0 起，见 path.csv），用于停机后继续加工；使用单独的文件名
cli_plan_overwrite = 替换文件夹中经手工修改的、属于其他作业的或并非导出生成的文件
cli_plan_json = 以 JSON 输出报告
cli_verify = 读回程序，并与其作业的规划核对
cli_verify_program = 程序文件；子程序在其所在文件夹中查找
cli_verify_job = 生成该程序的作业
cli_verify_json = 以 JSON 输出检查结果
cli_render = 将零件或规划好的作业绘制成图片
cli_render_input = 零件，或需先规划的作业
cli_render_out = 要写出的图片
cli_render_size = 图片尺寸，单位：像素
cli_render_view = iso、front、back、left、right、top 或 bottom
cli_register = 确定扫描数据在其零件上的位置
cli_register_scans = 扫描数据：PLY、PCD、XYZ、TXT、CSV、PTS、PTX、E57 或网格；给出多个时，按 --markers 统一到第一个的坐标系
cli_register_nominal = 用作配准基准的完好零件的扫描数据，代替 --part：由其中的点拟合出曲面
cli_register_part = 被扫描的零件
cli_register_markers = 标记点文件，各 [[marker]] 含 name、scan_mm、base_mm：扫描数据中的点，以及机器人触碰该点的位置
cli_register_transform = 从该文件的 model_from_scan 开始配准，不再从任意位置搜索
cli_deviation = 将扫描数据与其零件比较：零件偏差多大，哪些偏差是磨损
cli_deviation_scan = 扫描数据：PLY、PCD、XYZ、TXT、CSV、PTS、PTX、E57 或网格
cli_deviation_out = 要写出的 PLY：零件上的点，带 deviation_mm（大于 0 为在外侧）和 depth_mm（经平滑，大于 0 为缺料）
cli_deviation_min_depth = 缺料或多料超过此值之处视为缺损区
cli_deviation_transform = 直接采用该文件的 model_from_scan，不再搜索
cli_render_color = 颜色所表示的内容：surface（面）、dose（剂量）或 incidence（入射角）

## 被拒绝的值
cli_not_a_color = “{ $text }”：请给出 surface、dose 或 incidence
cli_not_a_size = “{ $text }”：请按 WxH 给出宽和高，各为 16 到 8192 像素
cli_not_a_view = “{ $text }”：请给出其中之一：{ $views }

## 失败
cli_markers_of = { $file }：{ $scan }：{ $what }
cli_no_json = 结果无法写成 JSON：{ $reason }
cli_no_path = { $file }：无法确定其完整路径：{ $reason }
cli_not_planned = { $job }：无法规划：{ $reason }
cli_part_changed = 零件 { $file } 在作业保存后有改动，作业中的内容无法全部沿用：{ $told }；请在窗口中打开作业查看，并重新选择
cli_help_overwrite = { $why }；请加 --overwrite 替换这些文件，或另选文件夹
cli_help_other_folder = { $why }；请另选文件夹

## 输出内容
cli_part_carried_over = { $file }：在作业保存后有改动；{ $told }
cli_speaks_own_dialect = { $robot } 使用 { $own }：请给出 --dialect { $own }
cli_times = 加工 { $work }，空行程 { $travel }，等待 { $waiting }
cli_to_help = 建议：{ $advice }
cli_better_setup = 更好的装夹布置，将以下内容写入作业的 [cell]：被拒绝的路径点由 { $before } 个减为 { $left } 个
cli_removed = 已删除 { $file }
cli_wrote = 已写入 { $file }

## `verify` 的输出
verify_dry_run = 从文件名看是空运行程序，按空运行核对：所有输出信号关闭，速度较低
verify_from_pass = 从文件名看是从第 { $pass } 道开始的程序，按此核对：不检查之前的各道
verify_unreadable = { $dialect }：无法读取，未与规划核对
verify_moves = { $dialect }：{ $moves } 个运动，其中 { $lit } 个出光
verify_furthest = 与规划的最大偏差：光斑处 { $mm } mm、{ $deg }°
verify_inputs_unknown = 程序旁没有 report.json 说明它由哪些文件生成，因此无法确认工作站、机器人、激光头和夹具是否仍与当时相同；请指定导出文件夹中的程序或其作业
verify_finding = { $file }:{ $line }：{ $what }
verify_more = 另有 { $count } 项
verify_count = { $count ->
    [0] 未发现问题
   *[other] { $count } 项检查结果
}
cli_weld = 在灰度图和深度图中找出焊缝，测量焊缝，并规划打磨
cli_weld_gray = 灰度图：PNG、TIFF 或 JPEG
cli_weld_depth = 相同尺寸的深度图：16 位 PNG、PGM 或 TIFF，或浮点 TIFF
cli_weld_camera = 拍摄这两幅图的相机：TOML 格式的 fx、fy、cx、cy、s、k1、k2、p1、p2、k3，或 Open3D 的内参
cli_weld_part = 焊缝所在的零件；不给出时，以焊缝周围的母材表面为零件，采用相机坐标系
cli_weld_hand_eye = 相机的位置：机器人位姿及对应的标定板位姿，或手眼标定结果
cli_weld_tool = 打磨工具；不给出时为半径 30 mm 的砂轮片
cli_weld_pass_depth = 每道的去除深度
cli_weld_residual = 打磨到此高度为止
cli_weld_strategy = one-way、zigzag、spiral 或 along；不给出时，焊道沿其中心线打磨，无高度的区域按螺旋打磨
cli_weld_json = 以 JSON 输出测量结果
give_grinding_strategy = 请给出 one-way、zigzag、spiral 或 along
