//! `ga`: a genetic algorithm with order crossover (Davis 1985), one of those that [ANTBAT](crate#papers) §4 compares with.
//!
//! A generation follows another: the shortest tours are kept, the others are children of parents that won a tournament.
//! The paper prints neither operators nor parameters; order crossover and inversion are the usual ones for tours.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Group, Member, Reading},
    kernel::{Inspection, Label, Part, Progress, Readings, State, rng::Stream},
    label, math, message,
    params::{Param, Parameters},
    settled::SETTLED,
};

use super::{
    explain::quantity,
    moves,
    parameters::{
        BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, KINDS, LENGTH, MEAN, MEMBER_DIFFERENT, MEMBER_LENGTH, POPULATION,
        TOURS, layers_with,
    },
    planner,
    problem::{Problem, Tour},
    search::{Search, portion},
};

/// How a tour came into its generation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
enum Origin {
    /// Random, in the first generation.
    Start,
    /// It was one of the shortest of the generation before.
    Kept,
    /// Of one parent, unchanged.
    Copy,
    /// Of two parents.
    Crossover,
    /// Of one parent, with a stretch reversed.
    Mutation,
    /// Of two parents, with a stretch reversed.
    Both,
}

/// What made a tour. All places are those of the row before it was turned into the direction that counts.
#[derive(Debug, Clone, Copy, State)]
struct Birth {
    origin: Origin,
    /// Numbers and lengths in the generation before; of one parent, twice the same.
    parents: [usize; 2],
    lengths: [f64; 2],
    /// From where to where it follows its first parent.
    cut: (usize, usize),
    /// From where to where it was reversed then.
    reversed: (usize, usize),
}

#[derive(Debug, Clone, State)]
struct One {
    tour: Tour,
    birth: Birth,
}

impl One {
    /// How much shorter it is than the shorter parent.
    fn gain(&self) -> f64 {
        match self.birth.origin {
            Origin::Start => 0.0,
            _ => self.birth.lengths[0].min(self.birth.lengths[1]) - self.tour.length,
        }
    }
}

/// A generation, and the shortest tour of all generations.
#[derive(Clone, State)]
struct Genetic {
    #[state(shared)]
    problem: Arc<Problem>,
    now: Vec<One>,
    /// The next one while it is made.
    #[state(skip)]
    next: Vec<One>,
    best: Tour,
    #[state(shared)]
    elite: usize,
    #[state(shared)]
    tournament: usize,
    #[state(shared)]
    crossover: f64,
    #[state(shared)]
    mutation: f64,
    evaluations: u64,
    rng: Stream,
    #[state(skip)]
    part: Part,
    /// Which child does what is supposed.
    #[state(skip)]
    without: Option<(usize, &'static str)>,
    /// Scratch space: the generation by length, and a place for each stop.
    #[state(skip)]
    ranks: Vec<(f64, usize)>,
    #[state(skip)]
    places: Vec<u32>,
}

fn begin(problem: &Arc<Problem>, settings: &Parameters, mut rng: Stream) -> Genetic {
    let birth = Birth { origin: Origin::Start, parents: [0; 2], lengths: [f64::NAN; 2], cut: (0, 0), reversed: (0, 0) };
    let size = settings[POPULATION] as usize;
    let now: Vec<_> = (0..size).map(|_| One { tour: moves::random_tour(problem, &mut rng), birth }).collect();
    let best = moves::shortest(now.iter().map(|one| &one.tour)).cloned();
    Genetic {
        problem: Arc::clone(problem),
        best: best.unwrap_or_else(|| Tour::first(problem)),
        next: now.clone(),
        // A child at least is born.
        elite: (settings[ELITE] as usize).min(size - 1),
        tournament: settings[TOURNAMENT] as usize,
        crossover: settings[CROSSOVER],
        mutation: settings[MUTATION],
        evaluations: size as u64,
        rng,
        part: Part::default(),
        without: None,
        ranks: vec![(0.0, 0); size],
        places: vec![0; problem.n + 1],
        now,
    }
}

impl Genetic {
    /// The shortest tours of this generation are the first of the next.
    fn keep(&mut self) {
        for (rank, (i, one)) in self.ranks.iter_mut().zip(self.now.iter().enumerate()) {
            *rank = (one.tour.length, i);
        }
        math::sort(&mut self.ranks);
        for (heir, &(length, i)) in self.next.iter_mut().zip(&self.ranks[..self.elite]) {
            heir.tour.copy_from(&self.now[i].tour);
            heir.birth = Birth { origin: Origin::Kept, parents: [i; 2], lengths: [length; 2], cut: (0, 0), reversed: (0, 0) };
        }
    }

    /// The shortest of a few that are drawn.
    fn select(&mut self) -> usize {
        let mut winner = self.rng.below(self.now.len());
        for _ in 1..self.tournament {
            let other = self.rng.below(self.now.len());
            if self.now[other].tour.length < self.now[winner].tour.length {
                winner = other;
            }
        }
        winner
    }

