//! `tour-pso`: particle swarms on orders, by swap sequences (Wang et al. 2003; Clerc 2004).
//!
//! The swarm's two equations with other signs: a position is an order, a velocity is a list of swaps, the difference of
//! two orders is the list that leads from one to the other, a number times a list keeps each swap with that probability,
//! and ⊕ puts lists behind each other or carries them out.
//!
//! Swaps alone end far above the optimum on many stops, so swarms on orders have a local search besides (Shi et al. 2007):
//! here 2-opt and Or-opt moves after each move of a particle. The velocity stays what the swaps were.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Group, Member, Preset, Reading},
    kernel::{Inspection, Label, Part, Progress, Readings, State, rng::Stream},
    label, message,
    params::{Fixed, Param, Parameters},
    settled::SETTLED,
};

use super::{
    explain::{WITHOUT_BEST, quantity},
    local::LocalSearch,
    moves,
    parameters::{
        BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, KINDS, LENGTH, LOCAL_SEARCH, MEAN, MEMBER_DIFFERENT, MEMBER_LENGTH,
        POPULATION, TOURS, layers_with,
    },
    planner,
    problem::{Problem, Stop, Tour},
    search::{Search, portion},
    swaps::{self, Swap},
};

/// What a particle did in the last iteration.
#[derive(Debug, Clone, Copy, Default, State)]
struct LastMove {
    /// How many swaps it kept of its velocity, took towards its own best and towards the swarm's.
    kept: usize,
    own: usize,
    swarm: usize,
    /// How much shorter its tour became.
    gain: f64,
    /// It is the shortest that this particle had.
    record: bool,
}

#[derive(Debug, Clone, State)]
struct Particle {
    tour: Tour,
    best: Tour,
    velocity: Vec<Swap>,
    last_move: LastMove,
}

/// Particles and the best of their tours.
#[derive(Clone, State)]
struct Swarm {
    #[state(shared)]
    problem: Arc<Problem>,
    /// They enter one after another, in the first parts of the search.
    particles: Vec<Particle>,
    #[state(shared)]
    population: usize,
    best: Tour,
    #[state(shared)]
    w: f64,
    #[state(shared)]
    c1: f64,
    #[state(shared)]
    c2: f64,
    evaluations: u64,
    rng: Stream,
    #[state(skip)]
    part: Part,
    /// What improves tours, if something does.
    local: Option<LocalSearch>,
    /// Who does what is supposed.
    #[state(skip)]
    without: Option<(usize, &'static str)>,
    /// Scratch space: a row, a list of swaps, and a place for each stop.
    #[state(skip)]
    row: Vec<Stop>,
    #[state(skip)]
    list: Vec<Swap>,
    #[state(skip)]
    places: Vec<u32>,
}

fn begin(problem: &Arc<Problem>, settings: &Parameters, rng: Stream) -> Swarm {
    let first = Tour::first(problem);
    let m = first.len();
    let population = settings[POPULATION] as usize;
    let mut swarm = Swarm {
        problem: Arc::clone(problem),
        best: first.clone(),
        w: settings[W],
        c1: settings[C1],
        c2: settings[C2],
        evaluations: 0,
        particles: Vec::with_capacity(population),
        population,
        rng,
        part: Part::default(),
        without: None,
        row: first.row,
        list: Vec::with_capacity(3 * m),
        places: vec![0; problem.n + 1],
        local: (settings[LOCAL_SEARCH]).then(|| LocalSearch::new(problem)),
    };
    swarm.enter();
    swarm
}

impl Swarm {
    /// How many particles are a part of a step.
    fn portion(&self) -> usize {
        let improves = if self.local.is_some() { 50 } else { 0 };
        portion(self.problem.n * (10 + improves))
    }

    /// The next particles with their first tours.
    fn enter(&mut self) {
        for _ in 0..Part::at_most(self.portion()).min(self.population - self.particles.len()) {
            let mut tour = moves::random_tour(&self.problem, &mut self.rng);
            if let Some(local) = &mut self.local {
                local.polish(&mut tour);
            }
            if self.particles.is_empty() || tour.length < self.best.length {
                self.best.copy_from(&tour);
            }
            self.evaluations += 1;
            let velocity = Vec::with_capacity(tour.len());
            self.particles.push(Particle { best: tour.clone(), tour, velocity, last_move: LastMove::default() });
        }
    }

