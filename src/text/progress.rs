//! What long work is doing.

use super::{Sentence, say};
use crate::progress::Activity;

impl Sentence for Activity {
    fn sentence(&self) -> String {
        match self {
            Activity::Reading => say!(activity_reading),
            Activity::ReadingScan => say!(activity_reading_scan),
            Activity::CleaningScan => say!(activity_cleaning_scan),
            Activity::LayingScan => say!(activity_laying_scan),
            Activity::ComparingScan => say!(activity_comparing_scan),
            Activity::CuttingPatches => say!(activity_cutting_patches),
            Activity::ReadingImages => say!(activity_reading_images),
            Activity::MaskingImage => say!(activity_masking_image),
            Activity::MeasuringBead => say!(activity_measuring_bead),
            Activity::CuttingAreas => say!(activity_cutting_areas),
            Activity::ComparingStrategies => say!(activity_comparing_strategies),
            Activity::BuildingPart => say!(activity_building_part),
            Activity::CuttingSurfaces => say!(activity_cutting_surfaces),
            Activity::NamingShapes => say!(activity_naming_shapes),
            Activity::LayingLines => say!(activity_laying_lines),
            Activity::Planning => say!(activity_planning),
            Activity::ChoosingSpins => say!(activity_choosing_spins),
            Activity::ConnectingMoves => say!(activity_connecting_moves),
            Activity::WorkingOutMotion => say!(activity_working_out_motion),
            Activity::MeasuringClearances => say!(activity_measuring_clearances),
            Activity::Exporting => say!(activity_exporting),
            Activity::Packing => say!(activity_packing),
            Activity::WritingProgram => say!(activity_writing_program),
            Activity::WritingFiles => say!(activity_writing_files),
            Activity::SummingDose => say!(activity_summing_dose),
            Activity::LookingForSuggestions => say!(activity_looking_for_help),
            Activity::TryingSpeeds => say!(activity_trying_speeds),
            Activity::TryingChanges => say!(activity_trying_changes),
            Activity::LookingForSetup => say!(activity_looking_for_setup),
            Activity::TryingSetups => say!(activity_trying_setups),
            Activity::ImprovingSetup => say!(activity_improving_setup),
            Activity::TryingSmallChanges => say!(activity_trying_small_changes),
            Activity::PlanningSamples => say!(activity_planning_samples),
        }
    }
}
