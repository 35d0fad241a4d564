//! `a-star-drive`: a drive on ways of A*, replanned at each blockage; a baseline of [WOLF-ANT](crate#papers) §5.3.

use std::{sync::Arc, task::Poll};

use crate::{
    describe::{Case, Entry, Start},
    kernel::{Error, Started, State},
    message,
    params::{Choice, Fixed, Param},
};

use super::{
    a_star::AStar,
    ground::Ground,
    parameters::{DRIVE, EVENTS, FORMULA_APPROACH, FORMULA_TIME, ITERATIONS, KINDS, LAYERS_BARE, READINGS},
    planner,
    route::Route,
};

/// A search from scratch each time.
#[derive(Clone, State)]
struct Replanning {
    #[state(shared)]
    ground: Arc<Ground>,
    search: AStar,
    /// The path to begin with, where it is not searched.
    #[state(shared)]
    printed: Option<Vec<usize>>,
}

const PRINTED: Param<bool> = Param::choice(
    "path",
    "",
    "First path",
    &[Choice::new("search", "By A*", "The shortest one."), Choice::new("printed", "As printed", "published.path_cells of the scene.")],
    &[false, true],
    "Where the first path comes from.",
);

/// The printed path of a scene, from start to goal.
fn printed(ground: &Ground) -> Result<Vec<usize>, Error> {
    let cells = &ground.cells;
    let stored = ground.scene.header().published.as_ref().and_then(|published| published.get("path_cells")?.as_array());
    let way: Vec<usize> = stored.into_iter().flatten().map(|cell| cell.as_u64().unwrap_or(u64::MAX) as usize).collect();
    let leads =
        |two: &[usize]| two[0] < cells.len() && (0..8).any(|d| cells.moves(two[0]) >> d & 1 != 0 && cells.next(two[0], d) == two[1]);
    let ends = (way.first(), way.last()) == (Some(&ground.endpoints.start), Some(&ground.endpoints.goal));
    if ends && way.windows(2).all(leads) {
        return Ok(way);
    }
    let allowed = message!("drive-printed-path", "search: published.path_cells of the scene is no free path from start to goal");
    Err(Error::refused(PRINTED.name(), "printed", allowed))
}

impl Route for Replanning {
    fn evaluations(&self) -> u64 {
        self.search.expanded()
    }

    fn way(&mut self) -> Option<Vec<usize>> {
        if self.printed.is_some() {
            return self.printed.clone();
        }
        let nothing = vec![false; self.ground.cells.len()];
        self.search.way(&nothing, self.ground.endpoints.start, self.ground.endpoints.goal)
    }

    fn replan(&mut self, occupied: &[bool], from: usize) {
        self.search.begin(occupied, from, self.ground.endpoints.goal);
    }

    fn go_on(&mut self) -> Poll<Option<Vec<usize>>> {
        self.search.go_on()
    }

    fn is_long(&self) -> bool {
        self.ground.is_large()
    }

    fn copy(&self) -> Box<dyn Route> {
        Box::new(self.clone())
    }
}

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new("map", "A new way in time", "The robot foresees the disc and plans a new way to the goal.", "wolf-ant-20", &[]),
    Case::new(
        "printed",
        "The printed path, driven",
        "The path that [WOLF-ANT] prints: its length, turns and time are the printed ones.",
        "wolf-ant-20",
        &[
            ("path", Fixed::Text("printed")),
            ("robot", Fixed::Text("given")),
            ("robot_radius", Fixed::Number(0.0)),
            ("margin", Fixed::Number(0.0)),
        ],
    ),
    Case::new("patrol", "Guards on patrol", "Where a guard stands in a door the robot waits until the way is clear.", "patrol", &[]),
    Case::new("corridor", "A corridor with niches", "No way round: the robot backs into a niche and lets the disc pass.", "corridor", &[]),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "A* plans a path: length @planned@",
    "drive on at @speed@ cells a second, and look every @period@ s:",
    "  for each obstacle in sight: when will it be nearest if both go on, and how near?",
    "  too near within @look_ahead@ s:",
    "    search a new way round its predicted range from scratch, or wait",
    "  so far: new paths @replans@, waits @waits@",
    "after @time@ s: driven @length@, closest @smallest_distance@, collisions @collisions@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "a-star-drive",
    "A*, driving among moving obstacles",
    "Hart, Nilsson and Raphael 1968; [WOLF-ANT] §6",
    "The shortest way from cell to cell, then a drive in simulated time: where the robot foresees a collision it searches a new way round the obstacle’s predicted range from scratch, or waits.",
    start,
)
.family("dynamic")
.evaluating(crate::search::EVALUATION)
.kinds(KINDS)
.parameters(&[&[PRINTED.entry(), ITERATIONS.entry()], DRIVE])
.readings(READINGS)
.formulas(&[FORMULA_APPROACH, FORMULA_TIME])
.layers(LAYERS_BARE)
.events(EVENTS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

fn start(start: &Start) -> Result<Started, Error> {
    planner::start(start, |ground| {
        let printed = start.parameters[PRINTED].then(|| printed(ground)).transpose()?;
        Ok(Box::new(Replanning { search: AStar::new(&ground.cells), ground: Arc::clone(ground), printed }))
    })
}
