### 激光头或接触式工具的文件有什么问题。

head_stack = { $file }：{ $what }；激光头应为 [[part]] 的列表，各含 from_mm、to_mm、r0_mm 和 r1_mm，或为 STL、OBJ、PLY 或 3MF 文件
stack_empty = 其中没有 [[part]]
stack_span = 第 { $line } 行：第 { $part } 个 [[part]]：from_mm = { $from }，to_mm = { $to }：应为 -1000 至 10000，小的在前
stack_radii = 第 { $line } 行：第 { $part } 个 [[part]]：r0_mm = { $r0 }，r1_mm = { $r1 }：应为 0 至 2000，不能都为 0
contact_tool_missing = 缺少 { $key }：砂轮片需要 kind = "disc"、radius_mm、edge_mm、thickness_mm 以及 contact = "rim" 或 "face"；砂带需要 kind = "belt"、radius_mm（接触轮半径）和 width_mm
contact_tool_needless = 第 { $line } 行：{ $key } 不适用于此类工具：请去掉
contact_tool_range = 第 { $line } 行：{ $key } = { $value }：应为 { $low } 至 { $high }