    /// Adds `share` · (`to` ⊖ tour `i`) to the list: how many swaps those are.
    fn draw_towards(&mut self, i: usize, own: bool, share: f64) -> usize {
        let before = self.list.len();
        let particle = &self.particles[i];
        let to = if own { &particle.best.row } else { &self.best.row };
        // Of a tour that is the same backwards, the direction that is nearer.
        let (_, backwards) = moves::nearer(&self.problem, &particle.tour.row, to);
        self.row.copy_from_slice(&particle.tour.row);
        swaps::difference(&mut self.row, to, backwards, &mut self.places, &mut self.list);
        swaps::thin(&mut self.list, before, share, &mut self.rng);
        self.list.len() - before
    }

    /// Moves particle `i`.
    fn fly(&mut self, i: usize) {
        let m = self.best.len();
        if m < 2 {
            return; // there is one tour only
        }
        // v ← w v ⊕ c₁ r₁ (p ⊖ x) ⊕ c₂ r₂ (g ⊖ x)
        self.list.clear();
        self.list.extend_from_slice(&self.particles[i].velocity);
        let share = |of: Label, is: f64| if self.without == Some((i, of.name)) { 0.0 } else { is };
        let (w, c1, c2) = (share(WITHOUT_VELOCITY, self.w), share(WITHOUT_OWN_BEST, self.c1), share(WITHOUT_BEST, self.c2));
        swaps::thin(&mut self.list, 0, w, &mut self.rng);
        let kept = self.list.len();
        let (r1, r2) = (self.rng.unit(), self.rng.unit());
        let own = self.draw_towards(i, true, c1 * r1);
        let swarm = self.draw_towards(i, false, c2 * r2);

        // x ← x ⊕ v, and v becomes the basic sequence that does the same: it has fewer swaps than there are stops.
        let particle = &mut self.particles[i];
        let length = particle.tour.length;
        self.row.copy_from_slice(&particle.tour.row);
        swaps::apply(&mut particle.tour.row, &self.list);
        particle.velocity.clear();
        swaps::difference(&mut self.row, &particle.tour.row, false, &mut self.places, &mut particle.velocity);
        let front = particle.tour.row[1];
        particle.tour.settle(&self.problem);
        if particle.tour.row[1] != front {
            swaps::mirror(&mut particle.velocity, m); // the row was turned, so its velocity is
        }
        if let Some(local) = &mut self.local {
            local.polish(&mut particle.tour);
        }
        self.evaluations += 1;

        let record = particle.tour.length < particle.best.length;
        if record {
            particle.best.copy_from(&particle.tour);
        }
        particle.last_move = LastMove { kept, own, swarm, gain: length - particle.tour.length, record };
        if particle.tour.length < self.best.length {
            self.best.copy_from(&particle.tour);
        }
    }
}

impl Search for Swarm {
    fn step(&mut self) {
        if self.particles.len() < self.population {
            self.enter();
            return;
        }
        for i in self.part.take(self.portion(), self.particles.len()) {
            self.fly(i);
        }
    }

    fn progress(&self) -> Progress {
        if self.particles.len() < self.population { Progress::Partly } else { self.part.progress() }
    }

    fn rng(&mut self) -> Option<&mut Stream> {
        Some(&mut self.rng)
    }

    fn suppositions(&self, i: usize) -> Vec<Label> {
        let LastMove { kept, own, swarm, .. } = self.particles[i].last_move;
        let shares = [(WITHOUT_VELOCITY, kept), (WITHOUT_OWN_BEST, own), (WITHOUT_BEST, swarm)];
        shares.into_iter().filter(|&(_, swaps)| swaps > 0).map(|(label, _)| label).collect()
    }

    fn suppose(&mut self, i: usize, supposition: &str) {
        self.without =
            [WITHOUT_VELOCITY, WITHOUT_OWN_BEST, WITHOUT_BEST].iter().map(|label| (i, label.name)).find(|it| it.1 == supposition);
    }

