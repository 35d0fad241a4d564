//! `two-opt`: the nearest neighbour's tour, then 2-opt and Or-opt moves until neither helps, [ANTBAT](crate#papers) §3.3.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Group, Reading},
    kernel::{Progress, Readings, State, Status, rng::Stream},
    params::Parameters,
};

use super::{
    local::LocalSearch,
    nearest::nearest_neighbour,
    parameters::{BEST, BUILT, BY_ROAD, FAILED, FOUND, ITERATIONS, KINDS, LAYERS, LENGTH, TOURS},
    planner,
    problem::{Problem, Stop, Tour},
    search::Search,
};

/// A tour that gets shorter move by move.
#[derive(Clone, State)]
struct Descent {
    #[state(shared)]
    problem: Arc<Problem>,
    local: LocalSearch,
    /// As the moves left it, and as it is handed over.
    row: Vec<Stop>,
    best: Tour,
    moves: u64,
    gain: f64,
    done: bool,
    /// What drew where the first tour begins, if that is not fixed.
    rng: Option<Stream>,
}

fn begin(problem: &Arc<Problem>, _: &Parameters, mut rng: Stream) -> Descent {
    let fresh = rng.clone();
    let best = nearest_neighbour(problem, &mut rng);
    let rng = (rng != fresh).then_some(rng);
    let mut local = LocalSearch::new(problem);
    local.load(&best.row);
    local.touch_all();
    Descent { problem: Arc::clone(problem), local, row: best.row.clone(), best, moves: 0, gain: 0.0, done: false, rng }
}

impl Search for Descent {
    fn step(&mut self) {
        let change = self.local.step(&mut self.row).or_else(|| {
            self.local.touch_all();
            self.local.step(&mut self.row)
        });
        if let Some(gain) = change {
            self.moves += 1;
            self.gain = gain;
            self.best.row.copy_from_slice(&self.row);
            self.best.settle(&self.problem);
        } else {
            (self.gain, self.done) = (0.0, true);
        }
    }

    /// A local optimum proves nothing: it is not solved.
    fn progress(&self) -> Progress {
        if self.done { Progress::Done(Status::Exhausted) } else { Progress::Continue }
    }

    fn evaluations(&self) -> u64 {
        1 + self.local.tried()
    }

    fn best(&self) -> Option<&Tour> {
        Some(&self.best)
    }

    fn read(&self, out: &mut Readings) {
        out.push(MOVES_MADE, self.moves as f64);
        out.push(LAST_GAIN, self.gain);
    }
}

const TWO_OPT: Formula = Formula::of_item("two-opt", "Croes 1958", "2-opt move", "\\Delta = d(a, c) + d(b, d) - d(a, b) - d(c, d) < 0", "");

const MOVES_MADE: Reading = Reading::new("moves", "", "Moves", Group::Count, "Moves that made the tour shorter.");
const LAST_GAIN: Reading = Reading::new("gain", "\\Delta D", "Gain", Group::Measure, "How much shorter the last move made it.");

/// See [`planner::start`].
const OWN_READINGS: &[Reading] = &[MOVES_MADE, LAST_GAIN];

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "clusters",
    "Crossings vanish",
    "Each step makes the tour shorter. Another seed ends in another local optimum.",
    "clustered-100",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "begin at a random stop; always go on to the nearest one that is left",
    "repeat until no move makes the tour shorter:",
    "  reverse a stretch (2-opt), or carry one elsewhere (Or-opt)",
    "  moves: @moves@; the last saved @gain@",
    "the tour has length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "two-opt",
    "2-opt and Or-opt",
    "[ANTBAT] §3.3; Bentley 1992",
    "Goes on to the nearest stop, then reverses and carries stretches of the tour, a step for each move that makes it shorter, until none does.",
    |start| Ok(planner::start(start, OWN_READINGS, |problem, settings, rng| Box::new(begin(problem, settings, rng)))?.open_ended()),
)
.family("tour")
.evaluating(crate::tour::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[ITERATIONS.default_to(1000).help("After how many moves it stops at the latest; mostly no move helps before that.").entry()],
    TOURS,
])
.readings(&[BEST, BUILT, FAILED, BY_ROAD, FOUND, MOVES_MADE, LAST_GAIN])
.formulas(&[TWO_OPT, LENGTH])
.layers(LAYERS)
.calls_at_stops()
.cases(CASES)
.pseudocode(PSEUDOCODE);
