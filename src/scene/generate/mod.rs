//! Random grids: each made by a generator with parameters and a seed, the same everywhere, and with a way from start to
//! goal without cutting corners. `scatter` blocks a share of the cells, `rooms` begins with all blocked and opens some.

mod rooms;
mod scatter;
#[cfg(test)]
mod tests;

use std::fmt::Write;

use crate::{
    error::Error,
    params::{Given, Parameter, Settings},
    rng::{self, Stream},
};

use super::{Body, GridScene, Header, Kind, MAX_SIDE, Scene};

/// All generators, in the order in which they are offered; nothing else lists them.
pub const GENERATORS: &[Generator] = &[scatter::RANDOM, scatter::RUBBLE, rooms::ROOMS, rooms::MAZE];

/// What a random grid is made of.
#[derive(Debug, Clone, Copy)]
pub struct Generator {
    /// The name in commands.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// A sentence or two.
    pub help: &'static str,
    /// Its parameters; every generator has `columns`, `rows` and `cell`.
    pub parameters: &'static [Parameter],
    /// Blocks cells, and sees to it that there is a way.
    draw: fn(&Settings, &mut Plot, &mut Stream),
}

const COLUMNS: Parameter = columns(40);
const ROWS: Parameter = rows(30);
const CELL: Parameter =
    Parameter::number("cell", "", "Cell", [0.001, 100.0, 1.0], "The side of a cell, in the scene’s unit.").slider(0.1, 10.0, true);

const fn columns(default: u64) -> Parameter {
    Parameter::integer("columns", "", "Columns", [1, MAX_SIDE as u64, default], "Cells a row.").slider(5.0, 200.0, true)
}

const fn rows(default: u64) -> Parameter {
    Parameter::integer("rows", "", "Rows", [1, MAX_SIDE as u64, default], "Rows of cells.").slider(5.0, 200.0, true)
}

/// A grid in the making.
struct Plot {
    columns: usize,
    rows: usize,
    blocked: Vec<bool>,
    /// Cells that must stay free.
    kept: Vec<bool>,
    ends: [usize; 2],
    note: Option<String>,
}

/// The generator of this name.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn find(name: &str) -> Result<&'static Generator, Error> {
    GENERATORS.iter().find(|g| g.name == name).ok_or_else(|| Error::unknown("generator", name, GENERATORS.iter().map(|g| g.name)))
}

/// Makes a grid: the same for the same parameters and seed. Its `source` is the command that makes it again.
///
/// ```
/// use forage::{Given, Value, scene::generate::generate};
///
/// let scene = generate("maze", &Given::from_iter([("columns", Value::from(21.0))]), 7)?;
/// assert_eq!(scene.grid()?.columns, 21);
/// # Ok::<(), forage::Error>(())
/// ```
///
/// # Errors
/// [`Error::Unknown`] for a name that means nothing, [`Error::Refused`] for a value that is not allowed.
pub fn generate(name: &str, given: &Given, seed: u64) -> Result<Scene, Error> {
    let generator = find(name)?;
    let settings = Settings::new(generator.parameters, Kind::Grid, given)?;
    let mut stream = Stream::new(rng::check_seed(seed)?, 0);
    let (columns, rows) = (settings.integer("columns") as usize, settings.integer("rows") as usize);
    let count = columns * rows;
    let mut plot = Plot { columns, rows, blocked: vec![false; count], kept: vec![false; count], ends: [0, count - 1], note: None };
    (generator.draw)(&settings, &mut plot, &mut stream);
    let mut source = format!("forage generate {name}");
    for (name, value) in settings.all() {
        // Writing to a string cannot fail.
        let _ = write!(source, " --set {name}={value}");
    }
    let _ = write!(source, " --seed {seed}");
    let header = Header {
        name: format!("{name}-{columns}x{rows}-{seed}"),
        title: format!("{}, {columns} × {rows}, seed {seed}", generator.title),
        note: plot.note,
        source: Some(source),
        units: None,
        exact: None,
        published: None,
    };
    let cell = settings.number("cell");
    let [start, goal] = plot.ends.map(|end| Some([end % columns, end / columns].map(|i| (i as f64 + 0.5) * cell)));
    Scene::new(header, Body::Grid(GridScene { start, goal, ..GridScene::new(cell, columns, plot.blocked) }))
}
