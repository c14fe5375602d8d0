### 保存的内容：作业、工艺配方和未保存更改的日志。

## 作业

job_part_gone = 找不到零件 { $file }；请将其放回，或更正作业中的 `part.file`
job_part_changed = 零件 { $file } 在作业保存后已更改，各面的编号可能不同；请在窗口中打开作业，或进行规划：两者都会列出重新找到的面
job_beam_blocked = { $cell }：bodies.obstacles：{ $obstacle } 挡住固定不动的光束；请移动其中之一
job_head_blocked = { $cell }：bodies.obstacles：{ $obstacle } 挡住固定不动的激光头；请移动其中之一
job_changed_on_disk = { $file }：在此打开后，已被其他窗口或程序更改；请另存为其他名称、重新打开，或将其覆盖：现有文件将变为 { $file }.bak
job_not_serialized = 无法生成作业文件：{ $reason }
job_not_written = { $file }：无法写入：{ $reason }；请选择其他文件夹
job_not_removed = { $file }：无法删除：{ $reason }；请选择其他文件夹

## 作业文件的文本

not_utf8 = 不是 UTF-8 文本：{ $reason }
job_file_later = version = { $version }：此作业由更新版本的 clearbeam 保存，当前版本最高支持 version { $known } 的作业；请用更新版本的 clearbeam 打开
job_file_no_version = version = { $version }：请改为 { $known }；若是 version 1 的作业，请删去此行
job_file_twice = { $key }：面 { $surface } 列出了两次；只能列出一次
job_file_no_number = { $key }：“{ $text }”不是面的编号；请给出编号，例如 4

## 单个面的起始处及其失去的设置

start_whole = 整个轮廓
start_border = 边界 { $number }
dropped_border = 面 { $surface } 的边界设置已取消
dropped_pins = 面 { $surface } 的 { $pins } 个固定倾角已取消
dropped_pins_and_border = 面 { $surface } 的 { $pins } 个固定倾角和边界设置已取消

## 工艺配方库

library_no_folder = 没有存放工艺配方的文件夹：请设置环境变量 HOME
library_folder_not_made = { $folder }：无法创建：{ $reason }；请将 HOME 设为其他文件夹
library_not_serialized = 工艺配方“{ $name }”：无法写入：{ $reason }
library_unknown = 您自己的工艺配方中没有“{ $name }”
library_not_renamed = { $file }：无法重命名：{ $reason }；请检查该处的写入权限
library_taken = 工艺配方“{ $name }”无法恢复：其位置已被另一个占用；请先将那一个重命名或删除
library_broken = { $file }：{ $why }；请更正或删除该文件
recipe_not_read = 无法读取：{ $reason }
recipe_too_long = 共 { $bytes } 字节，超出工艺配方的上限
recipe_no_name = 工艺配方没有名称
recipe_name_taken = 名称“{ $name }”与 { $other } 的名称重复

## 未保存更改的日志

journal_no_folder = { $folder }：无法在此保存未保存更改的日志：{ $reason }；请经常保存作业，并检查该文件夹
journal_not_written = { $file }：未保存的更改无法记录于此：{ $reason }；请保存作业，然后检查磁盘
journal_no_job = 未保存的更改无法记入日志：{ $what }
journal_bad_name = 未保存的更改无法记入日志：{ $reason }；请换用简单的文件名保存作业
journal_unreadable = { $file }：由异常退出的程序遗留，无法读取：{ $what }；请查看后将其删除
journal_no_owner = 首行未注明所属的作业
journal_bad_owner = 首行：{ $reason }
journal_damaged = 内容已损坏，与写入时不一致

## 含全部文件的作业包
package_archive = 作业包无法读取：文件不完整或不是作业包；请重新复制
package_no_job = 不是作业包
package_later = 此作业包由更高版本的 clearbeam 写出（schema { $schema }）；请使用该版本
package_name = 作业包中有文件会落到文件夹之外：{ $name }；请勿使用
package_too_large = 作业包内容超过 { $most } MiB
package_occupied = 作业包要解压到 { $folder }，但其中的 { $file } 内容不同：请打开那里的作业，或移走该文件夹
package_outside = 它引用了自身文件夹之外的 { $file }；请把该文件放到它旁边
package_unwritable = 作业包无法写出：{ $reason }
