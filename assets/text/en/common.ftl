### Words that several rooms use.

text_facets = { $count ->
    [one] { $count } facet
   *[other] { $count } facets
}
text_cancelled = cancelled
file_not_read = { $file }: cannot be read: { $reason }
in_file = { $file }: { $what }
file_no_text = { $file }: is not text: { $reason }
