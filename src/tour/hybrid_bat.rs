//! `hybrid-bat`: a bat with perturbation local search, what [ANTBAT](crate#papers) §4 compares with as its reference 25.
//!
//! All that [ANTBAT](crate#papers) says of it is "a hybrid bat algorithm that looks for the best neighbourhood by perturbation"
//! (Worasan et al. 2022, whose problem, vehicles with cross-docking, is another). So this is a reading of ours, with
//! nothing that the paper's own bats add:
//!
//! - A bat flies by (7) to (9), with orders as positions: the difference from the best is a list of swaps, and of these it
//!   makes a share, its frequency.
//! - When its pulse lets it, it looks around the best tour instead: a few perturbations, each of a kind drawn by lot
//!   (a stretch reversed, a stop moved, two stretches exchanged); the shortest is its candidate.
//! - A candidate that is shorter than its own tour it accepts with its loudness as the probability; then it becomes
//!   quieter, and its pulse rate rises (Yang 2010). A tour that is shorter than the best becomes the best either way, as
//!   in Yang's own programme.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Member, Reading},
    kernel::{Inspection, Label, Message, Part, Progress, Readings, State, rng::Stream},
    label, math, message,
    params::{Param, Parameters},
    settled::SETTLED,
};

use super::{
    explain::{WITHOUT_BEST, quantity, random_start},
    moves,
    parameters::{
        BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, KINDS, LENGTH, MEAN, MEAN_LOUDNESS, MEAN_PULSE_RATE, MEMBER_DIFFERENT,
        MEMBER_LENGTH, POPULATION, TOURS, layers_with,
    },
    planner,
    problem::{Problem, Tour},
    search::{Search, portion},
    swaps::{self, Swap},
};

/// How a bat's candidate was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
enum Operator {
    /// There was none yet.
    None,
    /// Its own tour with swaps towards the best.
    Flight,
    /// The best tour with a stretch reversed,
    Reversal,
    /// with a stop moved,
    Insertion,
    /// with two stretches exchanged.
    Bridge,
}

/// What it did in the last iteration.
#[derive(Debug, Clone, Copy, State)]
struct LastMove {
    operator: Operator,
    /// The frequency of its flight, the swaps that led to the best, and how many of them it made.
    frequency: f64,
    distance: usize,
    swaps: usize,
    candidate: f64,
    accepted: bool,
    /// How much shorter its tour became.
    gain: f64,
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
    swarm: Vec<Bat>,
    best: Tour,
    #[state(shared)]
    frequencies: [f64; 2],
    #[state(shared)]
    perturbations: u64,
    #[state(shared)]
    alpha: f64,
    #[state(shared)]
    gamma: f64,
    #[state(shared)]
    r0: f64,
    t: u64,
    evaluations: u64,
    rng: Stream,
    #[state(skip)]
    part: Part,
    /// Who looks around its own tour, where that is supposed.
    #[state(skip)]
    alone: Option<usize>,
    /// Scratch space: a candidate, swaps, and a place for each stop.
    #[state(skip)]
    candidate: Tour,
    #[state(skip)]
    list: Vec<Swap>,
    #[state(skip)]
    places: Vec<u32>,
}

fn begin(problem: &Arc<Problem>, settings: &Parameters, mut rng: Stream) -> Bats {
    let first = Tour::first(problem);
    let last_move =
        LastMove { operator: Operator::None, frequency: 0.0, distance: 0, swaps: 0, candidate: f64::NAN, accepted: false, gain: 0.0 };
    let loudness = settings[LOUDNESS_START];
    let swarm: Vec<_> = (0..settings[POPULATION])
        .map(|_| Bat { tour: moves::random_tour(problem, &mut rng), loudness, pulse_rate: 0.0, last_move })
        .collect();
    let [low, high] = [settings[F_MIN], settings[F_MAX]];
    Bats {
        problem: Arc::clone(problem),
        best: moves::shortest(swarm.iter().map(|bat| &bat.tour)).unwrap_or(&first).clone(),
        frequencies: [low, high.max(low)],
        perturbations: settings[PERTURBATIONS],
        alpha: settings[ALPHA],
        gamma: settings[GAMMA],
        r0: settings[PULSE_RATE],
        t: 0,
        evaluations: swarm.len() as u64,
        swarm,
        rng,
        part: Part::default(),
        alone: None,
        list: Vec::with_capacity(first.len()),
        candidate: first,
        places: vec![0; problem.n + 1],
    }
}

