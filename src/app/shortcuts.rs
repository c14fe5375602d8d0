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
    matches!(command, C::Open | C::OpenScan | C::Save | C::SaveAs | C::Export | C::ExportDryRun | C::Plan | C::Palette)
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::{Event, Key, Modifiers, RawInput};

    fn given(modifiers: Modifiers, key: Key) -> Vec<Command> {
        let ctx = Context::default();
        let press = Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers };
        ctx.begin_pass(RawInput { events: vec![press], ..RawInput::default() });
        let commands = pressed(&ctx);
        ctx.end_pass().textures_delta.clear();
        commands
    }

    #[test]
    fn keys_give_their_command_and_no_other() {
        for command in Command::ALL {
            let Some(keys) = command.keys() else { continue };
            assert_eq!(given(keys.modifiers, keys.logical_key), [*command]);
        }
        assert_eq!(given(Modifiers::NONE, Key::F12), []);
    }
}
