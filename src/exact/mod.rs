//! Exact algorithms for the optima that results are measured against.

mod cells;
mod cuboids;
mod discs;
mod distances;
mod grid;
mod tours;

pub use cells::{is_reachable, shortest_over_cells, shortest_way};
pub use cuboids::{AmongCuboids, MAX_EXACT_CUBOIDS, shortest_among_cuboids};
pub use discs::shortest_among_discs;
pub use distances::{Distances, LONGEST, MAX_MATRIX, Metric};
pub use grid::shortest_on_grid;
pub use tours::{MAX_EXACT_STOPS, shortest_tour};
