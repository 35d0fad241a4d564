//! `bat`: discrete bats, [ANTBAT](crate#papers) §3.3.
//!
//! Readings: what a bat finds by (12) becomes its tour always, as the text says (`replace`); the best tour that it crosses
//! with is taken in the direction in which its distance was counted; a tour around the best is *better* if it is shorter than
//! the bat's own; the first stop of a closed tour, which every tour is turned to begin with, is not the one that is moved there.

mod explain;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Member, Preset, Reading},
    kernel::{Inspection, Label, Part, Progress, Readings, State, rng::Stream},
    math,
    params::{Choice, Fixed, Param, Parameter, Parameters},
    settled::SETTLED,
};

use super::{
    explain::WITHOUT_BEST,
    kicks::Kicks,
    moves,
    nearest::nearest_neighbour,
    parameters::{
        BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, KINDS, LENGTH, LOCAL_SEARCH, MEAN, MEAN_LOUDNESS, MEAN_PULSE_RATE,
        MEMBER_DIFFERENT, MEMBER_LENGTH, POPULATION, TOURS, layers_with,
    },
    planner,
    problem::{Problem, Stop, Tour},
    search::{Search, portion},
};

/// How a bat looked for a better tour of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
enum Range {
    /// It has not flown yet.
    None,
    /// Far from the best: partially matched crossover with it.
    Far,
    /// Near the best: 2-opt moves.
    Near,
}

/// What it did around the best tour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
enum Local {
    /// Its pulse rate kept it from looking there.
    Passed,
    /// It tried an insertion and did not take it.
    Tried,
    /// It took it.
    Taken,
}

/// What a bat did in the last iteration.
#[derive(Debug, Clone, Copy, State)]
struct LastMove {
    range: Range,
    /// The distance to the best before, and how many tries it drew.
    hamming: usize,
    tries: usize,
    /// How much shorter its own tour became by them.
    gain: f64,
    local: Local,
    /// The length of the tour that it tried around the best.
    candidate: f64,
    /// How much shorter its tour became by taking it.
    local_gain: f64,
}

#[derive(Debug, Clone, State)]
struct Bat {
    tour: Tour,
    loudness: f64,
    pulse_rate: f64,
    last_move: LastMove,
}

/// Bats and the best of their tours.
#[derive(Clone, State)]
struct Bats {
    #[state(shared)]
    problem: Arc<Problem>,
    /// They enter one after another, in the first parts of the search.
    swarm: Vec<Bat>,
    #[state(shared)]
    population: usize,
    best: Tour,
    /// ε and λ.
    #[state(shared)]
    epsilon: f64,
    #[state(shared)]
    lambda: f64,
    t: u64,
    evaluations: u64,
    rng: Stream,
    #[state(skip)]
    part: Part,
    /// Who does not know the best, where that is supposed.
    #[state(skip)]
    alone: Option<usize>,
    /// Scratch space: a child and the best child, a place for each stop.
    #[state(skip)]
    child: Tour,
    #[state(skip)]
    kept: Tour,
    #[state(skip)]
    places: Vec<u32>,
    /// The best tour's row, forwards or backwards.
    #[state(skip)]
    mate: Vec<Stop>,
    /// A bat takes what it found even if that is longer than its own tour.
    #[state(shared)]
    always: bool,
    /// What improves tours, if something does.
    local: Option<Kicks>,
    /// Beyond the paper: it also perturbs the best tour.
    #[state(shared)]
    polish: bool,
}

fn begin(problem: &Arc<Problem>, settings: &Parameters, rng: Stream) -> Bats {
    let first = Tour::first(problem);
    let (polish, population) = (settings[POLISH], settings[POPULATION] as usize);
    let mut bats = Bats {
        problem: Arc::clone(problem),
        best: first.clone(),
        evaluations: 0,
        swarm: Vec::with_capacity(population),
        population,
        epsilon: settings[EPSILON],
        lambda: settings[LAMBDA],
        t: 0,
        rng,
        part: Part::default(),
        alone: None,
        child: first.clone(),
        mate: first.row.clone(),
        kept: first,
        places: vec![0; problem.n + 1],
        always: settings[REPLACES_ALWAYS],
        local: (polish || settings[LOCAL_SEARCH]).then(|| Kicks::new(problem)),
        polish,
    };
    bats.enter();
    bats
}

