//! The oracles: exact optima that every result is measured by.

mod cells;
mod cuboids;
mod discs;
mod distances;
mod grid;
mod tours;

pub use cells::{is_reachable, shortest_over_cells, shortest_way};
pub use cuboids::{AmongCuboids, MAX_EXACT_CUBOIDS, shortest_among_cuboids};
pub use discs::shortest_among_discs;
pub use distances::{Distances, LONGEST, Metric};
pub use grid::shortest_on_grid;
pub use tours::{MAX_EXACT_STOPS, shortest_tour};

/// The shortest way there is.
#[derive(Debug, Clone, PartialEq)]
pub struct Exact {
    /// Its length, in the scene's unit.
    pub length: f64,
    /// Its course; arcs as corners just outside their discs, so this line is collision-free and hardly longer.
    pub path: Vec<[f64; 2]>,
    /// Of an arm's tip: its course in space; `path` is empty then. Otherwise empty.
    pub tip_path: Vec<[f64; 3]>,
    /// Of a tour: the order of its stops. Otherwise empty.
    pub order: Vec<usize>,
    /// The scene's file says so; it was not computed.
    pub stored: bool,
}

impl Exact {
    /// A way of this length.
    pub fn way(length: f64, path: Vec<[f64; 2]>) -> Self {
        Self { length, path, tip_path: Vec::new(), order: Vec::new(), stored: false }
    }
}
