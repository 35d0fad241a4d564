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
mod journey;
mod parameters;
mod queue;
mod route;
mod steps;
mod tell;
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
    any, exact,
    geometry::{self, Cells, Course},
    kernel::{Best, Border, Digest, Error, Event, Frame, Inspection, Item, Planner, Readings, Solution, Stage, Status, Track, Yardstick},
    math::Length,
    params::Settings,
    scene::{Body as SceneBody, GridScene, Motion, Scene},
};

use body::Body;
use journey::Journey;
use route::Route;

pub use tell::SYMBOLS;

/// Up to this many cells a drive is driven ahead of time when it begins, and up to so many cells times steps of planning the
/// whole run when it starts: only to know how long it takes.
const KNOWN: [usize; 2] = [10_000, 100_000];

/// With more obstacles that takes too long.
const CROWD: usize = 30;

/// Nor where it takes more steps, or the robot has to search for more escapes.
const FORETOLD: u64 = 5000;
const SEARCHES: u64 = 40;

/// How often a second an obstacle may bounce to and fro: what goes faster is everywhere at once, and takes as long to follow.
const BOUNCES: f64 = 100.0;

/// What never changes during a drive.
struct Ground {
    scene: Arc<Scene>,
    cells: Arc<Cells>,
    course: Course,
    body: Body,
    /// Seconds a step.
    period: f64,
    /// Seconds from each cell to the goal without turns; made when it is first needed.
    ahead: OnceLock<Vec<f64>>,
}

impl Ground {
    fn new(scene: &Arc<Scene>, settings: &Settings) -> Result<Self, Error> {
        let grid = scene.grid()?;
        let body = Body::new(grid, settings)?;
        if body.border == Border::Bounce {
            check_bounces(grid)?;
        }
        Ok(Self {
            cells: Arc::clone(grid.cells()),
            course: grid.course()?,
            body,
            period: settings.number("period"),
            ahead: OnceLock::new(),
            scene: Arc::clone(scene),
        })
    }

    fn grid(&self) -> &GridScene {
        match self.scene.body() {
            SceneBody::Grid(grid) => grid,
            _ => unreachable!("a drive starts on grids only"),
        }
    }

