//! Drives among moving obstacles, [WOLF-ANT] §5.3: a way is planned, then a robot drives it in simulated time, sees what
//! moves, foresees collisions and goes round, plans anew or waits.
//!
//! There is one drive (`journey`), and one way to decide (`decide`). What its planners differ in is who plans the ways, a `Route`, a file each. `body` is how
//! the robot moves, `world` what it sees and foresees, `escape` what it does when neither a way round nor standing is safe.

mod a_star;
pub mod a_star_drive;
mod body;
mod d_star_lite;
pub mod d_star_lite_drive;
mod decide;
mod draw;
mod escape;
mod explain;
mod journey;
mod parameters;
mod queue;
mod route;
mod steps;
#[cfg(test)]
mod tests;
pub mod wolf_ant_drive;
mod world;

use std::{
    cmp::Reverse,
    collections::BinaryHeap,
    sync::{Arc, OnceLock},
};

use crate::{
    describe::Start,
    exact,
    geometry::{self, Cells, Endpoints},
    kernel::{
        Border, Candidate, Error, Event, Explain, Facets, Failure, Frame, Inspection, Item, Planner, Progress, Readings, ReferenceOptimum,
        Solution, Stage, Started, State, Status, Timeline, Track,
    },
    math::Length,
    params::Parameters,
    scene::{GridScene, Motion, Scene},
};

use body::Body;
use journey::Journey;
use parameters::{ITERATIONS, PERIOD, TIME_LIMIT};
use route::Route;

pub use explain::SYMBOLS;

/// How often a second an obstacle may bounce to and fro: what goes faster is everywhere at once, and takes as long to follow.
const BOUNCES: f64 = 100.0;

/// What never changes during a drive.
struct Ground {
    scene: Arc<Scene>,
    grid: Arc<GridScene>,
    cells: Arc<Cells>,
    endpoints: Endpoints,
    body: Body,
    /// Seconds a step.
    period: f64,
    /// Seconds from each cell to the goal without turns; made when it is first needed.
    ahead: OnceLock<Vec<f64>>,
}

impl Ground {
    fn new(scene: &Arc<Scene>, settings: &Parameters) -> Result<Self, Error> {
        let grid = scene.share::<GridScene>()?;
        let body = Body::new(&grid, settings)?;
        if body.border == Border::Bounce {
            check_bounces(&grid)?;
        }
        Ok(Self {
            cells: Arc::clone(grid.cells()),
            endpoints: grid.endpoints()?,
            body,
            period: settings[PERIOD],
            ahead: OnceLock::new(),
            scene: Arc::clone(scene),
            grid,
        })
    }

    /// Seconds from a cell to the goal without turns, by Dijkstra's search from the goal; infinite where no way leads.
    fn ahead(&self, cell: usize) -> f64 {
        let all = || {
            let cells = &self.cells;
            let mut best = vec![f64::INFINITY; cells.len()];
            let mut open = BinaryHeap::from([(Reverse(Length(0.0)), self.endpoints.goal)]);
            best[self.endpoints.goal] = 0.0;
            while let Some((Reverse(Length(length)), at)) = open.pop() {
                if length > best[at] {
                    continue;
                }
                for d in (0..8).filter(|d| cells.moves(at) >> d & 1 != 0) {
                    let (next, to) = (cells.next(at, d), length + if d & 1 == 0 { 1.0 } else { std::f64::consts::SQRT_2 });
                    if to < best[next] {
                        best[next] = to;
                        open.push((Reverse(Length(to)), next));
                    }
                }
            }
            best.iter_mut().for_each(|length| *length *= cells.side / self.body.speed);
            best
        };
        self.ahead.get_or_init(all)[cell]
    }
}

/// Refuses obstacles that would bounce too often.
fn check_bounces(grid: &GridScene) -> Result<(), Error> {
    for (i, disc) in grid.moving.iter().enumerate() {
        let Motion::Velocity(velocity) = disc.motion else { continue };
        for (axis, speed) in velocity.into_iter().enumerate() {
            let room = grid.bounds().max[axis] - 2.0 * disc.radius;
            if room > 0.0 && speed.abs() > BOUNCES * room {
                let allowed = format!("at most {} a second where obstacles bounce: {BOUNCES} times to and fro", BOUNCES * room);
                return Err(Error::refused(format!("moving[{i}].velocity[{axis}]"), speed, allowed));
            }
        }
    }
    Ok(())
}

