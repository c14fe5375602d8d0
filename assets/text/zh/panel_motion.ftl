### 规划随时间的过程：步进、时间条、曲线和程序文本。

## 步进

timeline_nothing_chosen = 将面移入待清洗列表，其路径会显示在这里
timeline_no_plan = 没有规划：请查看问题
timeline_stopped = 规划已停止；按 { $keys } 重新规划
timeline_planning_at = 正在规划：{ $activity }，{ $percent } %
timeline_planning = 正在规划
timeline_no_line = 没有扫描线经过所选的面
timeline_times = { $now } / { $total }
timeline_times_tip = 时、分、秒
timeline_work = 加工
timeline_travel = 空行程
timeline_waiting = 等待
timeline_left_out = 略去 { $count } 个路径点
timeline_play = ▶ 播放
timeline_pause = 暂停
timeline_speed_prefix = { "× " }
timeline_speed_tip = 实际速度的倍数
timeline_speed_name = 播放速度
timeline_loop = 循环
timeline_pass = 道
timeline_pass_name = 道
timeline_point = 点
timeline_point_name = 点

## 路径点

timeline_free = 无干涉
timeline_corrected = 已修正
timeline_blocked = 受阻
timeline_place = 第 { $pass } 道 · 第 { $point } 点
timeline_laser_on = 出光
timeline_laser_off = 关光
timeline_grinding = 打磨中
timeline_not_grinding = 未打磨
timeline_tilt = 倾角 { $angle }°
timeline_xyz = x { $x }  y { $y }  z { $z }
timeline_flange = 法兰 { $x } { $y } { $z } mm  RZ { $rz }° RY { $ry }° RX { $rx }°
timeline_flange_tip = 法兰在机器人基座坐标系中的位姿

## 时间条

scrub_name = 时间
scrub_mark =
    第 { $pass } 道 · 第 { $point } 点起，共 { $count } 个路径点：{ $cause }
    单击可转到该处

## 曲线

plots_seconds = { $value } s
plots_joint = J{ $joint }
plots_joints_name = 关节角曲线
plots_joints = 关节角，° · 距限位最近 { $margin }°
plots_speeds_name = 关节速度曲线
plots_speeds = 关节速度，占最大速度的 % · 最大 { $percent } % { $joint }
plots_angles_name = 法兰姿态角曲线
plots_angles = 法兰相对基座，°
plots_singularity_name = 距奇异的距离曲线
plots_singularity = 距奇异 · 最小 { $distance }
plots_distance = 距离
plots_clearance_name = 间隙曲线
plots_clearance_none = 间隙，mm · …
plots_clearance_beyond = 间隙，mm · 均大于 { $reach } mm
plots_clearance = 间隙，mm · 最小 { $least } { $pair }
plots_nearest = 最近
plots_or_more = 或更大

## 程序文本

program_panel_heading = 程序
program_panel_out_of_date = 程序：已过期
program_panel_files = { $count } 个文件
program_panel_none = 没有可显示的程序

## 停机后续作
going_on_tip = 第 { $pass } 道之前的各道视为已完成；其余部分生成单独的程序
going_on_no_pass = 该面上没有规划扫描线
going_on_chip = 从第 { $pass } 道起 ×
going_on_chip_tip = 第 { $pass } 道之前的各道视为已完成，导出从该道开始。单击可恢复所有道。