impl Bats {
    /// A flight towards the best: the candidate is the bat's own tour after a share of the swaps that lead there.
    fn fly(&mut self, i: usize) -> LastMove {
        let own = &self.swarm[i].tour;
        let frequency = self.rng.between(self.frequencies[0], self.frequencies[1]); // (7)
        self.list.clear();
        self.candidate.row.copy_from_slice(&own.row);
        let (_, backwards) = moves::nearer(&self.problem, &own.row, &self.best.row);
        swaps::difference(&mut self.candidate.row, &self.best.row, backwards, &mut self.places, &mut self.list);
        let distance = self.list.len();
        swaps::thin(&mut self.list, 0, frequency, &mut self.rng); // (8)
        self.candidate.row.copy_from_slice(&own.row);
        swaps::apply(&mut self.candidate.row, &self.list); // (9)
        self.evaluations += 1;
        let swaps = self.list.len();
        LastMove { operator: Operator::Flight, frequency, distance, swaps, candidate: f64::NAN, accepted: false, gain: 0.0 }
    }

    /// Around the best: the candidate is the shortest of a few perturbations.
    fn perturb(&mut self, i: usize) -> LastMove {
        let around = if self.alone == Some(i) { &self.swarm[i].tour } else { &self.best };
        let (m, row) = (around.len(), &around.row);
        let (mut operator, mut least, mut at) = (Operator::Reversal, f64::INFINITY, [1, 1, 1]);
        for _ in 0..self.perturbations {
            let (kind, places, added) = match self.rng.below(3) {
                0 => {
                    let (a, b) = moves::two_apart(m, &mut self.rng);
                    (Operator::Reversal, [a, b, 0], moves::reversal(&self.problem, row, a, b))
                }
                1 => {
                    let (from, to) = moves::stop_elsewhere(m, &mut self.rng);
                    (Operator::Insertion, [from, to, 0], moves::insertion(&self.problem, row, from, to))
                }
                _ => {
                    let places = moves::two_stretches(m, &mut self.rng);
                    (Operator::Bridge, places, moves::double_bridge(&self.problem, row, places))
                }
            };
            if added < least {
                (operator, least, at) = (kind, added, places);
            }
        }
        self.candidate.row.copy_from_slice(row);
        match operator {
            Operator::Insertion => moves::insert(&mut self.candidate.row, at[0], at[1]),
            Operator::Bridge => moves::bridge(&mut self.candidate.row, at),
            _ => moves::reverse(&mut self.candidate.row, at[0], at[1]),
        }
        self.evaluations += self.perturbations;
        LastMove { operator, frequency: 0.0, distance: 0, swaps: 0, candidate: f64::NAN, accepted: false, gain: 0.0 }
    }

    /// Moves bat `i`.
    fn call(&mut self, i: usize) {
        if self.best.len() < 2 {
            return; // there is one tour only
        }
        let mut last_move = if self.rng.unit() > self.swarm[i].pulse_rate { self.perturb(i) } else { self.fly(i) };
        self.candidate.settle(&self.problem);
        last_move.candidate = self.candidate.length;
        let bat = &mut self.swarm[i];
        if self.candidate.length < bat.tour.length && self.rng.unit() < bat.loudness {
            last_move.accepted = true;
            last_move.gain = bat.tour.length - self.candidate.length;
            bat.tour.copy_from(&self.candidate);
            bat.loudness *= self.alpha;
            bat.pulse_rate = self.r0 * (1.0 - math::exp(-self.gamma * self.t as f64));
        }
        bat.last_move = last_move;
        if self.candidate.length < self.best.length {
            self.best.copy_from(&self.candidate);
        }
    }

    fn mean(&self, of: impl Fn(&Bat) -> f64) -> f64 {
        self.swarm.iter().map(of).sum::<f64>() / self.swarm.len() as f64
    }
}

impl Search for Bats {
    fn step(&mut self) {
        self.t += u64::from(!self.part.is_under_way());
        for i in self.part.take(portion(5 * (self.problem.n + self.perturbations as usize)), self.swarm.len()) {
            self.call(i);
        }
    }

    fn progress(&self) -> Progress {
        self.part.progress()
    }

    fn rng(&mut self) -> Option<&mut Stream> {
        Some(&mut self.rng)
    }