    /// A child of the tournaments' winners: number `i` of the next generation.
    fn breed(&mut self, i: usize) {
        let m = self.best.len();
        let first = self.select();
        let rate = |of: Label, is: f64| if self.without == Some((i, of.name)) { 0.0 } else { is };
        let (crossover, mutation) = (rate(WITHOUT_CROSSOVER, self.crossover), rate(WITHOUT_MUTATION, self.mutation));
        let crossed = m > 1 && self.rng.unit() < crossover;
        let second = if crossed { self.select() } else { first };
        let child = &mut self.next[i];
        let (cut, reversed);
        child.tour.copy_from(&self.now[first].tour);
        if crossed {
            cut = moves::two_places(m, &mut self.rng);
            moves::ox(&mut child.tour.row, &self.now[second].tour.row, cut, &mut self.places);
        } else {
            cut = (0, 0);
        }
        let mutated = m > 1 && self.rng.unit() < mutation;
        if mutated {
            reversed = moves::two_apart(m, &mut self.rng);
            moves::reverse(&mut child.tour.row, reversed.0, reversed.1);
        } else {
            reversed = (0, 0);
        }
        child.tour.settle(&self.problem);
        self.evaluations += 1;
        let origin = match (crossed, mutated) {
            (false, false) => Origin::Copy,
            (true, false) => Origin::Crossover,
            (false, true) => Origin::Mutation,
            (true, true) => Origin::Both,
        };
        let parents = [first, second];
        child.birth = Birth { origin, parents, lengths: parents.map(|parent| self.now[parent].tour.length), cut, reversed };
        if child.tour.length < self.best.length {
            self.best.copy_from(&child.tour);
        }
    }
}

impl Search for Genetic {
    fn step(&mut self) {
        if !self.part.is_under_way() {
            self.keep();
        }
        for i in self.part.take(portion(5 * self.problem.n + 2 * self.tournament), self.now.len() - self.elite) {
            self.breed(self.elite + i);
        }
        if !self.part.is_under_way() {
            std::mem::swap(&mut self.now, &mut self.next);
        }
    }

    fn progress(&self) -> Progress {
        self.part.progress()
    }

    fn rng(&mut self) -> Option<&mut Stream> {
        Some(&mut self.rng)
    }

    fn suppositions(&self, i: usize) -> Vec<Label> {
        let origin = self.now[i].birth.origin;
        let crossed = matches!(origin, Origin::Crossover | Origin::Both).then_some(WITHOUT_CROSSOVER);
        crossed.into_iter().chain(matches!(origin, Origin::Mutation | Origin::Both).then_some(WITHOUT_MUTATION)).collect()
    }

