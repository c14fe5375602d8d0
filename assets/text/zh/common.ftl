### 多处共用的词句。

list_and_next = { $list }、{ $next }
list_and_next_clause = { $list }；{ $next }
text_cancelled = 已取消
file_not_read = { $file }：无法读取：{ $reason }
in_file = { $file }：{ $what }
in_line_of_file = { $file }：第 { $line } 行：{ $what }
in_line = 第 { $line } 行：{ $what }
no_text_utf16 = 文件是 UTF-16 编码（有的编辑器称为 Unicode）；请另存为 UTF-8
no_text_byte = 第 { $line } 行：有字符不是 UTF-8 编码（字节 { $byte }），文件可能是 GBK 或 Latin-1 编码；请另存为 UTF-8
toml_at = 第 { $line } 行：{ $key }：{ $what }
toml_backslash = 双引号中的反斜杠是转义符；路径请用 / 书写，或放在单引号中：'C:\parts\box.stl'
toml_not_finite = { $value } 不能用于计算；请给出有限的数值
toml_unknown_meant = 没有这个键；是否应为 { $meant }？
toml_unknown_key = 没有这个键；此处可用的键：{ $known }
