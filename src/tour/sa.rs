//! `sa`: simulated annealing with 2-opt moves (Kirkpatrick et al. 1983).
//!
//! One tour is changed again and again. What makes it longer is accepted the more rarely, the longer it becomes and the
//! colder it is. An iteration is one temperature.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Group, Member, Reading, layers},
    kernel::{Inspection, Label, Part, Progress, Readings, State, rng::Stream},
    label, math, message,
    params::{Param, Parameters},
    settled::SETTLED,
};

use super::{
    explain::{quantity, random_start},
    moves,
    parameters::{
        BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, KINDS, LENGTH, MEMBER_DIFFERENT, MEMBER_LENGTH, ROADS_LAYER, TOURS,
    },
    planner,
    problem::{Problem, Tour},
    search::Search,
};

/// How many moves are a part of a step.
const PORTION: usize = 200_000;
/// How many moves say how hot it must be.
const MEASURED: u64 = 100;

/// What happened at the last temperature.
#[derive(Debug, Clone, Copy, Default, State)]
struct LastMove {
    tried: u64,
    /// Accepted because they were not longer, and although they were.
    shorter: u64,
    longer: u64,
    /// The longest step up that was accepted.
    highest: f64,
    /// How much shorter the tour became.
    gain: f64,
}

/// One tour that is annealed, and the shortest that it was.
#[derive(Clone, State)]
struct Annealing {
    #[state(shared)]
    problem: Arc<Problem>,
    now: Tour,
    best: Tour,
    /// Scratch space.
    noted: Tour,
    /// Of the last iteration's moves, and of the next one's.
    temperature: f64,
    next: f64,
    #[state(shared)]
    cooling: f64,
    #[state(shared)]
    moves: usize,
    evaluations: u64,
    last_move: LastMove,
    /// The length before the step that is under way.
    #[state(skip)]
    before: f64,
    #[state(skip)]
    part: Part,
    rng: Stream,
}

fn begin(problem: &Arc<Problem>, settings: &Parameters, mut rng: Stream) -> Annealing {
    let now = moves::random_tour(problem, &mut rng);
    let temperature = first_temperature(problem, &now, settings[ACCEPT_START], &mut rng);
    Annealing {
        problem: Arc::clone(problem),
        best: now.clone(),
        noted: now.clone(),
        temperature,
        next: temperature,
        cooling: settings[COOLING],
        moves: settings[MOVES] as usize * problem.n,
        evaluations: 1 + if now.len() > 1 { MEASURED } else { 0 },
        last_move: LastMove::default(),
        before: now.length,
        part: Part::default(),
        now,
        rng,
    }
}

/// The temperature at which a move that makes this random tour longer by what such moves do on average is accepted with
/// the probability `share`: T₀ = −Δ̄ / ln share (Johnson et al. 1989). 0 if no move makes it longer.
fn first_temperature(problem: &Problem, tour: &Tour, share: f64, rng: &mut Stream) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for _ in 0..if tour.len() > 1 { MEASURED } else { 0 } {
        let (i, j) = moves::two_apart(tour.len(), rng);
        let added = moves::reversal(problem, &tour.row, i, j);
        if added > 0.0 {
            (sum, count) = (sum + added, count + 1.0);
        }
    }
    if count > 0.0 { -sum / count / math::ln(share) } else { 0.0 }
}

impl Annealing {
    /// Notes the present tour if it is the shortest so far. It stays as it stands: a move may be under way.
    fn remember(&mut self) {
        if self.now.length < self.best.length {
            self.noted.copy_from(&self.now);
            self.noted.settle(&self.problem);
            // The sum of differences may have promised what rounding gave.
            if self.noted.length < self.best.length {
                std::mem::swap(&mut self.noted, &mut self.best);
            }
        }
    }

    /// Whether a move that makes the tour longer by so much is accepted, Metropolis et al. 1953.
    fn accepts(&mut self, added: f64) -> bool {
        added <= 0.0 || self.rng.unit() < math::exp(-added / self.temperature)
    }

    /// Tries one random 2-opt move.
    fn attempt(&mut self) {
        let (i, j) = moves::two_apart(self.now.len(), &mut self.rng);
        let added = moves::reversal(&self.problem, &self.now.row, i, j);
        if !self.accepts(added) {
            return;
        }
        if added > 0.0 {
            // Only here a shortest tour can get lost: to note every step down would take time.
            self.remember();
            self.last_move.longer += 1;
            self.last_move.highest = self.last_move.highest.max(added);
        } else {
            self.last_move.shorter += 1;
        }
        moves::reverse(&mut self.now.row, i, j);
        self.now.length += added;
    }
}