    fn suppose(&mut self, i: usize, supposition: &str) {
        self.without = [WITHOUT_CROSSOVER, WITHOUT_MUTATION].iter().map(|label| (i, label.name)).find(|it| it.1 == supposition);
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn best(&self) -> Option<&Tour> {
        Some(&self.best)
    }

    fn members(&self) -> usize {
        self.now.len()
    }

    fn member(&self, i: usize) -> Option<&Tour> {
        self.now.get(i).map(|one| &one.tour)
    }

    fn read(&self, out: &mut Readings) {
        let children = &self.now[self.elite..];
        let shorter = children.iter().filter(|one| one.gain() > 0.0).count();
        out.push(SHORTER, shorter as f64 / children.len() as f64);
    }

    fn read_member(&self, i: usize, out: &mut Vec<f64>) {
        let one = &self.now[i];
        let different = moves::hamming(&self.problem, &one.tour.row, &self.best.row);
        out.extend([one.tour.length, different as f64, f64::from(one.birth.origin as u8), one.gain()]);
    }

    fn explain(&self, i: usize, inspection: &mut Inspection) {
        let one = &self.now[i];
        let Birth { origin, parents: [a, b], lengths, cut, reversed } = one.birth;
        inspection.event = WORDS[origin as usize];
        inspection.summary = match origin {
            Origin::Start => message!("tour-ga-start", "It is one of the random tours of the first generation."),
            Origin::Kept => message!("tour-ga-kept", "It was tour {a} of the generation before; the shortest are kept.", a = a + 1),
            Origin::Copy | Origin::Mutation => {
                message!("tour-ga-copy", "A child of tour {a} alone, which won a tournament.", a = a + 1)
            }
            Origin::Crossover | Origin::Both => message!(
                "tour-ga-crossover",
                "A child of the tours {a} and {b}, which won a tournament each: places {from} to {to} from the first, the others in the order of the second.",
                a = a + 1,
                b = b + 1,
                from = cut.0,
                to = cut.1
            ),
        };
        if reversed.1 > 0 {
            let (from, to) = reversed;
            let mutation = message!("tour-ga-mutation", "Then a mutation reversed places {from} to {to}.", from, to);
            inspection.summary = std::mem::take(&mut inspection.summary).then(mutation);
        }
        if origin == Origin::Start {
            return;
        }
        let values = [
            quantity(label!("tour-first-parent-length", "first", "D_a", "length of the first parent"), lengths[0]),
            quantity(label!("tour-second-parent-length", "second", "D_b", "length of the second parent"), lengths[1]),
            quantity(label!("tour-child-gain", "gain", "\\Delta D", "shorter than the shorter parent by"), one.gain()),
        ];
        inspection.values.extend(values.into_iter().flatten());
        inspection.formulas = vec!["gain", "length"];
    }
}

/// What can be supposed of a birth.
const WITHOUT_CROSSOVER: Label = label!("tour-without-crossover", "crossover", "p_c = 0", "without crossover");
const WITHOUT_MUTATION: Label = label!("tour-without-mutation", "mutation", "p_m = 0", "without mutation");

const TOURNAMENT: Param<u64> = Param::integer(
    "tournament",
    "k",
    "Tournament",
    [1, 1000, 3],
    "How many tours are drawn for the shortest of them to be a parent. 1: any tour may be one. [ANTBAT] gives no parameters of its genetic algorithm; this is a usual one.",
)
.slider(1.0, 20.0, false);
const ELITE: Param<u64> = Param::integer(
    "elite",
    "e",
    "Kept",
    [0, 100_000, 1],
    "How many of the shortest tours go on unchanged; one child at least is born. Ours, like all of this planner’s parameters.",
)
.slider(0.0, 20.0, false);
const CROSSOVER: Param<f64> = Param::number(
    "crossover",
    "p_c",
    "Crossover rate",
    [0.0, 1.0, 0.9],
    "How many of the children have two parents: a stretch of the first, the other stops in the order of the second.",
);
const MUTATION: Param<f64> =
    Param::number("mutation", "p_m", "Mutation rate", [0.0, 1.0, 0.2], "How many of the children then have a random stretch reversed.");

const GAIN: Formula = Formula::of_item(
    "gain",
    "Davis 1985",
    "What a child gained",
    "\\Delta D = \\min(D_a, D_b) - \\class{way}{D}",
    "\\Delta D = \\min(@first@, @second@) - \\class{way}{@length@} = @gain@",
);

const WORDS: &[&str] = &["start", "kept", "copy", "crossover", "mutation", "both"];

/// What explanations show of each tour.
const MEMBERS: &[Member] = &[
    MEMBER_LENGTH,
    MEMBER_DIFFERENT,
    Member::new("operator", "", "Operator", "How it came into this generation.").words(WORDS),
    Member::new("gain", "\\Delta D", "Gain", "How much shorter it is than the shorter of its parents; below zero: longer."),
];

const SHORTER: Reading =
    Reading::new("shorter", "", "Shorter children", Group::Measure, "How many of the children are shorter than both their parents.");

/// See [`planner::start`].
const OWN_READINGS: &[Reading] = &[MEAN, DIFFERENT, SETTLED, SHORTER];

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "stops",
    "Crossover and mutation",
    "Without local search a hundred generations end far above the optimum.",
    "random-52",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ members holds a tour",
    "repeat until generation @iterations@:",
    "  the @elite@ best are kept",
    "  for each other place: two parents win tournaments of @tournament@",
    "    with probability @crossover@ they cross over",
    "    with probability @mutation@ the child is mutated",
    "  a share of @shorter@ of the children is shorter than both parents",
    "  the shortest tour has length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "ga",
    "Genetic algorithm",
    "Davis 1985",
    "Generations of tours: children take a stretch of one parent and the order of the other, some have a stretch reversed, and the shortest are kept.",
    |start| {
        // Two generations.
        planner::check_members(start, 2)?;
        planner::start(start, OWN_READINGS, |problem, settings, rng| Box::new(begin(problem, settings, rng)))
    },
)
.family("tour")
.evaluating(crate::tour::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[
        POPULATION.title("Tours")
            .help("How many tours a generation has. As many as [ANTBAT] has bats; it says nothing of its genetic algorithm.")
            .entry(),
        ITERATIONS.help("After how many generations it stops; building roads comes first. As many as [ANTBAT]’s bats fly.").entry(),
    ],
    &[TOURNAMENT.entry(), ELITE.entry(), CROSSOVER.entry(), MUTATION.entry()],
    TOURS,
])
.readings(&[BEST, MEAN, BUILT, FAILED, BY_ROAD, FOUND, SETTLED, DIFFERENT, SHORTER])
.formulas(&[GAIN, LENGTH])
.layers(&layers_with("The tours of this generation."))
.calls_at_stops()
.members(MEMBERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);
