### 机器人工作站及其坐标系，以及更好的装夹布置。

## 工作站

cell_panel_heading = 工作站
cell_panel_robot = 机器人
cell_panel_robot_tip = 选定机器人后，可得知可达范围、限位和时间，并可观看其运动
cell_panel_no_robot = 无：仅位姿
cell_panel_robot_file = 机器人文件…
cell_panel_unverified = 该机器人的部分数据未经核对
cell_panel_unverified_tip = 请在您自己的机器人文件中核对：
cell_panel_carries = 手持
cell_panel_carries_tip = 手持零件、激光固定，或手持激光头、零件固定
cell_panel_the_part = 零件
cell_panel_carries_part = 手持零件
cell_panel_the_head = 激光头
cell_panel_carries_head = 手持激光头
cell_panel_spin = 绕光轴转角
cell_panel_spin_tip = 绕光束的旋转：自由（取手臂适合的角度），或相对行进方向固定
cell_panel_spin_name = 绕光轴转角：{ $spin }
cell_panel_program_for = 机器人语言
cell_panel_program_for_tip = 控制器所用的语言
cell_panel_words_unverified = 该语言的下列指令和数值没有公开资料可以证实：
cell_panel_frames = 坐标系
cell_panel_frames_tip = 激光、零件和法兰的位置；空行程、输出信号
cell_panel_cell_file = 工作站文件…
cell_panel_better_tip = 查找零件和激光的安放位置，使机器人能够到更多加工部位
cell_panel_better_running = 正在查找
cell_panel_nothing_refused = 机器人没有拒绝任何路径点
cell_panel_export = 导出程序…
cell_panel_export_from_pass = 从第 { $pass } 道起导出…
cell_panel_export_tip = 将程序、路径、报告和作业写入一个文件夹  { $keys }
cell_panel_not_planned = 规划尚未完成

## 坐标系

frames_laser_in_base = 激光（相对基座）
frames_laser_in_base_tip = 焦点在机器人基座坐标系中的位置；z 轴逆光束方向
frames_reset_laser_in_base = 重置激光（相对基座）
frames_part_on_flange = 零件（相对法兰）
frames_part_on_flange_tip = 零件的夹持方式：其原点和坐标轴相对法兰的位姿
frames_reset_part_on_flange = 重置零件（相对法兰）
frames_part_in_base = 零件（相对基座）
frames_part_in_base_tip = 零件在机器人基座坐标系中的位置
frames_reset_part_in_base = 重置零件（相对基座）
frames_head_on_flange = 激光头（相对法兰）
frames_head_on_flange_tip = 焦点相对法兰的位置；z 轴顺光束方向。在工作站文件中设定
frames_pose = { $x } { $y } { $z } mm  RZ { $rz }° RY { $ry }° RX { $rx }°
frames_field = { $frame } { $axis }
frames_set_for_job = 仅为本作业设定，取代工作站文件中的值
frames_back =
    恢复为工作站文件中的值：
    { $pose }
frames_move_tip = 用工作站视图中的箭头和圆环移动和转动，步距 0.5 mm 和 1°
frames_move_not = 请先显示机器人工作站
frames_three_points = 三点法测得
frames_three_points_tip = 只有三个点时没有残差，无法评判精度
frames_measured = 测得：均方根 { $rms } mm，最大 { $worst } mm
frames_point_off = 点 { $number }：{ $off } mm
frames_points_off = 各点的偏差
frames_pose_off = 位姿 { $number }：{ $off } mm
frames_poses_off = 各位姿的偏差

## 更好的装夹布置

proposal_looking = 正在查找更好的装夹布置…
proposal_cancel_tip = 可在状态栏中取消
proposal_none = 未找到更好的装夹布置
proposal_worth = 被拒绝的路径点由 { $refused } 个变为 { $left } 个 · 可达比例由 { $before } % 变为 { $after } %
proposal_worth_tip = 被拒绝的路径点数由采用这些坐标系的规划得出；可达比例由均匀分布在加工区域上的路径点检查得出，以圆点显示
proposal_shown = 工作站按建议的布置显示
proposal_apply = 应用
proposal_apply_tip = 将这些坐标系写入作业并重新规划；可用“撤销”恢复
proposal_dismiss = 放弃
proposal_dismiss_tip = Esc
proposal_within_reach = 可达
proposal_out_of_reach = 不可达
cell_panel_page = 同时写出报告页面
cell_panel_page_tip = report.html：图片、参数、已验证的内容、未完成的内容及原因；可供阅读、打印和存档
frames_examples = 示例坐标系：请自行测量
frames_examples_tip = 没有给出工作站文件：这些坐标系只是让示例零件处于可达范围内，并不属于任何真实设备。运行程序之前，请测量您自己的坐标系，写入工作站文件或在此处设置
cell_panel_shipped_cell = 该机器人的随附工作站
