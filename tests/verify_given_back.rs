//! What controllers and editors do to a program by themselves is passed over: dates, counts, names, folds, comments, blank
//! lines, ends of lines, blanks and tabs, large and small letters where the language has none, digits.

#[path = "common/small_programs.rs"]
mod small_programs;

use clearbeam::program::{Program, ProgramFile, WITHOUT_WORDS};
use small_programs::{Case, cases};

/// Passes if nothing is found in the programs as they were changed.
fn passes(case: &Case, what: &str, change: impl Fn(&str) -> String) {
    let text = |f: &ProgramFile| ProgramFile { name: f.name.clone(), text: change(&f.text) };
    let files: Vec<ProgramFile> = case.files.iter().map(text).collect();
    assert!(files != case.files, "{}: {what} changes nothing", case.name());
    let plan = case.as_written();
    assert!(case.is_known(&files), "{}, {what}: of no dialect", case.name());
    match case.differences(&plan, &files) {
        Ok(found) => assert_eq!(found, [], "{}, {what}:\n{}", case.name(), files[0].text),
        Err(e) => panic!("{}, {what}: {e}\n{}", case.name(), files[0].text),
    }
}

fn each_line(text: &str, change: impl Fn(&str) -> String) -> String {
    text.lines().map(|l| change(l) + "\n").collect()
}

