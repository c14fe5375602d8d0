//! What *Undo* and *Redo* call a step.

use super::parameter::label;
use super::{Arg, Sentence, id, say};
use crate::document::{Edit, Parameter, ScanEdit, UndoStep, WeldEdit};
use crate::part::SurfaceId;

impl Sentence for UndoStep {
    fn sentence(&self) -> String {
        match self {
            UndoStep::Edited(edit) => edit.sentence(),
            UndoStep::Restored => say!(step_restored),
        }
    }
}

impl Sentence for Edit {
    fn sentence(&self) -> String {
        match self {
            Edit::Set(key, _) | Edit::Recut { key, .. } => say!(edit_parameter, parameter = parameter(key)),
            Edit::Direction(_) => say!(edit_direction),
            Edit::Offset(_) => say!(edit_offset),
            Edit::Order(_) => say!(edit_order),
            Edit::Strategy(_) => say!(edit_strategy),
            Edit::Border(_) => say!(edit_border),
            Edit::Centre(_) => say!(edit_centre),
            Edit::Inward(_) => say!(edit_inward),
            Edit::Correction(_) => say!(edit_correction),
            Edit::Bead(_) => say!(edit_bead),
            Edit::Profile(_) => say!(edit_profile),
            Edit::Recipe(recipe, _) => say!(edit_recipe, name = &recipe.name),
            Edit::RemoveRecipe(name) => say!(edit_remove_recipe, name),
            Edit::DuplicateRecipe(name) => say!(edit_duplicate_recipe, name),
            Edit::RenameRecipe(name, _) => say!(edit_rename_recipe, name),
            Edit::Place(_) => say!(edit_place),
            Edit::Units(_) => say!(edit_units),
            Edit::Weld { .. } => say!(edit_weld),
            Edit::ChangedPart(_) => say!(edit_changed_part),
            Edit::Cell(_) => say!(edit_cell),
            Edit::Robot(..) => say!(edit_robot),
            Edit::Mount(_) => say!(edit_mount),
            Edit::Frames(_) => say!(edit_frames),
            Edit::Dialect(_) => say!(edit_dialect),
            Edit::Spin(_) => say!(edit_spin),
            Edit::Head(file) if file.is_empty() => say!(edit_no_head),
            Edit::Head(_) => say!(edit_head),
            Edit::Clamps(_) => say!(edit_clamps),
            Edit::Scan(edit) => edit.sentence(),
            Edit::Grind(edit) => edit.sentence(),
            Edit::FlipShell(shell) => say!(edit_flip_shell, shell = id(shell)),
            Edit::GiveRecipe(list, Some(recipe)) => {
                say!(edit_give_recipe, count = list.len(), surface = first(list), name = &recipe.name)
            }
            Edit::GiveRecipe(list, None) => say!(edit_take_recipe, count = list.len(), surface = first(list)),
            Edit::Clean(list) => say!(edit_clean, count = list.len(), surface = first(list)),
            Edit::Unclean(list) => say!(edit_unclean, count = list.len(), surface = first(list)),
            Edit::Shift(list, _) => say!(edit_shift, count = list.len(), surface = first(list)),
            Edit::Reorder(_) => say!(edit_reorder),
            Edit::Merge(list) => say!(edit_merge, count = list.len(), surface = first(list)),
            Edit::Split { surface, .. } => say!(edit_split, surface = id(surface)),
            Edit::Cut(cut) => say!(edit_cut, facets = cut.facets.len(), surface = id(cut.of)),
            Edit::Later { surfaces, .. } => say!(edit_put_aside, count = surfaces.len(), surface = first(surfaces)),
            Edit::TakeBack(list) => say!(edit_take_back, count = list.len(), surface = first(list)),
            Edit::RenameSeveral(list, _) => say!(edit_rename_several, count = list.len()),
            Edit::Rename(surface, _) => say!(edit_rename, surface = id(surface)),
            Edit::SurfaceBorder(surface, _) => say!(edit_surface_border, surface = id(surface)),
            Edit::SurfaceCentre(surface, _) => say!(edit_surface_centre, surface = id(surface)),
            Edit::FlipSurface(surface) => say!(edit_flip_surface, surface = id(surface)),
            Edit::Tilt(surface, _) => say!(edit_tilt, surface = id(surface)),
            Edit::Pins(surface, _) => say!(edit_pins, surface = id(surface)),
        }
    }
}

