### Words that several rooms use.

list_and_next = { $list }, { $next }
list_and_next_clause = { $list }; { $next }
text_cancelled = cancelled
file_not_read = { $file }: cannot be read: { $reason }
in_file = { $file }: { $what }
in_line_of_file = { $file }: line { $line }: { $what }
in_line = line { $line }: { $what }
no_text_utf16 = is UTF-16, which some editors call Unicode; save it as UTF-8
no_text_byte = line { $line }: a letter is not in UTF-8 (byte { $byte }), perhaps an umlaut or accent in Latin-1; save the file as UTF-8
toml_at = line { $line }: { $key }: { $what }
toml_backslash = a backslash in double quotes begins a special character; write paths with /, or in single quotes: 'C:\parts\box.stl'
toml_not_finite = { $value } is no number to work with; give a finite one
toml_unknown_meant = there is no such key; did you mean { $meant }?
toml_unknown_key = there is no such key; known here: { $known }
