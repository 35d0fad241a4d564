//! `wolf-ant-drive`: ants plan, the robot drives, and pheromone leads it round moving obstacles, [WOLF-ANT](crate#papers) §5.3.

use std::{any::Any, sync::Arc, task::Poll};

use crate::{
    ants::{COLONIES, Colony, Scouts, aco_wolf},
    describe::{Case, Entry, PAPER, Start, layers},
    kernel::{Error, Explain, Frame, Inspection, Item, Planner, Progress, Started, State, rng::Stream},
    message,
    params::{Overrides, Param, Value},
};

use super::{
    a_star::AStar,
    ground::Ground,
    parameters::{DRIVE, EVENTS, FORMULA_APPROACH, FORMULA_TIME, KINDS, LAYERS, READINGS},
    planner,
    route::Route,
};

const COLONY: Param<&str> = Param::name_of(
    "colony",
    "",
    "Colony",
    COLONIES,
    "The colony that plans the path and lays the pheromone that leads around obstacles. It has its paper’s parameters, except for the number of ants and iterations.",
);
const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "t_{\\max}",
    "Iterations",
    [1, 1_000_000, 100],
    "How many iterations the colony plans before the robot sets out. Published: 100.",
)
.slider(10.0, 1000.0, true);
const ANTS: Param<u64> =
    Param::integer("ants", "m", "Ants", [1, 10_000, 30], "How many ants set out in an iteration. Published: 30.").slider(1.0, 500.0, true);

/// A colony that plans, and whose pheromone is followed.
#[derive(Clone, State)]
struct Ants {
    #[state(shared)]
    ground: Arc<Ground>,
    /// It does not change any more once the robot drives: copies share it.
    colony: Arc<Colony>,
    #[state(shared)]
    steps: u64,
    /// For ants that are sent round obstacles.
    rng: Stream,
    /// How many of those have set out.
    scouts: u64,
    /// Those that are under way.
    #[state(skip)]
    under_way: Option<Scouts>,
    /// For a new way where the pheromone gives none.
    search: AStar,
}

impl Ants {
    /// Without the formulas of other colonies, which are not among this planner's.
    fn of_this_entry(&self, mut inspection: Inspection) -> Inspection {
        inspection.formulas.retain(|name| ENTRY.formulas.iter().any(|formula| formula.name == *name) && self.colony.is_wolf());
        inspection
    }
}

impl Route for Ants {
    fn steps(&self) -> u64 {
        self.steps
    }

    fn step(&mut self) -> Progress {
        Arc::make_mut(&mut self.colony).advance()
    }

    fn evaluations(&self) -> u64 {
        Planner::evaluations(&*self.colony) + self.scouts + self.search.expanded()
    }

    fn way(&mut self) -> Option<Vec<usize>> {
        self.colony.path()
    }

    fn shortest(&self) -> Option<f64> {
        self.colony.length()
    }

    fn detour(&mut self, occupied: &[bool], from: usize, to: usize) -> bool {
        self.under_way = self.colony.scouts(occupied, from, to, &self.rng);
        self.under_way.is_some()
    }

    fn replan(&mut self, occupied: &[bool], from: usize) {
        self.search.begin(occupied, from, self.ground.endpoints.goal);
    }

    fn go_on(&mut self) -> Poll<Option<Vec<usize>>> {
        let Some(scouts) = &mut self.under_way else {
            return self.search.go_on();
        };
        let found = scouts.go_on();
        if found.is_ready() {
            (self.rng, self.scouts) = (scouts.rng(), self.scouts + scouts.sent());
            self.under_way = None;
        }
        found
    }

    fn is_long(&self) -> bool {
        self.ground.is_large() || self.colony.sends_many()
    }

    fn draw(&self, driving: bool, frame: &mut Frame) {
        if driving {
            self.colony.draw_pheromone(frame);
        } else {
            self.colony.draw(frame);
        }
    }

