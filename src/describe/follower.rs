//! What is known of who follows a path.

use serde::Serialize;

use crate::params::Parameter;

use super::Formula;

/// What there is to know about following a path: how a robot drives along it, or an arm moves.
#[derive(Debug, Clone, Copy)]
pub struct Follower {
    /// Where it comes from.
    pub source: &'static str,
    /// A sentence or two.
    pub summary: &'static str,
    /// What can be set.
    pub parameters: &'static [&'static [Parameter]],
    /// The numbers of a row.
    pub columns: &'static [Column],
    /// The equations it carries out.
    pub formulas: &'static [Formula],
}

/// A number that is recorded for each moment of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Column {
    /// An identifier.
    pub name: &'static str,
    /// A few words.
    pub title: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// `s`, `m`, `rad/s`, …; empty for a bare number. `m` stands for the scene's unit.
    pub unit: &'static str,
}
