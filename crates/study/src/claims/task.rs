//! A run that a claim needs, and how it is carried out.

use std::{
    fmt::Write,
    sync::atomic::{AtomicBool, Ordering},
};

use forage::{
    Overrides, Setup, Status, Trial,
    arm::ArmScene,
    follow::motion,
    kernel::{Error, Stepped},
    run::trial::WITHIN,
    standard,
};

use super::{
    super::{arm_rrt, colonies, runner::Job},
    claim::{Arm, On, Part, Until},
    run::Run,
};

/// A run that a claim needs.
#[derive(Debug, Clone)]
pub struct Task {
    pub on: On,
    pub arm: Arm,
    pub until: Until,
    pub seed: u64,
}

impl Part {
    /// The runs of an arm, scene by scene, seed by seed.
    pub(super) fn tasks(&self, arm: usize) -> impl Iterator<Item = Task> + '_ {
        let task = move |on: &On, seed| Task { on: on.clone(), arm: self.arms[arm].clone(), until: self.until, seed };
        self.on.iter().flat_map(move |on| (self.seeds[0]..=self.seeds[1]).map(move |seed| task(on, seed)))
    }
}

impl On {
    /// In the rows and in reports.
    pub(super) fn name(&self) -> String {
        match self {
            Self::Scene(name) => (*name).to_owned(),
            Self::Map { generator, settings, map } => format!("{generator} {settings}, map {map}"),
        }
    }
}

impl Until {
    fn name(self) -> String {
        match self {
            Self::End => "end".to_owned(),
            Self::Iteration(k) => format!("iteration {k}"),
            Self::Evaluations(n) => format!("{n} evaluations"),
        }
    }
}

impl Arm {
    fn parameters(&self) -> String {
        let listed = |given: &Overrides| given.iter().map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join(" ");
        if self.motion.is_empty() { listed(&self.params) } else { format!("{} motion: {}", listed(&self.params), listed(&self.motion)) }
    }
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        format!("{}, {}, {}, {}, seed {}", self.on.name(), self.arm.planner, self.arm.parameters(), self.until.name(), self.seed)
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let scene = self.on.scene()?;
        let setup = Setup { planner: self.arm.planner.to_owned(), scene: scene.clone(), params: self.arm.params.clone(), seed: self.seed };
        let mut trial = Trial::new(standard(), setup, WITHIN)?;
        let (most, enough) = match self.until {
            Until::End => (u64::MAX, u64::MAX),
            Until::Iteration(k) => (k, u64::MAX),
            Until::Evaluations(n) => (u64::MAX, n),
        };
        while trial.run().iteration() < most && trial.run().evaluations() < enough {
            match trial.step_until(&|| stop.load(Ordering::Relaxed))? {
                Stepped::Whole => {}
                Stepped::Partly => return Ok(None),
                Stepped::Not => break,
            }
        }
        let record = trial.record();
        let curve: Vec<u64> = trial.curve().iter().map(|improvement| improvement.iteration).collect();
        let outcome = trial.run().outcome();
        let mut numbers = String::new();
        let mut add = |name: &str, number: Option<f64>| {
            if let Some(number) = number.filter(|number| number.is_finite()) {
                let _ = write!(numbers, " {name}={number}");
            }
        };
        for &(name, number) in &outcome.readings {
            add(name, Some(number));
        }
        if !outcome.readings.iter().any(|(name, _)| *name == "turns") {
            add("turns", outcome.turns.map(|turns| turns as f64));
        }
        if !outcome.readings.iter().any(|(name, _)| *name == "turning") {
            add("turning", outcome.turning);
        }
        add("seconds", colonies::seconds(&scene, record.length.unwrap_or(f64::NAN), outcome.turns.map_or(f64::NAN, |turns| turns as f64)));
        if let Some(path) = outcome.tip_path.as_deref() {
            add("aside", Some(arm_rrt::aside(scene.get::<ArmScene>()?, path)));
        }
        let best = trial.run().best().map(|best| best.solution);
        if let Some(motion) = motion::along(&scene, best.as_ref(), &self.arm.motion)? {
            let jumps = jumps(&motion.rows);
            add("largest_jump", jumps.iter().copied().reduce(f64::max));
            add("mean_jump", Some(jumps.iter().sum::<f64>() / jumps.len() as f64));
            let motion = motion.outcome;
            add("motion_arrived", Some(f64::from(u8::from(motion.arrived))));
            add("motion_free", Some(f64::from(u8::from(motion.arrived && motion.free))));
            add("motion_time", Some(motion.time));
            add("largest_step", Some(motion.largest_step));
            add("mirrored", Some(motion.mirrored as f64));
            add("drawn", Some(motion.drawn as f64));
        }
        Ok(Some(Run {
            scene: self.on.name(),
            planner: self.arm.planner.to_owned(),
            parameters: self.arm.parameters(),
            until: self.until.name(),
            seed: self.seed,
            feasible: record.feasible,
            solved: record.status == Status::Solved,
            value: record.value,
            cost: record.cost,
            gap: record.gap.filter(|_| record.feasible),
            iterations: record.iterations,
            evaluations: record.evaluations,
            reached: record.reached,
            longest_wait: curve.windows(2).map(|two| two[1] - two[0]).max().unwrap_or(0),
            numbers: numbers.trim_start().to_owned(),
        }))
    }
}

/// How much the joints' velocities change from one leg of a motion to the next, in °/s: of each such moment the largest change of a
/// joint. The rows are those of [`motion::Motion`]: the time comes first, the six joints sixth to eleventh.
fn jumps(rows: &[f64]) -> Vec<f64> {
    const JOINTS: std::ops::Range<usize> = 5..11;
    let rows: Vec<&[f64]> = rows.chunks(motion::ENTRY.columns.len()).collect();
    let legs = rows.windows(2).filter(|two| two[1][0] > two[0][0]);
    let velocities: Vec<Vec<f64>> = legs.map(|two| JOINTS.map(|j| (two[1][j] - two[0][j]) / (two[1][0] - two[0][0])).collect()).collect();
    let largest = |two: &[Vec<f64>]| two[0].iter().zip(&two[1]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    velocities.windows(2).map(largest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One joint turns by 10° in 1 s, then by 30° in 1 s, then stays.
    #[test]
    fn a_jump_is_the_largest_change_of_a_joints_velocity() {
        let row = |time: f64, angle: f64| {
            let mut row = vec![0.0; motion::ENTRY.columns.len()];
            (row[0], row[7]) = (time, angle);
            row
        };
        let rows = [row(0.0, 0.0), row(1.0, 10.0), row(2.0, 40.0), row(4.0, 40.0)].concat();
        assert_eq!(jumps(&rows), [20.0, 30.0]);
        assert_eq!((motion::ENTRY.columns[0].name, motion::ENTRY.columns[5].name, motion::ENTRY.columns[10].name), ("time", "q1", "q6"));
    }
}
