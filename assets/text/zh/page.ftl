### 供人阅读的报告页面。

page_title = 报告：{ $job }
page_about = 零件 { $part }，由 clearbeam { $version } 规划
page_dry_run = 本程序为空运行：所有输出信号关闭，速度为 { $percent }%
page_from_pass = 程序从第 { $pass } 道继续
page_result = 结果
page_not_done = 未完成的内容及原因
page_all_done = 所选内容全部完成
page_no_pictures = 没有图片：{ $why }
picture_not_packed = 图片无法编码：{ $reason }
page_picture_surfaces = 待清洗面与路径
page_picture_top = 俯视图

## 面
page_surfaces = 面与参数
page_surface = 面
page_area = 面积（mm²）
page_power = 功率（W）
page_speed = 速度（mm/s）
page_spot = 光斑（mm）
page_defocus = 离焦量（mm）
page_spacing = 行距（mm）
page_passes = 道数
page_worked = 加工长度（mm）
page_corrected = 已修正（mm）
page_blocked = 受阻（mm）
page_missed = 漏扫（mm²）

## 路径与干涉
page_path = 路径
page_interference = 修正前后的干涉
page_hits_along_normal = 沿法线出光会碰到物体的路径点
page_targets_corrected = 已修正的路径点
page_targets_blocked = 受阻的路径点
page_targets_all = 路径点总数
page_clearance = 光束与激光头的最小间隙
page_mm = { $mm } mm
page_moves_proven = 已验证无干涉的出光运动
page_margin = 已验证的安全裕量

## 剂量、扫描、时间
page_dose = 剂量
page_no_dose = 本报告未计算
page_scan = 扫描数据
page_time = 时间
page_time_whole = 程序
page_time_work = 出光
page_time_travel = 空行程
page_time_waiting = 等待

## 依据
page_assumed = 假定条件
page_nothing_assumed = 没有未经测量或检验的内容
page_frames_unmeasured = 随附工作站 { $cell } 的坐标系，仅为示例，未在现场测量
page_words_unchecked = 未在真实控制器或机器人上试过的指令与数据
page_files = 文件及其 SHA-256
page_read = 读入：{ $file }