impl Search for Annealing {
    fn step(&mut self) {
        if !self.part.is_under_way() {
            self.temperature = self.next;
            self.last_move = LastMove::default();
            self.before = self.now.length;
        }
        let moves = if self.now.len() > 1 { self.moves } else { 0 };
        for _ in self.part.take(PORTION, moves) {
            self.attempt();
            self.last_move.tried += 1;
        }
        if self.part.is_under_way() {
            return;
        }
        self.evaluations += self.last_move.tried;
        self.now.settle(&self.problem);
        self.remember();
        self.last_move.gain = self.before - self.now.length;
        self.next *= self.cooling;
    }

    fn progress(&self) -> Progress {
        self.part.progress()
    }

    fn rng(&mut self) -> Option<&mut Stream> {
        Some(&mut self.rng)
    }

    fn suppositions(&self, _i: usize) -> Vec<Label> {
        Vec::from_iter((self.last_move.longer > 0).then_some(NEVER_LONGER))
    }

    /// As if it were cold already.
    fn suppose(&mut self, _i: usize, _supposition: &str) {
        self.next = 0.0;
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn best(&self) -> Option<&Tour> {
        Some(&self.best)
    }

    fn members(&self) -> usize {
        1
    }

    fn member(&self, i: usize) -> Option<&Tour> {
        (i == 0).then_some(&self.now)
    }

    fn read(&self, out: &mut Readings) {
        let LastMove { tried, shorter, longer, .. } = self.last_move;
        out.push(TEMPERATURE, self.temperature);
        out.push(ACCEPTED, (shorter + longer) as f64 / tried.max(1) as f64);
    }

    fn read_member(&self, _i: usize, out: &mut Vec<f64>) {
        let different = moves::hamming(&self.problem, &self.now.row, &self.best.row);
        out.extend([self.now.length, different as f64, self.last_move.gain, self.last_move.highest]);
    }

    fn explain(&self, _i: usize, inspection: &mut Inspection) {
        let LastMove { tried, shorter, longer, highest, gain } = self.last_move;
        inspection.title = message!("tour-present", "Present tour");
        let (event, summary) = match (tried, shorter + longer) {
            (0, _) => ("start", random_start()),
            (_, 0) => ("frozen", message!("tour-frozen", "None of {tried} moves was accepted.", tried)),
            _ => (
                "annealed",
                message!(
                    "tour-annealed",
                    "Of {tried} moves {shorter} were accepted because they made it no longer, {longer} although they made it longer, by up to {highest:.4}.",
                    tried,
                    shorter,
                    longer,
                    highest
                ),
            ),
        };
        (inspection.event, inspection.summary) = (event, summary);
        let values = [
            quantity(label!("tour-temperature", "temperature", "T", "temperature"), self.temperature),
            quantity(label!("tour-next-temperature", "next", "T'", "the next temperature"), self.next),
            quantity(label!("tour-moves-tried", "tried", "k", "moves tried"), tried as f64),
            quantity(label!("tour-accepted-longer", "longer", "k_+", "accepted although longer"), longer as f64),
            quantity(label!("tour-longest-step-up", "highest", "\\Delta_{\\max}", "longest step up"), highest),
            // What is colder than a number can say has no quotient.
            quantity(
                label!("tour-step-chance", "chance", "P", "chance of such a step"),
                if highest > 0.0 { math::exp(-highest / self.temperature) } else { 1.0 },
            ),
            quantity(label!("tour-shorter-by", "gain", "\\Delta D", "shorter by"), gain),
        ];
        inspection.values.extend(values.into_iter().flatten());
        inspection.formulas = vec!["metropolis", "cooling", "length"];
    }
}

const ACCEPT_START: Param<f64> = Param::number(
    "accept_start",
    "\\chi_0",
    "Accepted at first",
    [0.01, 0.99, 0.8],
    "How hot it begins: a move that makes the first tour longer by what such moves do on average is accepted with this probability. Measured on 100 random moves. [ANTBAT] gives no parameters of its simulated annealing; this is a usual one.",
);
const COOLING: Param<f64> = Param::number(
    "cooling",
    "\\alpha",
    "Cooling",
    [0.01, 1.0, 0.95],
    "What the temperature is multiplied by after each iteration. With more iterations it should be nearer to 1. Ours, like all of this planner’s parameters.",
)
.slider(0.8, 1.0, false);
const MOVES: Param<u64> = Param::integer(
    "moves",
    "k",
    "Moves for each stop",
    [1, 100_000, 20],
    "How many moves are tried at a temperature, for each stop. A move is evaluated by the four distances that it changes, so they are cheap.",
)
.slider(1.0, 1000.0, true);

const NEVER_LONGER: Label = label!("tour-never-longer", "cold", "T = 0", "without accepting longer tours");

const METROPOLIS: Formula = Formula::of_item(
    "metropolis",
    "Metropolis et al. 1953",
    "Chance of a move that makes the tour longer",
    "P = e^{-\\Delta / T}",
    "P = e^{-@highest@ / @temperature@} = @chance@",
);
const GEOMETRIC: Formula =
    Formula::of_item("cooling", "Kirkpatrick et al. 1983", "Cooling", "T \\leftarrow \\alpha T", "T = @temperature@ \\to @next@");

/// What explanations show of the tour.
const MEMBERS: &[Member] = &[
    MEMBER_LENGTH,
    MEMBER_DIFFERENT,
    Member::new("gain", "\\Delta D", "Gain", "How much shorter it became in the last iteration; below zero: longer."),
    Member::new("highest", "\\Delta_{\\max}", "Longest step up", "The most that an accepted move made it longer in the last iteration."),
];

const PRESENT: Reading = Reading::new("mean", "D", "Present", Group::Cost, "The length of the present tour.");
const TEMPERATURE: Reading =
    Reading::new("temperature", "T", "Temperature", Group::Schedule, "How hot it was in this iteration, as a length.");
const ACCEPTED: Reading =
    Reading::new("accepted", "\\chi", "Accepted", Group::Measure, "How many of this iteration’s moves were accepted.");
const SETTLED_PRESENT: Reading = SETTLED.described(
    SETTLED.symbol,
    SETTLED.title,
    "The iteration since which the present tour has stayed within 1 % of the shortest so far.",
);

/// See [`planner::start`].
const OWN_READINGS: &[Reading] = &[PRESENT, DIFFERENT, SETTLED_PRESENT, TEMPERATURE, ACCEPTED];

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "stops",
    "It cools down",
    "Hot, it accepts longer tours; cold, only shorter ones. It ends about one percent above the optimum.",
    "random-52",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "begin with a random tour, and so hot that a usual lengthening is kept with probability @accept_start@",
    "repeat until iteration @iterations@, with $T$ = @temperature@:",
    "  @moves@ times for each stop: turn a random stretch round",
    "    if the tour gets shorter: keep it",
    "    if it gets longer by $\\Delta$: keep it with probability $e^{-\\Delta / T}$",
    "  a share of @accepted@ of the moves was kept",
    "  $T \\leftarrow$ @cooling@ $T$",
    "the shortest tour has length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "sa",
    "Simulated annealing",
    "Kirkpatrick et al. 1983",
    "One tour, parts of which are turned round again and again: what makes it longer is accepted more and more rarely as it grows colder.",
    |start| planner::start(start, OWN_READINGS, |problem, settings, rng| Box::new(begin(problem, settings, rng))),
)
.family("tour")
.evaluating(crate::tour::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[ITERATIONS
        .help("After how many temperatures it stops; building roads comes first. As many as [ANTBAT]’s bats fly iterations.")
        .entry()],
    &[ACCEPT_START.entry(), COOLING.entry(), MOVES.entry()],
    TOURS,
])
.readings(&[BEST, PRESENT, BUILT, FAILED, BY_ROAD, FOUND, SETTLED_PRESENT, DIFFERENT, TEMPERATURE, ACCEPTED])
.formulas(&[METROPOLIS, GEOMETRIC, LENGTH])
.layers(&[
    ROADS_LAYER,
    layers::TOURS.titled("Present tour", "The tour that is changed.").off().pickable(),
    layers::TOUR,
    layers::STOPS,
    layers::DIFFERENT,
    layers::WAY,
    layers::SUPPOSED,
])
.calls_at_stops()
.members(MEMBERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);