impl Bats {
    /// The next bats with their first tours.
    fn enter(&mut self) {
        let last_move =
            LastMove { range: Range::None, hamming: 0, tries: 0, gain: 0.0, local: Local::Passed, candidate: f64::NAN, local_gain: 0.0 };
        let first = if self.polish { nearest_neighbour } else { moves::random_tour };
        for _ in 0..Part::at_most(self.portion()).min(self.population - self.swarm.len()) {
            let mut tour = first(&self.problem, &mut self.rng);
            if let Some(kicks) = &mut self.local {
                kicks.polish(&mut tour);
            }
            if self.swarm.is_empty() || tour.length < self.best.length {
                self.best.copy_from(&tour);
            }
            self.evaluations += 1;
            // Reading: a loudness of 1 would never accept.
            self.swarm.push(Bat { tour, loudness: self.rng.between(0.5, 1.0), pulse_rate: self.rng.unit(), last_move });
        }
    }

    /// Far from the best: `tries` times partially matched crossover with it, the best child is kept.
    fn cross(&mut self, i: usize, tries: usize, backwards: bool) {
        let (own, m) = (&self.swarm[i].tour, self.child.len());
        self.kept.length = f64::INFINITY;
        // In the direction in which their distance was counted.
        self.mate.copy_from_slice(&self.best.row);
        if backwards {
            self.mate[1..=m].reverse();
        }
        for _ in 0..tries {
            self.child.row.copy_from_slice(&own.row);
            let cut = moves::two_places(m, &mut self.rng);
            moves::pmx(&mut self.child.row, &self.mate, cut, &mut self.places);
            self.child.length = self.problem.length(&self.child.row);
            if self.child.length < self.kept.length {
                std::mem::swap(&mut self.child, &mut self.kept);
            }
        }
    }

    /// Near the best: `tries` random 2-opt moves, the best result is kept.
    fn turn(&mut self, i: usize, tries: usize) {
        let (own, m) = (&self.swarm[i].tour, self.child.len());
        let (mut least, mut chosen) = (f64::INFINITY, (1, 1));
        for _ in 0..tries {
            let (a, b) = moves::two_apart(m, &mut self.rng);
            let added = moves::reversal(&self.problem, &own.row, a, b);
            if added < least {
                (least, chosen) = (added, (a, b));
            }
        }
        self.kept.row.copy_from_slice(&own.row);
        moves::reverse(&mut self.kept.row, chosen.0, chosen.1);
    }

    /// Moves bat `i`, [ANTBAT](crate#papers) §3.3.
    fn fly(&mut self, i: usize) {
        let m = self.child.len();
        if m < 2 {
            return; // there is one tour only
        }
        let (hamming, backwards) = moves::nearer(&self.problem, &self.swarm[i].tour.row, &self.best.row);
        let tries = 1 + self.rng.below(hamming.max(1)); // (12)
        let alone = self.alone == Some(i);
        let range = if 2 * hamming >= self.problem.n && !alone { Range::Far } else { Range::Near };
        match range {
            Range::Far => self.cross(i, tries, backwards),
            _ => self.turn(i, tries),
        }
        self.kept.settle(&self.problem);
        self.evaluations += tries as u64;
        if let Some(kicks) = &mut self.local {
            kicks.polish(&mut self.kept);
        }
        let bat = &mut self.swarm[i];
        let mut last_move = LastMove { range, hamming, tries, gain: 0.0, local: Local::Passed, candidate: f64::NAN, local_gain: 0.0 };
        if self.always || self.kept.length < bat.tour.length {
            last_move.gain = bat.tour.length - self.kept.length;
            bat.tour.copy_from(&self.kept);
        }
        if self.rng.unit() > bat.pulse_rate && !alone {
            self.look_around(i, &mut last_move);
        }
        let bat = &mut self.swarm[i];
        bat.last_move = last_move;
        if bat.tour.length < self.best.length {
            self.best.copy_from(&bat.tour);
        }
    }

