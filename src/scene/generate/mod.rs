//! Random scenes: each made by a generator with parameters and a seed, the same everywhere.
//!
//! Grids have a way from start to goal without cutting corners: `scatter` blocks a share of the cells, `rooms` begins with
//! all blocked and opens some, `calls` puts stops on them, and `moving` adds moving obstacles. `points` are stops in the plane, `discs` obstacles there,
//! and `function` is a test function with its minimum somewhere else.

mod calls;
mod discs;
mod function;
mod moving;
mod plot;
mod points;
mod rooms;
mod scatter;
#[cfg(test)]
mod tests;

use std::{fmt::Write, sync::Arc};

use crate::{
    kernel::{
        Error, SceneBody,
        rng::{self, Stream},
    },
    params::{Overrides, Parameters},
};

use super::{GridScene, Header, Scene};

use moving::MOVING;

use plot::{CELL, COLUMNS, Draw, Plot, ROWS, STOPS};

pub use calls::with_stops;
pub use plot::Generator;

/// All generators of grids, in the order in which they are offered; nothing else lists them.
pub const GENERATORS: &[Generator] = &[scatter::RANDOM, scatter::RUBBLE, rooms::ROOMS, rooms::MAZE];

/// All generators of other scenes.
pub const OTHERS: &[Generator] = &[points::STOPS, discs::DISCS, function::SHIFTED];

/// The generator of this name.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn find(name: &str) -> Result<&'static Generator, Error> {
    let all = || GENERATORS.iter().chain(OTHERS);
    all().find(|g| g.name == name).ok_or_else(|| Error::unknown("generator", name, all().map(|g| g.name)))
}

/// Makes a scene: the same for the same parameters and seed. Its `source` is the command that makes it again.
///
/// ```
/// use forage::{Overrides, Value, scene::{GridScene, generate::generate}};
///
/// let scene = generate("maze", &Overrides::from_iter([("columns", Value::from(21.0))]), 7)?;
/// assert_eq!(scene.get::<GridScene>()?.columns, 21);
/// # Ok::<(), forage::Error>(())
/// ```
///
/// # Errors
/// [`Error::Unknown`] for a name that means nothing, [`Error::Refused`] for a value that is not allowed.
pub fn generate(name: &str, given: &Overrides, seed: u64) -> Result<Scene, Error> {
    let generator = find(name)?;
    let settings = Parameters::new(generator.parameters, generator.kind(), given)?;
    let mut stream = Stream::new(rng::check_seed(seed)?, 0);
    let mut note = None;
    let (body, size, title) = match generator.draw {
        Draw::Grid(draw) => {
            let grid = grid(draw, &settings, &mut stream, seed, &mut note);
            let (columns, rows) = (grid.columns, grid.rows());
            (Arc::new(grid) as Arc<dyn SceneBody>, format!("{columns}x{rows}"), format!("{columns} × {rows}"))
        }
        Draw::Other(_, draw) => {
            let made = draw(&settings, &mut stream);
            note = made.note;
            (made.body, made.size.clone(), made.size)
        }
    };
    let mut source = format!("forage generate {name}");
    // Where nothing moves, the command is the one that it was before anything did.
    let moves = matches!(generator.draw, Draw::Other(..)) || settings[MOVING] > 0;
    for (name, value) in settings.all().iter().filter(|(name, _)| moves || !name.starts_with(MOVING.name())) {
        // Writing to a string cannot fail.
        let _ = write!(source, " --set {name}={value}");
    }
    let _ = write!(source, " --seed {seed}");
    let header = Header {
        name: format!("{name}-{size}-{seed}"),
        title: format!("{}, {title}, seed {seed}", generator.title),
        note,
        source: Some(source),
        units: None,
        exact: None,
        published: None,
    };
    Scene::new(header, body, generator.draw.kind().optimum)
}

fn grid(
    draw: fn(&Parameters, &mut Plot, &mut Stream),
    settings: &Parameters,
    stream: &mut Stream,
    seed: u64,
    note: &mut Option<String>,
) -> GridScene {
    let [columns, rows, stops, moving] = [settings[COLUMNS], settings[ROWS], settings[STOPS], settings[MOVING]].map(|count| count as usize);
    let count = columns * rows;
    let mut plot = Plot { columns, rows, blocked: vec![false; count], kept: vec![false; count], ends: [0, count - 1], note: None };
    draw(settings, &mut plot, stream);
    let cell = settings[CELL];
    let [start, goal] = plot.ends.map(|end| Some([end % columns, end / columns].map(|i| (i as f64 + 0.5) * cell)));
    let mut grid = GridScene { start, goal, ..GridScene::new(cell, columns, plot.blocked) };
    let mut notes: Vec<_> = plot.note.into_iter().collect();
    // Both from streams of their own: the grid is the same with them and without.
    if stops > 0 {
        let there = calls::place(&mut grid, stops, &mut Stream::new(seed, 1));
        if there < stops {
            notes.push(format!("There are {there} stops, not {stops}: there is room for no more."));
        }
    }
    if moving > 0 {
        let there = moving::place(&mut grid, settings, &mut Stream::new(seed, 2));
        if there < moving {
            notes.push(format!("There are {there} moving obstacles, not {moving}: there is no room for more clear of the start."));
        }
    }
    *note = Some(notes.join(" ")).filter(|text| !text.is_empty());
    grid
}
