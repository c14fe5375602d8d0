### Words that several rooms use.

list_and_next = { $list }, { $next }
list_and_next_clause = { $list }; { $next }
text_cancelled = cancelled
file_not_read = { $file }: cannot be read: { $reason }
in_file = { $file }: { $what }
file_no_text = { $file }: is not text: { $reason }
