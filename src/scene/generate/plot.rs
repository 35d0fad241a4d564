//! What a generator is, and the parameters that those of grids share.

use std::sync::Arc;

use crate::{
    describe::SceneKind,
    kernel::{SceneBody, SceneKindId, rng::Stream},
    params::{Param, Parameter, Parameters},
    scene::{MAX_GRID_STOPS, MAX_SIDE, grid},
};

/// What a random scene is made of.
#[derive(Debug, Clone, Copy)]
pub struct Generator {
    /// The name in commands.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// A sentence or two.
    pub help: &'static str,
    /// Its parameters; every generator of grids has `columns`, `rows`, `cell` and, last, `stops` and those of moving obstacles.
    pub parameters: &'static [&'static [Parameter]],
    pub(super) draw: Draw,
}

impl Generator {
    /// The kind of its scenes.
    pub const fn kind(&self) -> SceneKindId {
        self.draw.kind().id
    }
}

/// How a generator draws.
#[derive(Debug, Clone, Copy)]
pub(super) enum Draw {
    /// Blocks cells, and sees to it that there is a way.
    Grid(fn(&Parameters, &mut Plot, &mut Stream)),
    /// Makes a scene of this kind.
    Other(&'static SceneKind, fn(&Parameters, &mut Stream) -> Made),
}

impl Draw {
    pub(super) const fn kind(&self) -> &'static SceneKind {
        match self {
            Self::Grid(_) => &grid::KIND,
            Self::Other(kind, _) => kind,
        }
    }
}

/// A scene without a name.
pub(super) struct Made {
    pub(super) body: Arc<dyn SceneBody>,
    /// What the name says of it, between the generator's name and the seed.
    pub(super) size: String,
    pub(super) note: Option<String>,
}

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
