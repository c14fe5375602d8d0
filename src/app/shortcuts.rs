//! Keys of commands: which were pressed in this frame.

use super::command::Command;
use eframe::egui::Context;
use std::cmp::Reverse;

/// Commands whose keys were pressed. While a text is being typed, keys that are of use there belong to it.
pub(super) fn pressed(ctx: &Context) -> Vec<Command> {
    let is_typing = ctx.text_edit_focused();
    let mut rows: Vec<_> = Command::ALL.iter().filter_map(|c| Some((c.keys()?, *c))).collect();
    // More modifiers first: Shift+H is not H.
    rows.sort_by_key(|(k, _)| {
        let m = k.modifiers;
        Reverse(u8::from(m.alt) + u8::from(m.shift) + u8::from(m.command))
    });
    rows.retain(|(_, command)| !is_typing || is_given_while_typing(*command));
    rows.into_iter().filter(|(keys, _)| ctx.input_mut(|i| i.consume_shortcut(keys))).map(|(_, c)| c).collect()
}

/// In a text, Ctrl+A and Ctrl+Z belong to the text.
fn is_given_while_typing(command: Command) -> bool {
    use Command as C;
    matches!(command, C::Open | C::Save | C::SaveAs | C::Export | C::Plan)
}
