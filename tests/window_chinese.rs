//! The window in Chinese. The language is the whole process's, so nothing else is tested here, and one test at a time.

mod common;

use clearbeam::app::{App, Command};
use clearbeam::text::{choose, language_of};
use common::window::{Answers, sample, settle, snapshot, window};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A window on a sample in a language, which nobody changes meanwhile.
fn window_in(code: &str, open: Option<&str>) -> (MutexGuard<'static, ()>, Harness<'static, App>) {
    static TURN: Mutex<()> = Mutex::new(());
    let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    choose(language_of(code).expect("a language"));
    let mut h = window(open.map(sample), &Answers::default());
    settle(&mut h);
    (turn, h)
}

/// All that the window says, to eyes and to readers of screens.
fn said(h: &Harness<'_, App>) -> Vec<String> {
    let words = |node: egui_kittest::Node<'_>| [node.accesskit_node().label(), node.accesskit_node().value()];
    h.query_all_by(|_| true).flat_map(words).flatten().filter(|w| !w.is_empty()).collect()
}

/// Three English words in a row: names of files, keys and units have none.
fn is_english(words: &str) -> bool {
    let is_word = |w: &&str| w.len() > 1 && w.chars().all(|c| c.is_ascii_lowercase());
    let list: Vec<&str> = words.split_whitespace().collect();
    list.windows(3).any(|three| three.iter().all(is_word))
}

fn assert_chinese(h: &Harness<'_, App>) {
    let said = said(h);
    let has_chinese = |w: &&String| w.chars().any(|c| ('\u{4e00}'..='\u{9fff}').contains(&c));
    assert!(said.iter().filter(has_chinese).count() > 10, "{said:?}");
    let english: Vec<&String> = said.iter().filter(|w| is_english(w)).collect();
    assert!(english.is_empty(), "{english:?}");
}

#[test]
fn nothing_is_said_in_english() {
    let (_turn, mut h) = window_in("zh", None);
    assert_chinese(&h);
    h.state_mut().give(Command::Help, &[]);
    settle(&mut h);
    assert_chinese(&h);
    let (_turn, mut h) = {
        drop((_turn, h));
        window_in("zh", Some("workpiece.toml"))
    };
    assert_chinese(&h);
    let folded = [
        ("路径", &["边缘、衔接、遍数", "面的工艺配方", "工艺配方库", "路径点、引入引出"][..]),
        ("光束", &["光学参数", "夹具"]),
        ("零件", &[]),
        ("机器人", &[]),
        ("剂量", &[]),
    ];
    for (tab, headings) in folded {
        h.get_by_label(&format!("设置：{tab}")).click();
        settle(&mut h);
        for heading in headings {
            h.get_by_label(heading).scroll_to_me();
            settle(&mut h);
            h.get_by_label(heading).click();
            settle(&mut h);
        }
        assert_chinese(&h);
    }
}

#[test]
fn the_language_changes_while_the_window_is_open() {
    let (_turn, mut h) = window_in("en", Some("workpiece.toml"));
    assert!(h.query_by_label("File").is_some() && h.query_by_label("文件").is_none());
    let job = h.state().document().job().clone();
    h.state_mut().give(Command::Language, &[]);
    settle(&mut h);
    assert!(h.query_by_label("File").is_none() && h.query_by_label("文件").is_some());
    assert_chinese(&h);
    h.state_mut().give(Command::Language, &[]);
    settle(&mut h);
    assert!(h.query_by_label("File").is_some() && h.query_by_label("文件").is_none());
    assert_eq!(*h.state().document().job(), job, "no words are in the job");
}

#[test]
fn chinese_is_drawn() {
    let (_turn, mut h) = window_in("zh", Some("workpiece.toml"));
    snapshot(&mut h, "chinese");
    choose(language_of("en").expect("a language"));
}