    fn evaluations(&self) -> u64 {
        self.evaluations + self.local.as_ref().map_or(0, LocalSearch::tried)
    }

    fn best(&self) -> Option<&Tour> {
        Some(&self.best)
    }

    fn members(&self) -> usize {
        self.particles.len()
    }

    fn member(&self, i: usize) -> Option<&Tour> {
        self.particles.get(i).map(|particle| &particle.tour)
    }

    fn read(&self, out: &mut Readings) {
        let swaps: usize = self.particles.iter().map(|particle| particle.velocity.len()).sum();
        out.push(MEAN_SWAPS, swaps as f64 / self.particles.len() as f64);
    }

    fn read_member(&self, i: usize, out: &mut Vec<f64>) {
        let Particle { tour, best, velocity, last_move } = &self.particles[i];
        let different = moves::hamming(&self.problem, &tour.row, &self.best.row);
        out.extend([tour.length, best.length, different as f64, velocity.len() as f64, last_move.gain]);
    }

    fn explain(&self, i: usize, inspection: &mut Inspection) {
        let Particle { best, velocity, last_move, .. } = &self.particles[i];
        inspection.title = message!("tour-particle", "Particle {i}", i = i + 1);
        let LastMove { kept, own, swarm, gain, record } = *last_move;
        let (event, summary) = if kept + own + swarm == 0 {
            ("rests", message!("tour-rests", "It made no swap: it begins, or nothing drew it anywhere."))
        } else {
            let n = kept + own + swarm;
            let swaps = message!(
                "tour-swaps",
                "{n} {swaps}: {kept} of its velocity, {own} towards its own best, {swarm} towards the swarm’s.",
                n,
                swaps = n => "swap" | "swaps",
                kept,
                own,
                swarm
            );
            let by = gain.abs();
            let became = if record {
                message!("tour-became-record", "Its tour became {by:.4} shorter: the shortest that it had.", by)
            } else if by < 5e-5 {
                message!("tour-as-long", "Its tour is as long as before.")
            } else if gain > 0.0 {
                message!("tour-became-shorter", "Its tour became {by:.4} shorter.", by)
            } else {
                message!("tour-became-longer", "Its tour became {by:.4} longer.", by)
            };
            (if record { "record" } else { "swaps" }, swaps.then(became))
        };
        (inspection.event, inspection.summary) = (event, summary);
        let values = [
            quantity(label!("tour-own-best", "own_best", "D_p", "its own best"), best.length),
            quantity(label!("tour-velocity-swaps", "kept", "w v", "swaps of its velocity"), kept as f64),
            quantity(label!("tour-own-best-swaps", "own", "p \\ominus x", "swaps towards its own best"), own as f64),
            quantity(label!("tour-swarm-swaps", "swarm", "g \\ominus x", "swaps towards the swarm’s"), swarm as f64),
            quantity(label!("tour-velocity", "velocity", "|v|", "velocity: swaps that do the same"), velocity.len() as f64),
        ];
        inspection.values.extend(values.into_iter().flatten());
        inspection.formulas = vec!["velocity", "position", "length"];
    }
}

/// What can be supposed of a flight.
const WITHOUT_VELOCITY: Label = label!("tour-without-velocity", "inertia", "w = 0", "without its velocity");
const WITHOUT_OWN_BEST: Label = label!("tour-without-own-best", "own", "c_1 = 0", "without its own best");

const W: Param<f64> = Param::number(
    "w",
    "w",
    "Inertia",
    [0.0, 1.0, 0.6],
    "With what probability each swap of a velocity is kept. Wang et al. keep all: 1. [ANTBAT] gives no parameters of its swarm; these lie on the best plateau that we found for its twelve stops, so its result there is a favourable one.",
);
const C1: Param<f64> = Param::number(
    "c1",
    "c_1",
    "Towards its own best",
    [0.0, 4.0, 2.0],
    "With what probability, times a random number from 0 to 1, a particle makes each swap towards its own best. Wang et al.: 1.",
)
.slider(0.0, 2.0, false);
const C2: Param<f64> = Param::number(
    "c2",
    "c_2",
    "Towards the swarm’s best",
    [0.0, 4.0, 0.3],
    "With what probability, times a random number from 0 to 1, a particle makes each swap towards the swarm’s best. Wang et al.: 1, with which the particles soon are all alike.",
)
.slider(0.0, 2.0, false);

const VELOCITY: Formula = Formula::of_item(
    "velocity",
    "Wang et al. 2003",
    "Velocity: a list of swaps",
    "v \\leftarrow w\\,v \\oplus c_1 r_1 (p \\ominus x) \\oplus c_2 r_2 \\class{different}{(g \\ominus x)}",
    "|v| \\le @kept@ + @own@ + \\class{different}{@swarm@}",
);
const POSITION: Formula =
    Formula::of_item("position", "Wang et al. 2003", "Position: an order", "\\class{way}{x} \\leftarrow x \\oplus v", "|v| = @velocity@");

/// What explanations show of each particle.
const MEMBERS: &[Member] = &[
    MEMBER_LENGTH,
    Member::new("own_best", "D_p", "Own best", "The length of the shortest tour that it had."),
    MEMBER_DIFFERENT,
    Member::new("swaps", "|v|", "Velocity", "How many swaps its velocity has."),
    Member::new("gain", "\\Delta D", "Gain", "How much shorter its tour became in the last iteration; below zero: longer."),
];

const MEAN_SWAPS: Reading =
    Reading::new("swaps", "\\overline{|v|}", "Velocity", Group::Measure, "How many swaps a velocity has, on average.");

/// See [`planner::start`].
const OWN_READINGS: &[Reading] = &[MEAN, DIFFERENT, SETTLED, MEAN_SWAPS];

const SWAPS_ALONE: Preset = Preset::new(
    "paper",
    "Swaps alone",
    "Swap sequences without local search: what [ANTBAT] compares with, as read here.",
    "ant-bat-30",
    &[("local_search", Fixed::Text("none"))],
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "swaps",
    "A swarm of swaps",
    "A velocity is a list of swaps. Without local search it stays far above the optimum.",
    "random-52",
    &[("local_search", Fixed::Text("none"))],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ particles holds a tour $x$ and a list of swaps $v$",
    "repeat until iteration @iterations@:",
    "  for each particle:",
    "    it keeps each swap of $v$ with probability $w$ = @w@",
    "    it adds swaps toward its own best and the swarm’s, with $c_1$ = @c1@, $c_2$ = @c2@",
    "    it makes them: @swaps@ swaps, on average",
    "    the tour is improved by local search, where that is chosen",
    "  the shortest tour has length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "tour-pso",
    "Particle swarm with swaps",
    "Wang et al. 2003",
    "Each particle holds a tour and swaps stops: some of the swaps of its velocity, some toward its personal best, some toward the global best. A local search improves each tour.",
    |start| {
        // A list of swaps, of two numbers each, is as large as two tours.
        planner::check_members(start, 4)?;
        planner::start(start, OWN_READINGS, |problem, settings, rng| Box::new(begin(problem, settings, rng)))
    },
)
.family("tour")
.evaluating(crate::tour::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[
        POPULATION.title("Particles")
            .help("How many particles search. As many as [ANTBAT] has bats; it says nothing of its swarm.")
            .entry(),
        ITERATIONS
            .help("After how many iterations of the swarm it stops; building roads comes first. As many as [ANTBAT]’s bats fly.")
            .entry(),
    ],
    &[W.entry(), C1.entry(), C2.entry(), LOCAL_SEARCH.entry()],
    TOURS,
])
.readings(&[BEST, MEAN, BUILT, FAILED, BY_ROAD, FOUND, SETTLED, DIFFERENT, MEAN_SWAPS])
.formulas(&[VELOCITY, POSITION, LENGTH])
.layers(&layers_with("The tour of every particle."))
.calls_at_stops()
.members(MEMBERS)
.presets(&[SWAPS_ALONE])
.cases(CASES)
.pseudocode(PSEUDOCODE);
