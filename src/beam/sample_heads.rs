//! Heads to begin with: examples of three kinds, to be measured anew.

use super::HeadPart;
use super::head::Head;

/// A head to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SampleHead {
    /// A slim optic with a straight barrel.
    FixedOptic,
    /// A scan head with mirrors and a wide lens.
    ScanHead,
    /// A head with a powder nozzle.
    CladdingNozzle,
}

impl SampleHead {
    /// All of them.
    pub const ALL: [SampleHead; 3] = [SampleHead::FixedOptic, SampleHead::ScanHead, SampleHead::CladdingNozzle];

    /// The text of its file.
    fn text(self) -> &'static str {
        match self {
            SampleHead::FixedOptic => include_str!("../../assets/heads/fixed_optic.toml"),
            SampleHead::ScanHead => include_str!("../../assets/heads/scan_head.toml"),
            SampleHead::CladdingNozzle => include_str!("../../assets/heads/cladding_nozzle.toml"),
        }
    }

    /// Its cylinders and cones, from the focus on.
    pub fn parts(self) -> Vec<HeadPart> {
        // Shipped files are whole, which a test sees to.
        Head::from_toml(self.text()).map(|head| head.stack().to_vec()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shipped_heads_are_whole_and_clear_of_the_cone() {
        let optics = crate::beam::Optics::default();
        for sample in SampleHead::ALL {
            let parts = sample.parts();
            assert!(parts.len() >= 3, "{sample:?}");
            assert!(parts.windows(2).all(|w| w[0].to_mm == w[1].from_mm), "{sample:?}: one piece on another");
            // The light has room within every piece below the lens.
            let half_mm = |from_focus: f64| 0.5 * optics.aperture_mm * from_focus / optics.lens_to_focus_mm;
            let wide = |p: &HeadPart| p.r0_mm > half_mm(p.from_mm) && p.r1_mm > half_mm(p.to_mm.min(200.0));
            assert!(parts.iter().all(wide), "{sample:?}");
        }
    }
}