    /// Around the best: a stop moves to just behind another. A bat that is quiet enough takes what is shorter than its own.
    fn look_around(&mut self, i: usize, last_move: &mut LastMove) {
        let (from, to) = moves::stop_elsewhere(self.child.len(), &mut self.rng);
        let candidate = match self.local.as_mut().filter(|_| self.polish) {
            None => self.best.length + moves::insertion(&self.problem, &self.best.row, from, to),
            // Beyond the paper: stretches of it are swapped and repaired.
            Some(kicks) => {
                self.kept.copy_from(&self.best);
                kicks.improve(&mut self.kept, self.problem.n, &mut self.rng);
                self.kept.length
            }
        };
        self.evaluations += u64::from(!self.polish);
        (last_move.local, last_move.candidate) = (Local::Tried, candidate);
        let bat = &mut self.swarm[i];
        let accepts = self.rng.unit() > bat.loudness;
        // What polish found shorter than the best is not thrown away for a loud bat.
        let found = self.polish && candidate < self.best.length;
        if !(found || accepts && candidate < bat.tour.length) {
            return;
        }
        if !self.polish {
            self.kept.row.copy_from_slice(&self.best.row);
            moves::insert(&mut self.kept.row, from, to);
            self.kept.settle(&self.problem);
        }
        // A sum of differences may have promised what rounding gave.
        if self.kept.length < bat.tour.length {
            last_move.local = Local::Taken;
            last_move.local_gain = bat.tour.length - self.kept.length;
            bat.tour.copy_from(&self.kept);
            bat.loudness *= self.epsilon; // (10)
            bat.pulse_rate *= 1.0 - math::exp(-self.lambda * self.t as f64); // (11)
        }
    }

    /// How many bats are a part of a step: crossovers at half of the places, and what improves a tour.
    fn portion(&self) -> usize {
        let (n, improves) = (self.problem.n, if self.local.is_some() { 100 } else { 0 });
        portion(n * (n / 4 + improves))
    }

    fn mean(&self, of: impl Fn(&Bat) -> f64) -> f64 {
        self.swarm.iter().map(of).sum::<f64>() / self.swarm.len() as f64
    }
}

impl Search for Bats {
    fn step(&mut self) {
        if self.swarm.len() < self.population {
            self.enter();
            return;
        }
        self.t += u64::from(!self.part.is_under_way());
        for i in self.part.take(self.portion(), self.swarm.len()) {
            self.fly(i);
        }
    }

    fn progress(&self) -> Progress {
        if self.swarm.len() < self.population { Progress::Partly } else { self.part.progress() }
    }

    fn rng(&mut self) -> Option<&mut Stream> {
        Some(&mut self.rng)
    }

    fn suppositions(&self, i: usize) -> Vec<Label> {
        let LastMove { range, local, .. } = self.swarm[i].last_move;
        Vec::from_iter((range == Range::Far || local != Local::Passed).then_some(WITHOUT_BEST))
    }

    fn suppose(&mut self, i: usize, _supposition: &str) {
        self.alone = Some(i);
    }

    fn evaluations(&self) -> u64 {
        self.evaluations + self.local.as_ref().map_or(0, Kicks::tried)
    }

    fn best(&self) -> Option<&Tour> {
        Some(&self.best)
    }

    fn members(&self) -> usize {
        self.swarm.len()
    }

    fn member(&self, i: usize) -> Option<&Tour> {
        self.swarm.get(i).map(|bat| &bat.tour)
    }

    fn read(&self, out: &mut Readings) {
        out.push(MEAN_LOUDNESS, self.mean(|bat| bat.loudness));
        out.push(MEAN_PULSE_RATE, self.mean(|bat| bat.pulse_rate));
    }

    fn read_member(&self, i: usize, out: &mut Vec<f64>) {
        let Bat { tour, loudness, pulse_rate, last_move } = &self.swarm[i];
        let different = moves::hamming(&self.problem, &tour.row, &self.best.row);
        out.extend([
            tour.length,
            *loudness,
            *pulse_rate,
            different as f64,
            f64::from(last_move.range as u8),
            last_move.gain + last_move.local_gain,
        ]);
    }

    fn explain(&self, i: usize, inspection: &mut Inspection) {
        self.tell(i, inspection);
    }
}

const EPSILON: Param<f64> = Param::number(
    "epsilon",
    "\\varepsilon",
    "Fading of loudness",
    [0.0, 1.0, 0.98],
    "What a bat’s loudness is multiplied by when it accepts a tour around the best. Published: 0.98.",
);
const LAMBDA: Param<f64> = Param::number(
    "lambda",
    "\\lambda",
    "Pulse coefficient",
    [0.0, 100.0, 0.98],
    "How fast the factor 1 − e^(−λt) that a pulse rate is multiplied by comes to 1. Published: 0.98.",
)
.slider(0.0, 2.0, false);

const REPLACES_ALWAYS: Param<bool> = Param::choice(
    "replace",
    "",
    "Replacement",
    &[
        Choice::new("always", "Always", "As published: also when it is longer than the bat’s own tour."),
        Choice::new("better", "If shorter", "A bat’s tour never gets longer."),
    ],
    &[true, false],
    "When the best result of a bat’s crossovers or 2-opt moves becomes its tour.",
);
const POLISH: Param<bool> = Param::flag(
    "polish",
    "Polish",
    false,
    "Beyond the paper: bats begin with the nearest neighbour’s tour, improve every tour by local search, and around the best tour they swap stretches and repair, as often as there are stops.",
);

