### 规划未能导出的原因。

export_conflicts = { $folder }：未写入任何文件：{ $list }
export_busy = { $folder }：正在向此文件夹进行另一次导出；请等待其完成，或选择其他文件夹
export_name = 程序将以“{ $name }”为文件名，但它不是此文件夹内可独立使用的文件名；请在工作站文件中改用其他名称
export_unwritable = 无法生成程序：{ $reason }
export_unreadable = 无法回读程序：{ $reason }
export_not_the_plan = 回读的程序与规划不符：{ $file }:{ $line }：{ $what }（共 { $findings } 项检查结果）；未写入任何文件
export_dose = 无法计算剂量：{ $reason }

## 妨碍导出的文件
conflict_changed_by_hand = { $name } 在导出后被手动修改过
conflict_other_job = { $name } 属于零件 { $part } 的作业 { $job }
conflict_no_exports = { $name } 不是由本软件导出到此处的
conflict_earlier_version = { $name } 由较早的版本导出，该版本没有记录其导出的文件
conflict_folder = { $name } 是文件夹