    fn suppositions(&self, i: usize) -> Vec<Label> {
        let around = !matches!(self.swarm[i].last_move.operator, Operator::None | Operator::Flight);
        Vec::from_iter(around.then_some(WITHOUT_BEST))
    }

    fn suppose(&mut self, i: usize, _supposition: &str) {
        self.alone = Some(i);
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
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
        out.extend([tour.length, *loudness, *pulse_rate, different as f64, f64::from(last_move.operator as u8), last_move.gain]);
    }

    fn explain(&self, i: usize, inspection: &mut Inspection) {
        let Bat { loudness, pulse_rate, last_move, .. } = &self.swarm[i];
        let LastMove { operator, frequency, distance, swaps, candidate, accepted, gain } = *last_move;
        inspection.title = message!("tour-bat", "Bat {i}", i = i + 1);
        inspection.event = WORDS[operator as usize];
        let n = self.perturbations;
        inspection.summary = match operator {
            Operator::None => random_start(),
            Operator::Flight => {
                message!("tour-flight", "It flew towards the best tour: {swaps} of the {distance} swaps that lead there.", swaps, distance)
            }
            _ if self.alone == Some(i) => message!("tour-around-own", "It would look around its own tour."),
            Operator::Reversal => message!(
                "tour-reversal",
                "It looked around the best tour; the shortest of {n} perturbations was one with a stretch reversed.",
                n
            ),
            Operator::Insertion => message!(
                "tour-insertion",
                "It looked around the best tour; the shortest of {n} perturbations was one with a stop moved.",
                n
            ),
            Operator::Bridge => message!(
                "tour-exchange",
                "It looked around the best tour; the shortest of {n} perturbations was one with two stretches exchanged.",
                n
            ),
        };
        let taken = match (operator, accepted) {
            (Operator::None, _) => Message::default(),
            (_, true) => {
                message!("tour-candidate-taken", "It took that tour: quieter now, and it looks around the best more rarely.")
            }
            (_, false) => message!("tour-candidate-dropped", "It kept its own tour."),
        };
        inspection.summary = std::mem::take(&mut inspection.summary).then(taken);
        let values = [
            quantity(label!("tour-candidate", "candidate", "D'", "tour that it tried"), candidate),
            quantity(label!("tour-candidate-gain", "gain", "\\Delta D", "gained by taking it"), gain),
            quantity(label!("tour-loudness", "loudness", "A", "loudness"), *loudness),
            quantity(label!("tour-pulse-rate", "pulse_rate", "r", "pulse rate"), *pulse_rate),
        ];
        inspection.values.extend(values.into_iter().flatten());
        inspection.formulas = vec!["loudness", "pulse", "length"];
        if operator == Operator::Flight {
            let flight = [
                quantity(label!("tour-frequency", "frequency", "f", "frequency"), frequency),
                quantity(label!("tour-swaps-to-the-best", "distance", "|x^* \\ominus x|", "swaps to the best"), distance as f64),
                quantity(label!("tour-swaps-made", "swaps", "|v|", "swaps that it made"), swaps as f64),
            ];
            inspection.values.extend(flight.into_iter().flatten());
            inspection.formulas.insert(0, "velocity");
        }
    }
}

const F_MIN: Param<f64> = Param::number(
    "f_min",
    "f_{\\min}",
    "Least frequency",
    [0.0, 1.0, 0.0],
    "Of a flight: the least share of the swaps towards the best that it makes. A reading of ours, like all of this planner’s parameters: [ANTBAT] gives none of its [25].",
);
const F_MAX: Param<f64> = Param::number(
    "f_max",
    "f_{\\max}",
    "Greatest frequency",
    [0.0, 1.0, 1.0],
    "The greatest share; not below the least. 1: a flight can end at the best.",
);
const PERTURBATIONS: Param<u64> = Param::integer(
    "perturbations",
    "k",
    "Perturbations",
    [1, 100_000, 3],
    "How many changes of the best tour are tried when a bat looks around it; the shortest is its candidate. With 3 it evaluates about as many tours as [ANTBAT]’s bats do.",
)
.slider(1.0, 100.0, true);
const LOUDNESS_START: Param<f64> =
    Param::number("a0", "A_0", "Loudness at first", [0.0, 1.0, 1.0], "With what probability it accepts a shorter tour at first.");