    /// Seconds from a cell to the goal without turns, by Dijkstra's search from the goal; infinite where no way leads.
    fn ahead(&self, cell: usize) -> f64 {
        let all = || {
            let cells = &self.cells;
            let mut best = vec![f64::INFINITY; cells.len()];
            let mut open = BinaryHeap::from([(Reverse(Length(0.0)), self.course.goal)]);
            best[self.course.goal] = 0.0;
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
#[derive(Clone)]
struct Dynamic {
    ground: Arc<Ground>,
    route: Box<dyn Route>,
    journey: Option<Journey>,
    /// Planning found no way.
    lost: bool,
    iteration: u64,
    /// Seconds after which it gives up, and steps.
    most: f64,
    limit: u64,
    /// The last iteration, once somebody knows: all copies of a run end alike.
    end: Arc<OnceLock<u64>>,
}

/// Starts a drive on ways of this kind.
fn start(
    scene: &Arc<Scene>,
    settings: &Settings,
    route: impl FnOnce(&Arc<Ground>) -> Result<Box<dyn Route>, Error>,
) -> Result<Box<dyn any::AnyPlanner>, Error> {
    let ground = Arc::new(Ground::new(scene, settings)?);
    let route = route(&ground)?;
    let most = match settings.number("time_limit") {
        0.0 => {
            let (cells, course) = (&ground.cells, &ground.course);
            let way = exact::shortest_way(cells, course.start, course.goal).unwrap_or_default();
            let path = course.path(cells, way);
            // As long as the shortest way takes four times over, and a minute.
            60.0 + 4.0 * (geometry::length(&path) / ground.body.speed + geometry::turns(&path) as f64 * ground.body.turn_time)
        }
        seconds => seconds,
    };
    let planning = route.steps();
    let driving = (most / ground.period).ceil() as u64;
    // Those who plan step by step count only that; the others their drive.
    let limit = if planning > 0 { planning + driving } else { driving.min(settings.integer("iterations")) };
    let mut dynamic = Dynamic { ground, route, journey: None, lost: false, iteration: 0, most, limit, end: Arc::default() };
    if dynamic.route.steps() == 0 {
        dynamic.set_out();
    } else if planning as usize * dynamic.ground.cells.len() <= KNOWN[1] {
        dynamic.foretell();
    }
    Ok(Box::new(dynamic))
}

impl Dynamic {
    /// The way is planned: the drive begins.
    fn set_out(&mut self) {
        match self.route.way() {
            Some(way) => {
                self.journey = Some(Journey::new(&self.ground, &way));
                if self.ground.cells.len() <= KNOWN[0] {
                    self.foretell();
                }
            }
            None => self.lost = true,
        }
    }

    /// Finds out when the run ends, if nobody knows and it is soon done.
    fn foretell(&self) {
        if self.end.get().is_none() && self.ground.grid().moving.len() <= CROWD {
            // The copy knows of this one's end, and must not ask itself.
            let mut other = Self { end: Arc::new(OnceLock::from(self.limit)), ..self.clone() };
            let searches = |other: &Self| other.journey.as_ref().map_or(0, |journey| journey.searches);
            // What takes long is not worth it: then the limit is all that is known.
            for _ in 0..FORETOLD {
                if Planner::step(&mut other) != Status::Running {
                    let _ = self.end.set(other.iteration);
                    return;
                }
                if searches(&other) > SEARCHES {
                    return;
                }
            }
        }
    }

    fn track(&self, journey: &Journey) -> Track {
        let Body { radius, border, .. } = self.ground.body;
        Track { path: journey.path(), moments: journey.moments.clone(), radius, border }
    }
}

impl Planner for Dynamic {
    fn step(&mut self) -> Status {
        if self.status() != Status::Running {
            return self.status();
        }
        self.iteration += 1;
        if let Some(journey) = &mut self.journey {
            journey.step(&mut *self.route, self.iteration);
        } else {
            self.route.step();
            if self.iteration >= self.route.steps() {
                self.set_out();
            }
        }
        let status = self.status();
        if status != Status::Running {
            let _ = self.end.set(self.iteration);
        }
        status
    }

    fn status(&self) -> Status {
        match &self.journey {
            _ if self.lost => Status::Infeasible,
            Some(journey) if journey.arrived => Status::Solved,
            Some(journey) if journey.now >= self.most || self.iteration >= self.limit => Status::Exhausted,
            _ => Status::Running,
        }
    }

    fn iteration(&self) -> u64 {
        self.iteration
    }

    fn limit(&self) -> u64 {
        self.end.get().copied().unwrap_or(self.limit)
    }

    fn evaluations(&self) -> u64 {
        self.route.evaluations()
    }

    /// There is a result when the robot is at the goal; it costs the time that it took.
    fn best(&self) -> Option<Best> {
        let journey = self.journey.as_ref().filter(|journey| journey.arrived)?;
        Some(Best { cost: journey.now, solution: Solution::Drive(self.track(journey)) })
    }

    fn yardstick(&self) -> Yardstick {
        Yardstick::Cells
    }

    fn stages(&self) -> Vec<Stage> {
        let drive = Stage { name: "drive", title: "Drive", end: self.limit() };
        match self.route.steps() {
            0 => vec![drive],
            end => vec![Stage { name: "plan", title: "Plan", end }, drive],
        }
    }

    fn events(&self) -> &[Event] {
        self.journey.as_ref().map_or(&[], |journey| &journey.events)
    }

    fn trouble(&self) -> Option<String> {
        match &self.journey {
            _ if self.lost => Some("No way to the goal was found to drive on".to_owned()),
            Some(journey) if self.status() == Status::Exhausted => {
                Some(tell::why_not(journey, if journey.now >= self.most { "time_limit" } else { "iterations" }))
            }
            _ => None,
        }
    }

    fn read(&self, out: &mut Readings) {
        tell::read(self, out);
    }

    fn draw(&self, frame: &mut Frame) {
        draw::draw(self, frame);
    }

    fn inspect(&self, item: Item) -> Option<Inspection> {
        tell::inspect(self, item)
    }

    fn digest(&self, out: &mut Digest) {
        self.route.digest(out);
        if let Some(journey) = &self.journey {
            journey.digest(out);
        }
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.route.bytes() + self.journey.as_ref().map_or(0, Journey::bytes)
    }
}
