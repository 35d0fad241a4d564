//! The oracles: exact optima that every result is measured by.

mod discs;

pub use discs::shortest_among_discs;

/// The shortest way there is.
#[derive(Debug, Clone, PartialEq)]
pub struct Exact {
    /// Its length, in the scene's unit.
    pub length: f64,
    /// Its course; arcs as corners just outside their discs, so this line is collision-free and hardly longer.
    pub path: Vec<[f64; 2]>,
}
