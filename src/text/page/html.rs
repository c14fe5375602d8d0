//! Pieces of HTML: escaped words, tables, lists, pictures within the file.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use std::fmt::Write as _;

/// One file for screen and paper, without anything from elsewhere.
const STYLE: &str = "\
body{font:15px/1.5 system-ui,'Noto Sans SC','Microsoft YaHei',sans-serif;color:#1b2733;max-width:60rem;margin:2rem auto;padding:0 1rem}\
h1{font-size:1.6rem;margin:0}h2{font-size:1.1rem;margin:1.6rem 0 .4rem;border-bottom:1px solid #c9d3dc}\
p,ul{margin:.3rem 0}table{border-collapse:collapse;width:100%;font-size:.9rem}\
th,td{padding:.25rem .5rem;border-bottom:1px solid #dde4ea;text-align:right;vertical-align:top}\
th:first-child,td:first-child{text-align:left}td.code{font:12px/1.4 monospace;word-break:break-all;text-align:left}\
img{max-width:100%;border:1px solid #dde4ea}figure{margin:.6rem 0}figcaption{color:#526170}\
.state{font-weight:600}.unsafe{color:#b00020}.undone{color:#8a4b00}\
@media print{body{margin:0;max-width:none}h2{break-after:avoid}tr,figure{break-inside:avoid}}";

/// A page that is being written.
pub(super) struct Html(String);

impl Html {
    /// A page in a language, by its code.
    pub fn new(language: &str, title: &str) -> Html {
        let title = escaped(title);
        Html(format!(
            "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
             </head>\n<body>\n<h1>{title}</h1>\n"
        ))
    }

    /// A heading, from which a section begins.
    pub fn section(&mut self, heading: &str) {
        let _ = writeln!(self.0, "<h2>{}</h2>", escaped(heading));
    }

    /// A paragraph of a class; an empty one has none.
    pub fn paragraph(&mut self, class: &str, words: &str) {
        let _ = writeln!(self.0, "<p class=\"{class}\">{}</p>", escaped(words));
    }

    /// A list of lines, each of a class.
    pub fn list<'w>(&mut self, lines: impl IntoIterator<Item = (&'static str, &'w str)>) {
        self.0.push_str("<ul>\n");
        for (class, words) in lines {
            let _ = writeln!(self.0, "<li class=\"{class}\">{}</li>", escaped(words));
        }
        self.0.push_str("</ul>\n");
    }

    /// A table with its heads; without heads, of names and what belongs to them.
    pub fn table(&mut self, heads: &[String], rows: &[Vec<String>]) {
        self.0.push_str("<table>\n");
        if !heads.is_empty() {
            self.row("th", heads, "");
        }
        rows.iter().for_each(|row| self.row("td", row, ""));
        self.0.push_str("</table>\n");
    }

    /// A table of names and codes.
    pub fn codes(&mut self, rows: &[Vec<String>]) {
        self.0.push_str("<table>\n");
        rows.iter().for_each(|row| self.row("td", row, " class=\"code\""));
        self.0.push_str("</table>\n");
    }

    fn row(&mut self, tag: &str, cells: &[String], of_others: &str) {
        self.0.push_str("<tr>");
        for (i, cell) in cells.iter().enumerate() {
            let class = if i > 0 { of_others } else { "" };
            let _ = write!(self.0, "<{tag}{class}>{}</{tag}>", escaped(cell));
        }
        self.0.push_str("</tr>\n");
    }

    /// A PNG picture.
    pub fn picture(&mut self, name: &str, png: &[u8]) {
        let (name, data) = (escaped(name), STANDARD.encode(png));
        let _ = writeln!(
            self.0,
            "<figure><img alt=\"{name}\" src=\"data:image/png;base64,{data}\"><figcaption>{name}</figcaption></figure>"
        );
    }

    /// The whole page.
    pub fn finished(mut self) -> String {
        self.0.push_str("</body>\n</html>\n");
        self.0
    }
}

/// Words as text of HTML, also within quotation marks.
fn escaped(words: &str) -> String {
    let mut out = String::with_capacity(words.len());
    for c in words.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_file_are_no_marks() {
        let mut page = Html::new("en", "a \"b\" <script>");
        page.paragraph("", "x & y");
        page.picture("1 < 2", &[0, 255, 16]);
        let text = page.finished();
        assert!(text.contains("<h1>a &quot;b&quot; &lt;script&gt;</h1>") && text.contains("x &amp; y"));
        assert!(text.contains("alt=\"1 &lt; 2\" src=\"data:image/png;base64,AP8Q\""));
    }
}