impl Sentence for WeldEdit {
    /// What it does, as the name of a step to undo.
    fn sentence(&self) -> String {
        match self {
            WeldEdit::Images(images) if images.gray.file.is_empty() => say!(edit_no_weld),
            WeldEdit::Images(_) => say!(edit_weld_images),
            WeldEdit::Changed { .. } => say!(edit_changed_image),
            WeldEdit::Ground(..) => say!(edit_ground_pass),
            WeldEdit::Threshold(_) => say!(edit_threshold),
            WeldEdit::Paint(stroke) if stroke.adds => say!(edit_paint_mask),
            WeldEdit::Paint(_) => say!(edit_erase_mask),
            WeldEdit::Unpaint => say!(edit_unpaint),
            WeldEdit::Strategy(_) => say!(edit_grinding_strategy),
            WeldEdit::BeadStrategy(_) => say!(edit_bead_strategy),
            WeldEdit::Areas(_) => say!(edit_areas),
            WeldEdit::HandEye(_) => say!(edit_hand_eye),
            WeldEdit::Tool(_) => say!(edit_grinding_tool),
            WeldEdit::GoesOn(true) => say!(edit_goes_on),
            WeldEdit::GoesOn(false) => say!(edit_held),
            WeldEdit::Roughness(_) => say!(edit_roughness),
        }
    }
}

impl Sentence for ScanEdit {
    /// Cleaning steps count from 1.
    fn sentence(&self) -> String {
        match self {
            ScanEdit::Files(files, _) if files.is_empty() => say!(edit_no_scan),
            ScanEdit::Files(..) => say!(edit_scan),
            ScanEdit::AddStep(_) => say!(edit_add_step),
            ScanEdit::RemoveStep(at) => say!(edit_remove_step, step = id(at.saturating_add(1))),
            ScanEdit::AlterStep(at, _) => say!(edit_alter_step, step = id(at.saturating_add(1))),
            ScanEdit::Transform(None) => say!(edit_no_transform),
            ScanEdit::Transform(Some(_)) => say!(edit_transform),
            ScanEdit::Pairs(_) => say!(edit_pairs),
            ScanEdit::LeftOut(_) => say!(edit_left_out),
            ScanEdit::Patches(_) => say!(edit_patches),
            ScanEdit::OwnScan(..) => say!(edit_own_scan),
            ScanEdit::Continued(_) => say!(edit_continued),
            ScanEdit::Together(_) => say!(edit_together),
            ScanEdit::Work(_) => say!(edit_scan_work),
            ScanEdit::Lines(_) => say!(edit_scan_lines),
            ScanEdit::Scanner(..) => say!(edit_base_from_scan),
        }
    }
}

/// The number of the first surface, which a message names if there is only one.
fn first(list: &[SurfaceId]) -> Arg<'static> {
    list.first().map_or_else(|| "".into(), id)
}

/// A parameter within a sentence.
fn parameter(key: &str) -> String {
    Parameter::by_key(key).map_or_else(|| key.to_owned(), label).to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Cut, Recipe};
    use crate::part::Units;
    use crate::path::Strategy;

    #[test]
    fn steps_have_names() {
        let ids = |numbers: &[u32]| numbers.iter().copied().map(SurfaceId).collect::<Vec<_>>();
        let recipe = |name: &str| Box::new(Recipe { name: name.into(), ..Recipe::default() });
        let facets = (0..1200).collect();
        for (edit, name) in [
            (Edit::Set("layers.spacing_mm", 1.0), "change spacing"),
            (Edit::Strategy(Strategy::Spiral), "change strategy"),
            (Edit::Centre(Some([1.0, 2.0, 3.0])), "change spiral centre"),
            (Edit::Inward(true), "turn spiral"),
            (Edit::Border(Some(1)), "change border"),
            (Edit::Recipe(recipe("Fine"), ids(&[2, 3])), "change recipe Fine"),
            (Edit::RemoveRecipe("Finish".into()), "remove recipe Finish"),
            (Edit::DuplicateRecipe("A".into()), "duplicate recipe A"),
            (Edit::RenameRecipe("Fine".into(), " Finish ".into()), "rename recipe Fine"),
            (Edit::GiveRecipe(ids(&[3]), None), "take recipe of surface 3 away"),
            (Edit::GiveRecipe(ids(&[1, 3]), Some(recipe("Finish"))), "give 2 surfaces recipe Finish"),
            (Edit::Clean(ids(&[1204])), "move surface 1204 to clean"),
            (Edit::Split { surface: SurfaceId(1), angle_deg: 9.0, made: Vec::new() }, "split surface 1"),
            (Edit::Cut(Cut { of: SurfaceId(1), facets, piece: SurfaceId(2) }), "cut 1 200 facets off surface 1"),
            (Edit::Scan(Box::new(ScanEdit::Files(Vec::new(), Units::Mm))), "take the scan away"),
            (Edit::Scan(Box::new(ScanEdit::RemoveStep(1))), "remove cleaning step 2"),
            (Edit::Head(String::new()), "take the head away"),
            (Edit::Head("head.toml".into()), "change head"),
        ] {
            assert_eq!(UndoStep::Edited(edit).sentence(), name);
        }
        assert_eq!(UndoStep::Restored.sentence(), "restore unsaved changes");
    }
}