/// [ANTBAT](crate#papers) (10).
const LOUDNESS: Formula = Formula::of_item("loudness", "[ANTBAT] (10)", "Loudness", "A_i \\leftarrow \\varepsilon A_i", "A = @loudness@");
/// [ANTBAT](crate#papers) (11).
const PULSE: Formula =
    Formula::of_item("pulse", "[ANTBAT] (11)", "Pulse rate", "r_i \\leftarrow r_i \\left(1 - e^{-\\lambda t}\\right)", "r = @pulse_rate@");
const TRIES: Formula = Formula::of_item(
    "tries",
    "[ANTBAT] (12)",
    "Velocity: how many tries",
    "v_i = \\operatorname{rand}\\left[1, \\max(1, \\class{different}{HD})\\right]",
    "v = @tries@ \\in \\left[1, \\max(1, \\class{different}{@hamming@})\\right]",
);

/// What explanations show of each bat.
const MEMBERS: &[Member] = &[
    MEMBER_LENGTH,
    Member::new("loudness", "A", "Loudness", "The louder, the rarer it accepts a tour around the best.").full(1.0),
    Member::new("pulse_rate", "r", "Pulse rate", "The higher, the rarer it looks around the best tour.").full(1.0),
    MEMBER_DIFFERENT,
    Member::new("operator", "", "Operator", "How it looked for a better tour of its own in the last iteration.")
        .words(&["start", "PMX", "2-opt"]),
    Member::new("gain", "\\Delta D", "Gain", "How much shorter its tour became in the last iteration; below zero: longer."),
];

/// See [`planner::start`].
const OWN_READINGS: &[Reading] = &[MEAN, DIFFERENT, SETTLED, MEAN_LOUDNESS, MEAN_PULSE_RATE];

const PAPER: Preset = Preset::new(
    "paper",
    "As in the paper",
    "[ANTBAT] has no local search: bats cross over, try 2-opt moves, and move a stop of the best tour.",
    "ant-bat-30",
    &[("local_search", Fixed::Text("none"))],
);

const OWN: &[Parameter] = &[
    POPULATION.title("Bats").help("How many bats search. Published: 50.").entry(),
    ITERATIONS
        .help("After how many iterations of the bats it stops; building roads comes first. Published: 100, for 12 stops. Without local search more stops need more.")
        .entry(),
    EPSILON.entry(),
    LAMBDA.entry(),
    REPLACES_ALWAYS.entry(),
    LOCAL_SEARCH.when(POLISH, "false").entry(),
    POLISH.entry(),
];

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "stops",
    "280 stops",
    "Each bat’s tour is improved by 2-opt. The best ends within 0.2 % of the optimum.",
    "random-280",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ bats holds a tour",
    "repeat until iteration @iterations@:",
    "  for each bat:",
    "    far from the best tour it crosses over with it; close to it, it tries 2-opt moves",
    "    the tour found is improved by local search, where that is chosen",
    "    near the best it accepts what is shorter, the rarer the louder it is (on average @loudness@)",
    "    then it gets quieter, and its pulse rate (on average @pulse_rate@) falls",
    "  a tour differs from the shortest at @different@ places, on average",
    "  the shortest tour has length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "bat",
    "Discrete bats",
    "[ANTBAT] §3.3",
    "Each bat holds a tour. Far from the best tour it crosses over with it (PMX); close to it, it tries 2-opt moves; loudness decides whether it accepts a tour found near the best.",
    |start| {
        planner::check_members(start, 1)?;
        planner::start(start, OWN_READINGS, |problem, settings, rng| Box::new(begin(problem, settings, rng)))
    },
)
.family("tour")
.evaluating(crate::tour::EVALUATION)
.kinds(KINDS)
.parameters(&[OWN, TOURS])
.readings(&[BEST, MEAN, BUILT, FAILED, BY_ROAD, FOUND, SETTLED, DIFFERENT, MEAN_LOUDNESS, MEAN_PULSE_RATE])
.formulas(&[TRIES, LOUDNESS, PULSE, LENGTH])
.layers(&layers_with("The tour of every bat."))
.calls_at_stops()
.members(MEMBERS)
.presets(&[PAPER])
.cases(CASES)
.pseudocode(PSEUDOCODE);
