//! What a registration is asked for.

use crate::fit::PlacedPair;
use nalgebra::Isometry3;

/// From where a scan is laid on the model.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Start {
    /// From any pose; others that fit as well are told.
    #[default]
    Anywhere,
    /// From a `model_from_scan` that is near: off by no more than a twentieth of the model's diagonal.
    From(Isometry3<f64>),
    /// From pairs: places of the scan (`from`) and where they are on the model (`onto`).
    Pairs(Vec<PlacedPair>),
}

/// What does not take part. Lists that are too short leave nothing else out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeftOut {
    /// For each point of the cloud whether it is left out.
    pub points: Vec<bool>,
    /// For each facet of the model whether points that are nearest to it are left out of the fine fit.
    pub facets: Vec<bool>,
}

/// What a registration is asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RegistrationOptions {
    /// From where.
    pub start: Start,
    /// Without what.
    pub left_out: LeftOut,
}
