//! The stepped contract: what a planner's author writes.
//!
//! One step is one drawable iteration. A planner owns its random stream and shares its scene by `Arc`; a clone of it is
//! a keyframe. The caller owns the loop.

use serde::{Deserialize, Serialize};

use crate::{
    arm::Posture,
    digest::Digest,
    frame::{Frame, Role, Shape},
    params::Given,
};

/// Whether there is more to do, or why not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// There is more to do.
    Running,
    /// The goal is reached and nothing better can be found.
    Solved,
    /// The iteration limit is reached.
    Exhausted,
    /// There is no solution, or no way to one was found.
    Infeasible,
}

/// What planners find.
#[derive(Debug, Clone, PartialEq)]
pub enum Solution {
    /// Corners of a path, in the scene's unit.
    Path(Vec<[f64; 2]>),
    /// A point in a function's box.
    Position(Vec<f64>),
    /// A tour that calls at every stop.
    Tour {
        /// The stops' numbers in the order in which it calls at them, each once.
        order: Vec<usize>,
        /// What its ends are.
        round: Round,
        /// The way through them, back to the first if it is closed, in the scene's unit.
        path: Vec<[f64; 2]>,
    },
    /// A drive among moving obstacles, from start to goal in simulated time.
    Drive(Track),
    /// A way for the tip of an arm.
    Reach {
        /// The corners of the tip's path, in metres.
        path: Vec<[f64; 3]>,
        /// The arm's postures, if they were planned and not only where its tip is: it goes from one to the next with all
        /// joints evenly, and the path is where that takes the tip.
        postures: Vec<Posture>,
    },
}

/// Where a robot was, and when.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Track {
    /// The corners of its way, in the scene's unit; where it stood there is one.
    pub path: Vec<[f64; 2]>,
    /// [t, x, y] wherever its motion changed, by growing time; between them it went straight at an even speed, or stood.
    pub moments: Vec<[f64; 3]>,
    /// The radius of the robot as moving obstacles meet it.
    pub radius: f64,
    /// What the moving obstacles do at the border.
    pub border: Border,
}

/// What a moving obstacle does when it comes to the border of its scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Border {
    /// It goes on and is gone.
    #[default]
    Leave,
    /// It bounces off as soon as it touches.
    Bounce,
}

impl Solution {
    /// How many corners its path has.
    pub fn corners(&self) -> usize {
        match self {
            Self::Reach { path, .. } => path.len(),
            _ => self.path().map_or(0, <[_]>::len),
        }
    }

    /// The corners of a path in the plane or of a tour's way.
    pub fn path(&self) -> Option<&[[f64; 2]]> {
        match self {
            Self::Path(path) | Self::Tour { path, .. } | Self::Drive(Track { path, .. }) => Some(path),
            Self::Position(_) | Self::Reach { .. } => None,
        }
    }
}

/// What the ends of a tour are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Round {
    /// It goes back to where it began.
    #[default]
    Closed,
    /// It begins at any stop and ends at any other.
    Open,
    /// It begins at the first stop and ends at any other.
    FromFirst,
    /// It begins at the first stop and ends at the last.
    FirstToLast,
}

impl Round {
    /// Every one.
    pub const ALL: [Self; 4] = [Self::Closed, Self::Open, Self::FromFirst, Self::FirstToLast];

    /// Whether it goes back to where it began.
    pub fn closes(self) -> bool {
        self == Self::Closed
    }

    /// Whether an order calls at each of `n` stops once and has such ends.
    pub fn allows(self, order: &[usize], n: usize) -> bool {
        let mut called = vec![false; n];
        let once = |&stop: &usize| called.get_mut(stop).is_some_and(|called| !std::mem::replace(called, true));
        let ends = match self {
            Self::Closed | Self::Open => true,
            Self::FromFirst => order.first() == Some(&0),
            Self::FirstToLast => order.first() == Some(&0) && order.last() == Some(&(n - 1)),
        };
        order.len() == n && order.iter().all(once) && ends
    }
}

/// Which optimum a result is measured by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Yardstick {
    /// The shortest way there is, at any angle.
    #[default]
    AnyAngle,
    /// The shortest way from cell to neighbouring cell of a grid.
    Cells,
    /// The shortest tour by the distances that the scene gives.
    Matrix,
    /// The optimum that the scene's file gives: none could be computed.
    Stored,
    /// None: the scene's file gives an optimum, and this result is better.
    Refuted,
}

/// A run of another planner on the same scene that the next step needs. Whoever steps may carry them out side by side
/// and hand over what they found; a step that was handed nothing carries them out itself. The result is the same.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Job {
    /// The planner's name.
    pub planner: &'static str,
    /// Parameters that differ from its defaults.
    pub params: Given,
    /// The seed.
    pub seed: u64,
    /// Where it starts and where it leads, if not where the scene says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<[[f64; 2]; 2]>,
}

/// What a [`Job`] found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// The best cost; `None` if nothing feasible was found.
    pub cost: Option<f64>,
    /// The iteration in which the best was found.
    pub converged: f64,
    /// The best path; empty if nothing feasible was found.
    pub path: Vec<[f64; 2]>,
}

/// Parameters that a planner of planners recommends.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Tuned {
    /// For this planner.
    pub planner: &'static str,
    /// Those that were searched and those that were given.
    pub params: Given,
}

/// A part of a run that has its own kind of step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Stage {
    /// An identifier.
    pub name: &'static str,
    /// A few words.
    pub title: &'static str,
    /// Its last iteration; the next stage's first step follows.
    pub end: u64,
}