const ALPHA: Param<f64> = Param::number(
    "alpha",
    "\\alpha",
    "Fading of loudness",
    [0.0, 1.0, 0.9],
    "What a bat’s loudness is multiplied by when it accepts a tour. Yang 2010: 0.9.",
);
const PULSE_RATE: Param<f64> = Param::number(
    "r0",
    "r_0",
    "Pulse rate in the end",
    [0.0, 1.0, 0.5],
    "What a bat’s pulse rate rises to: the probability that it flies instead of looking around the best tour.",
);
const GAMMA: Param<f64> =
    Param::number("gamma", "\\gamma", "Pulse coefficient", [0.0, 100.0, 0.9], "How fast pulse rates rise. Yang 2010: 0.9.")
        .slider(0.0, 2.0, false);

const VELOCITY: Formula = Formula::of_item(
    "velocity",
    "[ANTBAT] (7)–(9)",
    "Flight: swaps towards the best",
    "v_i = f_i \\, \\class{different}{(x^* \\ominus x_i)}, \\quad f_i = f_{\\min} + (f_{\\max} - f_{\\min}) \\beta, \\quad \\class{way}{x_i'} = x_i \\oplus v_i",
    "f = @frequency@, \\quad |v| = @swaps@ \\text{ of } \\class{different}{@distance@}",
);
const LOUDNESS: Formula = Formula::of_item("loudness", "Yang 2010", "Loudness", "A_i \\leftarrow \\alpha A_i", "A = @loudness@");
const PULSE: Formula =
    Formula::of_item("pulse", "Yang 2010", "Pulse rate", "r_i \\leftarrow r_0 \\left(1 - e^{-\\gamma t}\\right)", "r = @pulse_rate@");

const WORDS: &[&str] = &["start", "flight", "reversal", "insertion", "exchange"];

/// What explanations show of each bat.
const MEMBERS: &[Member] = &[
    MEMBER_LENGTH,
    Member::new("loudness", "A", "Loudness", "The louder, the likelier it accepts a shorter tour.").full(1.0),
    Member::new("pulse_rate", "r", "Pulse rate", "The higher, the rarer it looks around the best tour.").full(1.0),
    MEMBER_DIFFERENT,
    Member::new("operator", "", "Operator", "How it made the tour that it tried in the last iteration.").words(WORDS),
    Member::new("gain", "\\Delta D", "Gain", "How much shorter its tour became in the last iteration."),
];

/// See [`planner::start`].
const OWN_READINGS: &[Reading] = &[MEAN, DIFFERENT, SETTLED, MEAN_LOUDNESS, MEAN_PULSE_RATE];

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "stops",
    "Perturbed tours",
    "Bats swap stops toward the best tour or perturb it; the end is some percent above the optimum.",
    "random-52",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ bats holds a tour",
    "repeat until iteration @iterations@:",
    "  for each bat:",
    "    it makes a share of the swaps that lead toward the best tour",
    "    or takes the best of @perturbations@ perturbations of the best tour",
    "    it accepts with its loudness (on average @loudness@) as probability",
    "  a tour differs from the shortest at @different@ places, on average",
    "  the shortest tour has length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "hybrid-bat",
    "Bats with perturbation",
    "[ANTBAT] §4, its [25]",
    "Bats that hold a tour each: they swap stops towards the best one, or take the best of a few perturbations of it.",
    |start| {
        planner::check_members(start, 1)?;
        planner::start(start, OWN_READINGS, |problem, settings, rng| Box::new(begin(problem, settings, rng)))
    },
)
.family("tour")
.evaluating(crate::tour::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[
        POPULATION.title("Bats").help("How many bats search. As many as [ANTBAT] has.").entry(),
        ITERATIONS
            .help("After how many iterations of the bats it stops; building roads comes first. As many as [ANTBAT]’s bats fly.")
            .entry(),
    ],
    &[F_MIN.entry(), F_MAX.entry(), PERTURBATIONS.entry(), LOUDNESS_START.entry(), ALPHA.entry(), PULSE_RATE.entry(), GAMMA.entry()],
    TOURS,
])
.readings(&[BEST, MEAN, BUILT, FAILED, BY_ROAD, FOUND, SETTLED, DIFFERENT, MEAN_LOUDNESS, MEAN_PULSE_RATE])
.formulas(&[VELOCITY, LOUDNESS, PULSE, LENGTH])
.layers(&layers_with("The tour of every bat."))
.calls_at_stops()
.members(MEMBERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);
