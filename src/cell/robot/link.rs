//! What the parts of an arm are called.

/// A link of the arm, from the base to the flange.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Link {
    /// Base to axis 2.
    Base,
    /// Around axis 2.
    Shoulder,
    /// Axis 2 to axis 3.
    UpperArm,
    /// Axis 3 to the wrist.
    Forearm,
    /// Wrist to flange.
    Wrist,
}

impl Link {
    /// The word in `report.json`.
    pub fn word(self) -> &'static str {
        match self {
            Link::Base => "base",
            Link::Shoulder => "shoulder",
            Link::UpperArm => "upper_arm",
            Link::Forearm => "forearm",
            Link::Wrist => "wrist",
        }
    }
}