/// Something that happened in a run in simulated time, or that was decided, and why.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Event {
    /// The iteration after which it is known.
    pub iteration: u64,
    /// When, in seconds of simulated time.
    pub time: f64,
    /// Where the robot was, in the scene's unit.
    pub place: [f64; 2],
    /// What: one of the entry's `events`.
    pub kind: &'static str,
    /// The number of the moving obstacle that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub obstacle: Option<usize>,
    /// Why, in a sentence.
    pub reason: String,
}

/// The best solution so far and what it costs the planner. Whether it is any good, [`crate::Scene::judge`] says.
#[derive(Debug, Clone, PartialEq)]
pub struct Best {
    /// What the planner minimises.
    pub cost: f64,
    /// What it found.
    pub solution: Solution,
}

/// Named numbers of an iteration. Re-used from call to call.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Readings(Vec<(&'static str, f64)>);

impl Readings {
    /// Empties it.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Adds a number under a name that the planner's entry lists.
    pub fn push(&mut self, name: &'static str, value: f64) {
        self.0.push((name, value));
    }

    /// The names and numbers, always in the same order for the same run.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&'static str, f64)> + '_ {
        self.0.iter().copied()
    }

    /// The number of this name.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| *n == name).map(|(_, value)| *value)
    }
}

/// Something in a frame that can be asked about: the `index`-th piece of a role's layers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Item {
    /// What it is.
    pub role: Role,
    /// Which one, counted over all pieces, drawn or not.
    pub index: usize,
}

/// A number in an inspection.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantity {
    /// The name that formulas use for it.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
    /// The number.
    pub value: f64,
}

/// A column of an inspection's table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Column {
    /// An identifier.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
}

/// A mark to draw over the picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mark {
    /// What it shows.
    pub role: Role,
    /// How its vertices belong together.
    pub shape: Shape,
    /// In the scene's unit; in the plane z is 0.
    pub vertices: Vec<[f64; 3]>,
}

impl Mark {
    /// A mark in the plane.
    pub fn plane(role: Role, shape: Shape, vertices: Vec<[f64; 2]>) -> Self {
        Self { role, shape, vertices: vertices.into_iter().map(|[x, y]| [x, y, 0.0]).collect() }
    }
}

/// Why something did what it did in the step that led to this iteration.
#[derive(Debug, Clone, PartialEq)]
pub struct Inspection {
    /// What was asked about.
    pub item: Item,
    /// Its name for people.
    pub title: String,
    /// What happened, in a word.
    pub event: &'static str,
    /// The same in a sentence.
    pub summary: String,
    /// The numbers behind it.
    pub values: Vec<Quantity>,
    /// Names of the entry's formulas that say it.
    pub formulas: Vec<&'static str>,
    /// The table's columns.
    pub columns: Vec<Column>,
    /// A label for each row.
    pub labels: Vec<String>,
    /// The table.
    pub rows: Vec<Vec<f64>>,
    /// Arrows and marks.
    pub marks: Vec<Mark>,
}

/// A planner that can be stepped, drawn, read, explained, rewound and judged.
///
/// It is deterministic, never panics, and allocates in `step` only when something really grows.
pub trait Planner: Clone {
    /// Takes one step; does nothing once finished.
    fn step(&mut self) -> Status;
    /// Whether there is more to do.
    fn status(&self) -> Status;
    /// How many steps were taken.
    fn iteration(&self) -> u64;
    /// After how many steps it stops at the latest.
    fn limit(&self) -> u64;
    /// How many candidate solutions were evaluated.
    fn evaluations(&self) -> u64;
    /// The best solution so far.
    fn best(&self) -> Option<Best>;
    /// The numbers of this iteration.
    fn read(&self, out: &mut Readings);
    /// Draws itself into a cleared frame.
    fn draw(&self, frame: &mut Frame);
    /// What can be said of an item from the present state alone.
    fn inspect(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// What the next step does to an item and why; takes that step on a copy. The session asks the state before.
    /// So nothing has to be recorded in the inner loop for the one particle that somebody may click.
    fn explain(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// The iteration whose step is to be explained for an item that came about then; `None`: the last one.
    fn made(&self, _item: Item) -> Option<u64> {
        None
    }
    /// Which optimum its results are measured by.
    fn yardstick(&self) -> Yardstick {
        Yardstick::default()
    }
    /// The runs of other planners that the next step needs; none, for most.
    fn jobs(&self) -> Vec<Job> {
        Vec::new()
    }
    /// Takes what the runs of [`Planner::jobs`] found, in their order; the next step uses it.
    fn supply(&mut self, _found: Vec<Finding>) {}
    /// The parts of a run, in their order; none, for most: all steps are of one kind.
    fn stages(&self) -> Vec<Stage> {
        Vec::new()
    }
    /// What happened so far, in the order of time; nothing, for most.
    fn events(&self) -> &[Event] {
        &[]
    }
    /// What the ends of its tours are, if it finds tours.
    fn round(&self) -> Option<Round> {
        None
    }
    /// The numbers of those that search side by side: for each of them, in the order of the layer that can be inspected,
    /// one for each of the entry's `members`.
    fn members(&self, _out: &mut Vec<f64>) {}
    /// What keeps it from a result, if something does, in a sentence without a full stop.
    fn trouble(&self) -> Option<String> {
        None
    }
    /// The parameters that it recommends for another planner.
    fn tuned(&self) -> Option<Tuned> {
        None
    }
    /// Adds the whole state to a hash.
    fn digest(&self, out: &mut Digest);
    /// About how much memory a clone takes, in bytes.
    fn bytes(&self) -> usize;
}