/// The text with every number of five digits and more behind the point cut to six that count.
fn six_digits(text: &str) -> String {
    let short = |word: &str| match word.parse::<f64>() {
        Ok(v) if word.split_once('.').is_some_and(|(_, d)| d.len() > 3) => {
            let whole = (v.abs().log10().floor() as i32 + 1).max(0);
            format!("{v:.0$}", (6 - whole).max(0) as usize).trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        _ => word.to_owned(),
    };
    let mut out = String::new();
    for piece in text.split_inclusive([',', ']', '\n']) {
        let (body, end) = piece.split_at(piece.len() - 1);
        let at = body.rfind(['[', '=']).map_or(0, |i| i + 1);
        out += &format!("{}{}{end}", &body[..at], short(&body[at..]));
    }
    out
}

#[test]
fn line_ends_blanks_and_blank_lines_do_nothing() {
    for case in cases() {
        passes(&case, "LF", |t| if t.contains('\r') { t.replace("\r\n", "\n") } else { t.replace('\n', "\r\n") });
        passes(&case, "CR", |t| t.replace("\r\n", "\n").replace('\n', "\r"));
        passes(&case, "blanks behind", |t| each_line(t, |l| format!("{l} \t ")));
        passes(&case, "tabs before", |t| each_line(t, |l| format!("\t {l}")));
        passes(&case, "blank lines", |t| each_line(t, |l| format!("{l}\n  \n")));
        passes(&case, "a mark of the encoding", |t| format!("\u{feff}{t}"));
        if case.dialect.name() != "csv" {
            passes(&case, "tabs and more blanks", |t| each_line(t, |l| l.replace(' ', " \t")));
        }
    }
}

#[test]
fn letters_do_nothing_where_the_language_has_one_size() {
    for case in cases().into_iter().filter(|c| ["kuka", "abb", "fanuc"].contains(&c.dialect.name())) {
        passes(&case, "small letters", str::to_ascii_lowercase);
        passes(&case, "large letters", str::to_ascii_uppercase);
    }
}

#[test]
fn comments_by_hand_do_nothing() {
    for case in cases() {
        let (line, behind) = match case.dialect.name() {
            "nachi" => ("' checked\nREM \"again\"", None),
            "kuka" => (";FOLD PTP HOME\n; checked\n;ENDFOLD", Some(" ; $OUT[3]=TRUE")),
            "abb" => ("! checked", Some(" ! SetDO do3,1;")),
            "ur" => ("# checked", Some(" # end")),
            "yaskawa" => ("'checked", None),
            "estun" => ("// checked\n/* again */", None),
            "fanuc" => ("   9:  !checked ;\n   9:   ;\n   9:  --eg:checked ;", None),
            _ => continue,
        };
        // Behind the first signal, which is within the program.
        let marks = ["O3", "$OUT[3]", "do3,", "DO[3]", "_out(3", "OT#(3)", "DO3"];
        passes(&case, "a comment", |t| {
            each_line(t, |l| if marks.iter().any(|m| l.contains(m)) { format!("{line}\n{l}") } else { l.into() })
        });
        if let Some(behind) = behind {
            passes(&case, "a comment behind", |t| each_line(t, |l| format!("{l}{behind}")));
        }
    }
}

#[test]
fn what_controllers_keep_for_themselves_does_nothing() {
    for case in cases() {
        match case.dialect.name() {
            "fanuc" => {
                passes(&case, "application", |t| t.replace("/MN", "/APPL\n  SPOT : TRUE ;\n\n  LINE_TRACK ;\n/MN"));
                passes(&case, "dates and sizes", |t| {
                    let dated =
                        t.replace("PROG_SIZE = 0;", "PROG_SIZE\t= 1234;\nCREATE\t\t= DATE 26-11-28  TIME 10:00:00;");
                    dated
                        .replace("OWNER = MNEDITOR;", "OWNER\t\t= OPERATOR;\nFILE_NAME\t= ;\nVERSION\t\t= 3;")
                        .replace(" = ", "\t\t= ")
                });
                passes(&case, "names", |t| {
                    t.replace("DO[3]", "DO[ 3:laser on]")
                        .replace("]{", ":\"a ] point\"]{")
                        .replace("a ] point", "a point")
                });
                passes(&case, "blanks of moves", |t| t.replace("FINE ;", "FINE    ;").replace("P[1] ", "P[1:home] "));
                passes(&case, "three decimals", |t| {
                    each_line(t, |l| {
                        if l.starts_with('\t') { l.replace("0 deg", " deg").replace(" mm", "  mm") } else { l.into() }
                    })
                });
            }
            "kuka" => {
                passes(&case, "attributes", |t| {
                    t.replace("&REL 1", "&REL 27\n&PARAM EDITMASK = *\n&PARAM TEMPLATE = C:\\KRC\\vorgabe")
                });
                passes(&case, "folds", |t| {
                    t.replace("BAS(#INITMOV,0)", ";FOLD INI;%{PE}\n  BAS (#INITMOV, 0 )\n;ENDFOLD (INI)")
                });
                passes(&case, "points in the data list", |t| {
                    t.replace("ENDDAT", "DECL E6POS XP1={X 1.0,Y 2.0}\nENDDAT").replace("&ACCESS RVP", "&ACCESS RVO")
                });
            }
            "yaskawa" => passes(&case, "dates", |t| {
                let dated = t.replace("///DATE 2020/01/01 00:00", "///DATE 2026/11/28 10:02");
                dated.replace("///COMM clearbeam", "///COMM").replace("SC,RW,RJ", "SC,RW,RJ,TEST")
            }),
            "abb" => {
                passes(&case, "version", |t| format!("%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\n\n{t}"));
                passes(&case, "six digits", |t| six_digits(t).replace("9E9", "9E+09"));
            }
            "ur" => passes(&case, "indents", |t| each_line(t, |l| format!("  {}", l.trim()).replace(", r=", ",r = "))),
            _ => {}
        }
    }
}

#[test]
fn a_data_list_counts_where_it_says_which_outputs_a_name_stands_for() {
    let mut case = cases().into_iter().find(|c| c.dialect.name() == "kuka").expect("KUKA");
    case.setup.cell.kuka.data.push("SIGNAL GROUP2 $OUT[9] TO $OUT[16]".into());
    let program = Program { head: Vec::new(), lines: case.lines.clone(), setup: &case.setup, wording: WITHOUT_WORDS };
    case.files = case.dialect.write(&program).expect("writes");
    let plan = case.as_written();
    let found = |change: &dyn Fn(&mut Vec<ProgramFile>)| {
        let mut files = case.files.clone();
        change(&mut files);
        case.differences(&plan, &files).expect("reads").len()
    };
    let data = case.files.iter().position(|f| f.name.ends_with(".dat")).expect("a data list");
    assert_eq!(found(&|_| {}), 0);
    assert_eq!(found(&|f| f[data].text = f[data].text.replace("SIGNAL GROUP2", "signal  group2")), 0);
    assert_eq!(found(&|f| f[data].text = f[data].text.replace("$OUT[9]", "$OUT[3]")), 1);
    let is_gone = found(&|f| {
        f.remove(data);
    });
    assert_eq!(is_gone, 1, "without a data list nothing says what the name stands for");
}
