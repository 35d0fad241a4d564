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
    Error, Registry, Run, Setup, Status, Value,
    geometry::{distance_squared, length},
    scene::{Header, grid},
};

use self::{
    load::{FASTEST, LIMIT, World, worlds},
    row::key,
};
use super::{
    super::{failure::Failure, runner::Job, table::Table},
    suite::{Attempt, Contender, Suite, check_count},
};

pub use load::RADIUS;
pub use row::Row;

/// The family whose planners take part.
const FAMILY: &str = "dynamic";
/// So near to the goal a run has succeeded, in metres.
const NEAR: f64 = 1.0;
/// What is set of planners, unless something else is.
const TIME_LIMIT: &str = "time_limit";

/// The worlds of a folder.
pub struct Plan {
    folder: PathBuf,
    worlds: Vec<Arc<World>>,
    notes: Vec<String>,
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
        let worlds = worlds.into_iter().filter(|world| world.number % every.max(1) == 0).map(Arc::new).collect();
        Ok(Self { folder: folder.to_owned(), worlds, notes, radius })
    }
}

impl Suite for Plan {
    type Attempt = Task;

    const NAME: &'static str = "barn";

    fn everyone(registry: &Registry) -> Vec<Contender> {
        registry.planners().iter().filter(|entry| entry.family == FAMILY).map(|entry| Contender::new(entry.name)).collect()
    }

    fn attempts(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Task>, Error> {
        check_count(self.worlds.len().saturating_mul(contenders.len()))?;
        let mut all = Vec::new();
        for contender in contenders {
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

    fn notes(&self) -> &[String] {
        &self.notes
    }
}

/// The challenge's score of a run through a world whose best way is so long.
fn score(success: bool, best: f64, time: f64) -> f64 {
    let best = best / FASTEST;
    if success { best / time.clamp(2.0 * best, 8.0 * best) } else { 0.0 }
}

/// When and where a robot was, by iterations.
#[derive(Default)]
struct Track {
    times: Vec<f64>,
    lengths: Vec<f64>,
}

impl Track {
    fn note(&mut self, run: &mut Run) {
        let of = |wanted: &str, run: &mut Run| run.readings().iter().find(|(name, _)| *name == wanted).map_or(0.0, |(_, value)| value);
        let (time, length) = (of("time", run), of("length", run));
        self.times.push(time);
        self.lengths.push(length);
    }

    /// When it had gone so far.
    fn time_at(&self, length: f64) -> f64 {
        let k = self.lengths.partition_point(|gone| *gone < length);
        match (k.checked_sub(1), self.lengths.get(k)) {
            (Some(before), Some(after)) if *after > self.lengths[before] => {
                let share = (length - self.lengths[before]) / (after - self.lengths[before]);
                self.times[before] + share * (self.times[k] - self.times[before])
            }
            _ => self.times.get(k).or(self.times.last()).copied().unwrap_or(0.0),
        }
    }
}

impl Task {
    fn setup(&self) -> Result<Setup, Error> {
        let name = format!("{}-{}", self.world.set, self.world.number);
        let scene = grid::KIND.scene(Header::named(&name, &name), self.world.grid.clone())?;
        let Contender { planner, mut params } = (*self.contender).clone();
        if params.get(TIME_LIMIT).is_none() {
            params.insert(TIME_LIMIT, Value::Number(LIMIT));
        }
        Ok(Setup { planner, scene: Arc::new(scene), params, seed: self.world.number as u64 + 1 })
    }

    fn carry_out(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        #[expect(clippy::disallowed_types, reason = "what it takes is measured, and is no part of the result")]
        let begun = std::time::Instant::now();
        let setup = self.setup()?;
        let seed = setup.seed;
        let mut run = Run::with_keyframes(&self.registry, setup, 0)?;
        let mut track = Track::default();
        track.note(&mut run);
        let mut status = Status::Running;
        while status == Status::Running {
            status = run.step(1);
            track.note(&mut run);
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let hits = run.readings().iter().find(|(name, _)| *name == "collisions").map_or(0.0, |(_, hits)| hits);
        let outcome = run.outcome();
        let path = outcome.path.unwrap_or_default();
        let (gone, near) = self.until_near(&path);
        let clearance = self.clearance(&path);
        let collided = hits > 0.0 || clearance.is_some_and(|clearance| clearance < 0.0);
        let time = near.map_or(LIMIT, |near| track.time_at(near)).min(LIMIT);
        let success = near.is_some() && !collided && time < LIMIT;
        Ok(Some(Row {
            planner: self.contender.planner.clone(),
            params: self.contender.set(),
            set: self.world.set.to_owned(),
            world: self.world.number,
            seed,
            success,
            collided,
            timeout: near.is_none() && !path.is_empty(),
            time,
            length: near.unwrap_or(gone),
            clearance,
            best: self.world.length,
            score: score(success, self.world.length, time),
            seconds: begun.elapsed().as_secs_f64(),
        }))
    }

    /// How far it went in all, and until it came near the goal.
    fn until_near(&self, path: &[[f64; 2]]) -> (f64, Option<f64>) {
        let goal = self.world.grid.goal.unwrap_or_default();
        let mut gone = 0.0;
        let mut near = None;
        for pair in path.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let long = length(pair);
            if near.is_none() && long > 0.0 {
                let along = [(b[0] - a[0]) / long, (b[1] - a[1]) / long];
                let from = [a[0] - goal[0], a[1] - goal[1]];
                // Where the straight line enters the circle around the goal.
                let toward = from[0] * along[0] + from[1] * along[1];
                let under = toward * toward - (from[0] * from[0] + from[1] * from[1] - NEAR * NEAR);
                let enters = (under >= 0.0).then(|| (-toward - under.sqrt()).max(0.0));
                near = enters.filter(|enters| *enters <= long && toward <= 0.0).map(|enters| gone + enters);
            }
            gone += long;
        }
        (gone, near)
    }

    /// The smallest distance between its rim and what stands.
    fn clearance(&self, path: &[[f64; 2]]) -> Option<f64> {
        let apart = |pair: &[[f64; 2]], center: [f64; 2]| distance_squared(pair[0], pair[1], center).sqrt();
        let distances = path.windows(2).flat_map(|pair| self.world.cylinders.iter().map(move |(center, own)| apart(pair, *center) - own));
        distances.reduce(f64::min).map(|nearest| nearest - self.radius)
    }
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        key(&self.contender.name(), self.world.number, self.world.number as u64 + 1)
    }

    fn weight(&self) -> u64 {
        self.world.grid.blocked.len() as u64
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        self.carry_out(stop)
    }
}

impl Attempt for Task {
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
    fn the_time_is_when_it_had_gone_so_far() {
        let track = Track { times: vec![0.0, 1.0, 2.0, 3.0], lengths: vec![0.0, 2.0, 2.0, 4.0] };
        assert_eq!([0.0, 1.0, 2.0, 3.0, 4.0, 9.0].map(|length| track.time_at(length)), [0.0, 0.5, 1.0, 2.5, 3.0, 3.0]);
    }
}