    fn inspect(&self, item: Item) -> Option<Inspection> {
        if ![layers::PHEROMONE.key, layers::ANTS.key].contains(&item.layer) {
            return None;
        }
        let mut inspection = self.colony.inspect(item)?;
        if item.layer == layers::ANTS.key {
            // A step of the drive is none of the colony.
            inspection.suppositions.clear();
        }
        Some(self.of_this_entry(inspection))
    }

    fn suppose(&self, item: Item, supposition: &str) -> Option<Inspection> {
        Some(self.of_this_entry(self.colony.suppose_now(item, supposition)?))
    }

    fn copy(&self) -> Box<dyn Route> {
        Box::new(self.clone())
    }
}

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "map",
        "Round a moving obstacle",
        "The robot foresees that the disc comes too near, and goes round it along the pheromone.",
        "wolf-ant-20",
        &[],
    )
    .seed(23),
    Case::new(
        "crossing",
        "Cross traffic",
        "Discs cross a hall from both sides: each detour has a time, a place and a reason.",
        "crossing",
        &[],
    ),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "ants plan a path: length @planned@",
    "drive on at @speed@ cells a second, and look every @period@ s:",
    "  for each obstacle in sight: when will it be nearest if both go on, and how near?",
    "  too near within @look_ahead@ s:",
    "    follow the pheromone round its predicted range, or replan, or wait",
    "  so far: detours @detours@, new paths @replans@, waits @waits@",
    "after @time@ s: driven @length@, closest @smallest_distance@, collisions @collisions@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "wolf-ant-drive",
    "Ant colony, driving among moving obstacles",
    "[WOLF-ANT] §5.3",
    "A colony plans, then a robot drives in simulated time: where it foresees a collision it follows the pheromone round the obstacle’s predicted range to a local goal, replans, or waits.",
    start,
)
.family("dynamic")
.evaluating("an ant’s path, or a cell that is closed")
.kinds(KINDS)
.parameters(&[&[COLONY.entry(), ITERATIONS.entry(), ANTS.entry()], DRIVE])
.readings(READINGS)
.formulas(&[FORMULA_APPROACH, FORMULA_TIME, aco_wolf::CHOICE, aco_wolf::RANKED, aco_wolf::LAID])
.layers(LAYERS)
.events(EVENTS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

fn start(start: &Start) -> Result<Started, Error> {
    let colony = colony(start)?;
    planner::start(start, |ground| {
        Ok(Box::new(Ants {
            // Where no way leads the colony has nothing to plan.
            steps: if colony.is_reachable() { start.parameters[ITERATIONS] } else { 0 },
            rng: Stream::new(start.seed, 1),
            scouts: 0,
            under_way: None,
            search: AStar::new(&ground.cells),
            ground: Arc::clone(ground),
            colony: Arc::new(colony),
        }))
    })
}

/// The colony that plans: with its paper's parameters, but for those that are given.
fn colony(start: &Start) -> Result<Colony, Error> {
    let (entry, kind) = (start.planner(COLONY)?, start.scene.kind());
    let other = || {
        let known = COLONIES.iter().map(|option| option.value).collect::<Vec<_>>().join(", ");
        Error::refused(COLONY.name(), entry.name, message!("drive-colony", "an ant colony, e.g. {known}", known))
    };
    if [ITERATIONS, ANTS].iter().any(|size| entry.parameter(size.name()).is_none()) {
        return Err(other());
    }
    let mut given = if entry.presets.is_empty() { Overrides::new() } else { entry.preset(PAPER, kind)? };
    for size in [ITERATIONS, ANTS] {
        given.insert(size.name(), Value::from(start.parameters[size] as f64));
    }
    let parameters = entry.configure(kind, &given)?;
    let planner: Box<dyn Any> = (entry.start)(&Start { entry, parameters: &parameters, ..*start })?.planner;
    planner.downcast().map(|colony| *colony).map_err(|_| other())
}
