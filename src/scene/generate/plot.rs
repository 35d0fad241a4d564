//! A grid in the making, and the parameters that generators of grids share.

use crate::{
    params::Param,
    scene::{MAX_GRID_STOPS, MAX_SIDE},
};

pub(super) const COLUMNS: Param<u64> =
    Param::integer("columns", "", "Columns", [1, MAX_SIDE as u64, 40], "Cells a row.").slider(5.0, 200.0, true);

pub(super) const ROWS: Param<u64> = Param::integer("rows", "", "Rows", [1, MAX_SIDE as u64, 30], "Rows of cells.").slider(5.0, 200.0, true);

pub(super) const CELL: Param<f64> =
    Param::number("cell", "", "Cell", [0.001, 100.0, 1.0], "The side of a cell, in the scene’s unit.").slider(0.1, 10.0, true);

pub(super) const STOPS: Param<u64> = Param::integer(
    "stops",
    "",
    "Stops",
    [0, MAX_GRID_STOPS as u64, 0],
    "How many cells a tour must call at, besides start and goal: free ones that the start is connected with.",
)
.slider(0.0, 50.0, false);

/// A grid in the making.
pub(super) struct Plot {
    pub(super) columns: usize,
    pub(super) rows: usize,
    pub(super) blocked: Vec<bool>,
    /// Cells that must stay free.
    pub(super) kept: Vec<bool>,
    pub(super) ends: [usize; 2],
    pub(super) note: Option<String>,
}
