//! What the sample parts are.

use super::say;
use crate::sample::SamplePart;

/// What a sample part is and what it shows: a sentence with a full stop.
pub(crate) fn about_sample(part: SamplePart) -> String {
    match part {
        SamplePart::Workpiece => say!(sample_workpiece),
        SamplePart::WormGear => say!(sample_worm_gear),
        SamplePart::AcetabularCup => say!(sample_acetabular_cup),
        SamplePart::ConnectingRod => say!(sample_connecting_rod),
        SamplePart::FrontShaft => say!(sample_front_shaft),
        SamplePart::Camshaft => say!(sample_camshaft),
    }
}
