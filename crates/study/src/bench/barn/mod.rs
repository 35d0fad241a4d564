//! The suite `barn`: a robot through the worlds of the BARN challenge, which stand still or move.
//!
//! Data: <https://github.com/Daffan/the-barn-challenge>

mod load;
mod motion;
mod report;
mod row;

use std::{
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use forage::{
    Error, Frame, Registry, Run, Setup, Status, Value,
    describe::layers,
    geometry::{distance_squared, length},
    kernel::Message,
    message,
    scene::{Header, grid},
};

use self::{
    load::{LIMIT, World, worlds},
    row::{key, score},
};
use super::{
    super::{failure::Failure, runner::Job, table::Table},
    suite::{Contender, Suite, SuiteJob, check_count},
};

pub use load::RADIUS;
pub use row::Row;

/// The family whose planners take part.
const FAMILY: &str = "dynamic";
/// So near to the goal a run has succeeded, in metres.
const NEAR: f64 = 1.0;
/// Tracks are drawn with 32 bits: what is less deep than this, in metres, is no contact.
const ROUNDING: f64 = 1e-4;
/// The parameter by which drives give up, which the challenge decides.
const TIME_LIMIT: &str = "time_limit";

/// The worlds of a folder.
pub struct Plan {
    folder: PathBuf,
    worlds: Vec<Arc<World>>,
    notes: Vec<Message>,
    radius: f64,
}

/// A planner in a world.
#[derive(Clone)]
pub struct Task {
    registry: Arc<Registry>,
    contender: Arc<Contender>,
    world: Arc<World>,
    radius: f64,
}

impl Plan {
    /// Reads the worlds of a copy of the challenge's repository, for a robot that is a disc of this radius in metres; only every
    /// `every`-th, if it is said.
    ///
    /// # Errors
    /// A folder without worlds; a file that cannot be read.
    pub fn read(folder: &Path, radius: f64, every: usize) -> Result<Self, Failure> {
        let (worlds, notes) = worlds(folder, radius)?;
        let worlds: Vec<_> = worlds.into_iter().filter(|world| world.number % every.max(1) == 0).map(Arc::new).collect();
        if worlds.is_empty() {
            let allowed = message!("study-divisor", "a divisor of the number of at least one world");
            return Err(Error::refused("--every", every, allowed).into());
        }
        Ok(Self { folder: folder.to_owned(), worlds, notes, radius })
    }
}

impl Suite for Plan {
    type Task = Task;

    const NAME: &'static str = "barn";

    fn all_planners(registry: &Registry) -> Vec<Contender> {
        registry.planners().iter().filter(|entry| entry.family == FAMILY).map(|entry| Contender::new(entry.name)).collect()
    }

    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Task>, Error> {
        check_count(self.worlds.len().saturating_mul(contenders.len()))?;
        let mut all = Vec::new();
        for contender in contenders {
            if let Some(limit) = contender.params.get(TIME_LIMIT) {
                let allowed = message!("study-challenge-limit", "left out: the challenge gives {limit} s", limit = LIMIT);
                return Err(Error::refused(TIME_LIMIT, limit.to_string(), allowed).within(&contender.planner));
            }
            let contender = Arc::new(contender.clone());
            all.extend(self.worlds.iter().map(|world| Task {
                registry: Arc::clone(registry),
                contender: Arc::clone(&contender),
                world: Arc::clone(world),
                radius: self.radius,
            }));
            // One world says for all what is set wrongly.
            if let Some(task) = all.last() {
                task.setup()?.check(registry).map_err(|error| error.within(&contender.planner))?;
            }
        }
        Ok(all)
    }

    fn write(&self, rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        report::write(rows, &self.folder, folder)
    }

    fn table(&self, rows: &[Row]) -> Table {
        report::table(rows, &self.folder)
    }

    fn notes(&self) -> &[Message] {
        &self.notes
    }
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    Success,
    Collision,
    Timeout,
    /// It gave up: there is no way for it.
    GaveUp,
}

/// Where a robot was, and when: x, y and time.
type Track = [[f64; 3]];

/// When it came within a metre of the goal, and how far it had gone.
fn near(track: &Track, goal: [f64; 2]) -> Option<(f64, f64)> {
    let mut gone = 0.0;
    for pair in track.windows(2) {
        let ([x, y, begun], [_, _, ended]) = (pair[0], pair[1]);
        let long = length(&[[x, y], [pair[1][0], pair[1][1]]]);
        let from = [x - goal[0], y - goal[1]];
        let apart = from[0] * from[0] + from[1] * from[1] - NEAR * NEAR;
        if apart <= 0.0 {
            return Some((begun, gone));
        }
        if long > 0.0 {
            let along = [(pair[1][0] - x) / long, (pair[1][1] - y) / long];
            // Where the straight line enters the circle around the goal.
            let toward = -(from[0] * along[0] + from[1] * along[1]);
            let under = toward * toward - apart;
            let enters = if under >= 0.0 { toward - under.sqrt() } else { f64::INFINITY };
            if (0.0..=long).contains(&enters) {
                return Some((begun + enters / long * (ended - begun), gone + enters));
            }
        }
        gone += long;
    }
    None
}

/// When a disc of a radius that follows the track first touches what is static, and how near it comes until `end`.
fn contact(track: &Track, cylinders: &[([f64; 2], f64)], radius: f64, end: f64) -> (Option<f64>, Option<f64>) {
    let (mut hit, mut nearest) = (None, None::<f64>);
    for pair in track.windows(2).filter(|pair| pair[0][2] <= end) {
        let [a, b] = [pair[0], pair[1]].map(|[x, y, _]| [x, y]);
        let distance = |(center, own): &([f64; 2], f64)| distance_squared(a, b, *center).sqrt() - own - radius;
        if let Some(distance) = cylinders.iter().map(distance).reduce(f64::min) {
            nearest = Some(nearest.map_or(distance, |nearest| nearest.min(distance)));
            if distance < -ROUNDING && hit.is_none() {
                hit = Some(pair[0][2]);
            }
        }
    }
    (hit, nearest)
}

/// What ended a run that lasted for `lasted` seconds: what came first.
fn end(near: Option<f64>, hit: Option<f64>, lasted: f64) -> (End, f64) {
    let (near, hit) = (near.unwrap_or(f64::INFINITY), hit.unwrap_or(f64::INFINITY));
    match () {
        () if hit <= near && hit < LIMIT => (End::Collision, hit),
        () if near < LIMIT => (End::Success, near),
        () if lasted >= LIMIT => (End::Timeout, LIMIT),
        () => (End::GaveUp, lasted),
    }
}

impl Task {
    fn setup(&self) -> Result<Setup, Error> {
        let name = format!("{}-{}", self.world.set, self.world.number);
        let scene = grid::KIND.scene(Header::named(&name, &name), self.world.grid.clone())?;
        let Contender { planner, mut params } = (*self.contender).clone();
        params.insert(TIME_LIMIT, Value::Number(LIMIT));
        Ok(Setup { planner, scene: Arc::new(scene), params, seed: self.world.number as u64 + 1 })
    }

    fn carry_out(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        #[expect(clippy::disallowed_types, reason = "what it takes is measured, and is no part of the result")]
        let begun = std::time::Instant::now();
        let setup = self.setup()?;
        let seed = setup.seed;
        let mut run = Run::with_keyframes(&self.registry, setup, 0)?;
        let reading = |run: &mut Run, wanted: &str| run.readings().iter().find(|(name, _)| *name == wanted).map_or(0.0, |(_, value)| value);
        let mut hit = None;
        loop {
            let status = run.step(1);
            if hit.is_none() && reading(&mut run, "collisions") > 0.0 {
                hit = Some(reading(&mut run, "time"));
            }
            if status != Status::Running {
                break;
            }
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let track = driven(&run);
        let near = near(&track, self.world.grid.goal.unwrap_or_default());
        let until = near.map_or(LIMIT, |(time, _)| time);
        let (touched, clearance) = contact(&track, &self.world.cylinders, self.radius, until);
        let hit = [hit, touched].into_iter().flatten().reduce(f64::min);
        let lasted = track.last().map_or(0.0, |last| last[2]).max(reading(&mut run, "time"));
        let (end, time) = end(near.map(|(time, _)| time), hit, lasted);
        let success = end == End::Success;
        let gone = length(&track.iter().map(|&[x, y, _]| [x, y]).collect::<Vec<_>>());
        Ok(Some(Row {
            planner: self.contender.planner.clone(),
            params: self.contender.overrides_text(),
            set: self.world.set.to_owned(),
            world: self.world.number,
            radius: self.radius,
            seed,
            success,
            collided: end == End::Collision,
            timeout: end == End::Timeout,
            time,
            length: near.filter(|_| success).map_or(gone, |(_, gone)| gone),
            clearance,
            best: self.world.length,
            score: score(success, self.world.length, time),
            seconds: begun.elapsed().as_secs_f64(),
        }))
    }
}

/// The way that a run's robot has gone, as it is drawn.
fn driven(run: &Run) -> Vec<[f64; 3]> {
    let mut frame = Frame::default();
    run.draw(&mut frame, usize::MAX);
    let span = frame.spans().find(|span| span.layer == layers::TRACK.key);
    let vertices = span.map_or(&[][..], |span| &frame.vertices()[4 * span.first as usize..4 * (span.first + span.count) as usize]);
    vertices.chunks_exact(4).map(|vertex| [vertex[0], vertex[1], vertex[3]].map(f64::from)).collect()
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        key(&self.contender.name(), self.world.number, self.world.number as u64 + 1, self.radius)
    }

    fn weight(&self) -> u64 {
        self.world.grid.blocked.len() as u64
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        self.carry_out(stop)
    }
}

impl SuiteJob for Task {
    fn contender(&self) -> &Contender {
        &self.contender
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_score_is_that_of_the_challenge() {
        // The best time of 10 m is 5 s: up to 10 s count as 10, from 40 s on as 40.
        let scores = [3.0, 10.0, 20.0, 40.0, 99.0].map(|time| score(true, 10.0, time));
        assert_eq!(scores, [0.5, 0.5, 0.25, 0.125, 0.125]);
        assert_eq!(score(false, 10.0, 10.0), 0.0);
    }

    #[test]
    fn a_run_ends_by_what_comes_first() {
        // Along x at 2 m/s; it waits for 10 s at x = 4. The goal is at 10.
        let track = [[0.0, 0.0, 0.0], [4.0, 0.0, 2.0], [4.0, 0.0, 12.0], [10.0, 0.0, 15.0]];
        let (time, gone) = near(&track, [10.0, 0.0]).unwrap();
        assert!((time - 14.5).abs() < 1e-9 && (gone - 9.0).abs() < 1e-9);
        assert_eq!(near(&track[..3], [10.0, 0.0]), None);
        let pillar = [([6.0, 0.5], 0.1)];
        assert_eq!(contact(&track, &pillar, 0.3, 99.0).0, None);
        assert!((contact(&track, &pillar, 0.3, 99.0).1.unwrap() - 0.1).abs() < 1e-9);
        assert_eq!(contact(&track, &pillar, 0.5, 99.0).0, Some(12.0));
        assert_eq!(contact(&track, &pillar, 0.5, 11.0).0, None, "after the end it does not matter");
        assert_eq!(end(Some(14.5), None, 15.0), (End::Success, 14.5));
        assert_eq!(end(Some(14.5), Some(12.0), 15.0), (End::Collision, 12.0));
        assert_eq!(end(Some(14.5), Some(14.8), 15.0), (End::Success, 14.5));
        assert_eq!(end(None, None, 100.0), (End::Timeout, 100.0));
        assert_eq!(end(Some(100.5), None, 101.0), (End::Timeout, 100.0));
        assert_eq!(end(None, None, 3.0), (End::GaveUp, 3.0));
    }
}
