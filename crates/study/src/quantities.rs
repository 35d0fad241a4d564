//! The quantities that [LTQPSO](forage#papers) fits over D, and the tables that it prints of them.

use super::{published::Regression, search::Start};

/// The four quantities that the paper fits, in the order of its tables.
pub(super) const QUANTITIES: [(&str, Quantity); 4] =
    [("N min", |d| d.n[0]), ("N max", |d| d.n[1]), ("M min", |d| d.m[0]), ("M max", |d| d.m[1])];

/// A number of what was found.
pub(super) type Quantity = fn(&Range) -> u64;

/// What the blocks of a D found: smallest and largest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Range {
    pub(super) d: u64,
    pub(super) n: [u64; 2],
    pub(super) m: [u64; 2],
}

/// A table of the paper.
pub(super) struct Case {
    pub(super) start: Start,
    pub(super) name: &'static str,
    pub(super) title: &'static str,
    pub(super) published: [Regression; 4],
}