/// A plan, then a drive.
#[derive(Clone, State)]
struct Dynamic {
    #[state(shared)]
    ground: Arc<Ground>,
    route: Box<dyn Route>,
    journey: Option<Journey>,
    /// Planning found no way.
    lost: bool,
    iteration: u64,
    /// Seconds after which it gives up.
    #[state(shared)]
    most: f64,
}

/// Starts a drive on ways of this kind.
fn start(start: &Start, route: impl FnOnce(&Arc<Ground>) -> Result<Box<dyn Route>, Error>) -> Result<Started, Error> {
    let settings = start.parameters;
    let ground = Arc::new(Ground::new(start.scene, settings)?);
    let route = route(&ground)?;
    let most = match settings[TIME_LIMIT] {
        0.0 => {
            let (cells, endpoints) = (&ground.cells, &ground.endpoints);
            let way = exact::shortest_way(cells, endpoints.start, endpoints.goal).unwrap_or_default();
            let path = endpoints.path(cells, way);
            // As long as the shortest way takes four times over, and a minute.
            60.0 + 4.0 * (geometry::length(&path) / ground.body.speed + geometry::turns(&path) as f64 * ground.body.turn_time)
        }
        seconds => seconds,
    };
    let planning = route.steps();
    let driving = (most / ground.period).ceil() as u64;
    // Those who plan step by step count only that; the others their drive.
    let limit = if planning > 0 { planning + driving } else { driving.min(settings[ITERATIONS]) };
    let mut dynamic = Dynamic { ground, route, journey: None, lost: false, iteration: 0, most };
    let drive = Stage { name: "drive", title: "Drive", end: None };
    let mut stages = vec![drive];
    if planning == 0 {
        dynamic.set_out();
    } else {
        stages.insert(0, Stage { name: "plan", title: "Plan", end: Some(planning) });
    }
    let progress = dynamic.progress();
    let started = Started::new(dynamic, limit).open_ended().measured_by(ReferenceOptimum::Cells).in_stages(stages);
    Ok(Started { progress, ..started })
}

impl Dynamic {
    /// The way is planned: the drive begins.
    fn set_out(&mut self) {
        match self.route.way() {
            Some(way) => self.journey = Some(Journey::new(&self.ground, &way)),
            None => self.lost = true,
        }
    }

    fn progress(&self) -> Progress {
        match &self.journey {
            _ if self.lost => Progress::Done(Status::Infeasible),
            Some(journey) if journey.arrived => Progress::Done(Status::Solved),
            Some(journey) if journey.now >= self.most => Progress::Done(Status::Exhausted),
            _ => Progress::Continue,
        }
    }

    fn track(&self, journey: &Journey) -> Track {
        let Body { radius, border, .. } = self.ground.body;
        Track { path: journey.path(), moments: journey.moments.clone(), radius, border }
    }
}

impl Planner for Dynamic {
    fn advance(&mut self) -> Progress {
        self.iteration += 1;
        if let Some(journey) = &mut self.journey {
            journey.step(&mut *self.route, self.iteration);
        } else {
            self.route.step();
            if self.iteration >= self.route.steps() {
                self.set_out();
            }
        }
        self.progress()
    }

    fn evaluations(&self) -> u64 {
        self.route.evaluations()
    }

    /// There is a result when the robot is at the goal; it costs the time that it took.
    fn best(&self) -> Option<Candidate> {
        let journey = self.journey.as_ref().filter(|journey| journey.arrived)?;
        Some(Candidate { cost: journey.now, solution: Solution::Drive(self.track(journey)) })
    }

    fn read(&self, out: &mut Readings) {
        explain::read(self, out);
    }

    fn draw(&self, frame: &mut Frame) {
        draw::draw(self, frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).timeline(self).failure(self)
    }
}

impl Explain for Dynamic {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        explain::inspect(self, item)
    }
}

impl Timeline for Dynamic {
    fn events(&self) -> &[Event] {
        self.journey.as_ref().map_or(&[], |journey| &journey.events)
    }
}

impl Failure for Dynamic {
    fn failure(&self, status: Status) -> Option<String> {
        match &self.journey {
            _ if self.lost => Some("No way to the goal was found to drive on".to_owned()),
            Some(journey) if status == Status::Exhausted => {
                Some(explain::why_not(journey, if journey.now >= self.most { TIME_LIMIT.name() } else { ITERATIONS.name() }))
            }
            _ => None,
        }
    }
}
