//! A planner that tries paths with one corner, and does one thing wrong or nothing.

use std::sync::{
    Arc,
    atomic::{AtomicU64, Ordering},
};

use forage::{
    Error, Frame, Scene, Status,
    describe::{Entry, Group, Layer, Look, Member, Reading, Start, layers},
    geometry,
    kernel::{
        Candidate, Digest, Explain, Facets, Inspection, Item, LayerKey, Members, Message, Part, Planner, Progress, Readings, Shape,
        Solution, Started, State, rng::Stream,
    },
    label, message,
    params::{Param, Parameter},
    scene::DISCS,
};

/// What a planner does wrong, the check that finds it, and a part of the remedy.
macro_rules! wrongs {
    ($($wrong:ident $check:literal $remedy:literal)*) => {
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        #[repr(u8)]
        pub enum Wrong { Nothing, $($wrong),* }
        pub use Wrong::*;

        const WRONGS: &[Wrong] = &[Nothing, $($wrong),*];
        /// A planner with each fault.
        pub static FAULTS: &[(Wrong, &Entry, &str, &str)] = &[$(($wrong, &entry(start::<{ $wrong as u8 }>), $check, $remedy)),*];
    };
}

wrongs! {
    Counts "the_same_setup_gives_the_same_bits" "`Stream` made from `start.seed`"
    DependsOnParts "the_same_setup_gives_the_same_bits" "Let a step in parts do what the whole step does"
    HidesStream "only_random_runs_depend_on_their_seed" "Keep the `Stream` in the state"
    HidesState "the_hash_sees_the_state" "`#[state(skip)]` is for scratch memory"
    LosesField "rewinding_is_exact" "a clone of it goes on alike"
    LosesSize "the_hash_sees_the_state" "Derive `State`"
    Rises "results_only_get_better" "replace it only by one with a lower cost"
    TakesBack "results_only_get_better" "Count every evaluation"
    EmptyPath "results_are_what_they_are_said_to_be" "the scene's start first and its goal last"
    OtherEnd "results_are_what_they_are_said_to_be" "the scene's start first and its goal last"
    Position "results_are_what_they_are_said_to_be" "a solution of the scene's kind"
    ThroughDiscs "results_are_what_they_are_said_to_be" "only if the best solution is feasible"
    IgnoresLimit "runs_end_as_they_say" "Use the value of `iterations` as the limit"
    NeverEnds "runs_end_as_they_say" "never return `Progress::Done(Status::Running)`"
    EndsEarly "runs_end_as_they_say" "`Started::open_ended`"
    Unlisted "layers_are_those_of_the_entry" "list `LayerKey(\"…\")`"
    NotANumber "layers_are_those_of_the_entry" "finite coordinates"
    ShortLine "layers_are_those_of_the_entry" "two vertices or more"
    OtherReading "readings_are_those_of_the_entry" "Push every reading that the entry lists, and no other"
    NoReading "readings_are_those_of_the_entry" "Push every reading that the entry lists, and no other"
    ChangesReadings "parameters_run_at_both_ends" "Push the same readings in the same order"
    InfiniteReading "parameters_run_at_both_ends" "finite for every value that the entry allows"
    UnlistedParameter "parameters_run_at_both_ends" "List every parameter that is read"
    PanicsAtLeast "parameters_run_at_both_ends" "let no step panic"
    PanicsInStart "parameters_run_at_both_ends" "let no step panic"
    RefusesMost "parameters_run_at_both_ends" "narrow the parameters"
    OneNumber "members_and_events_are_those_of_the_entry" "one finite number for each of the entry's `members`"
    NoExplanation "what_can_be_picked_is_explained" "list the facet"
    ExplainsBeyond "what_can_be_picked_is_explained" "`None` beyond"
    OtherFormula "what_can_be_picked_is_explained" "Name formulas that the entry lists"
}

/// A number of steps, which a copy may lose.
#[derive(Debug, State)]
struct Steps {
    taken: u64,
    lost: bool,
}

impl Clone for Steps {
    fn clone(&self) -> Self {
        Self { taken: if self.lost { 0 } else { self.taken }, ..*self }
    }
}

/// Numbers whose size is not counted.
#[derive(Debug, Clone)]
struct Weightless(Vec<f64>);

impl State for Weightless {
    fn digest(&self, out: &mut Digest) {
        self.0.digest(out);
    }
    fn heap_size(&self) -> usize {
        0
    }
}

/// What a planner remembers.
#[derive(Debug, Clone, Default, State)]
struct Memory {
    evaluations: u64,
    /// The corner that was tried last.
    tried: [f64; 2],
    best: Option<(f64, Vec<[f64; 2]>)>,
}

/// Tries paths with one corner, drawn at random.
#[derive(Clone, State)]
struct OneCorner {
    #[state(shared)]
    wrong: Wrong,
    #[state(shared)]
    scene: Arc<Scene>,
    #[state(shared)]
    tries: u64,
    memory: Memory,
    #[state(skip)]
    hidden: Memory,
    rng: Option<Stream>,
    #[state(skip)]
    hidden_rng: Option<Stream>,
    steps: Steps,
    weightless: Weightless,
    #[state(skip)]
    part: Part,
}

pub const ITERATIONS: Param<u64> = Param::integer("iterations", "", "Iterations", [1, 100_000, 50], "After how many steps it stops.");
pub const TRIES: Param<u64> = Param::integer("tries", "", "Tries", [1, 1000, 5], "How many corners a step tries.");
pub const SPEED: Param<f64> = Param::number("speed", "", "Speed", [0.0, 1.0, 0.5], "Not listed.");
pub const BEST: Reading = Reading::new("best", "L", "Best", Group::Cost, "The length of the shortest path.");
pub const TRIED: Reading = Reading::new("tried", "", "Tried", Group::Count, "How many corners were tried.");
pub const OTHER: Reading = Reading::new("other", "", "Other", Group::Count, "Not listed.");
pub const CORNER: Layer = Layer::new(LayerKey("corner"), "Corner", "The corner that was tried last.", &Look::PLAIN).pickable();
pub const STEPS: Member = Member::new("steps", "", "Steps", "How many steps it took.");
pub const TRIES_OF_IT: Member = Member::new("tries", "", "Tries", "How many corners it tried.");

pub const STEPS_LEFT: Member = Member::new("left", "", "Left", "How many steps are left.");

static COUNTER: AtomicU64 = AtomicU64::new(0);

impl OneCorner {
    fn memory(&self) -> &Memory {
        if self.wrong == HidesState { &self.hidden } else { &self.memory }
    }

    fn try_corner(&mut self) {
        let plane = self.scene.plane().unwrap();
        let (bounds, (start, goal)) = (plane.bounds(), plane.ends().unwrap());
        let rng = if self.wrong == HidesStream { &mut self.hidden_rng } else { &mut self.rng };
        let mut corner = [0, 1].map(|axis| rng.as_mut().unwrap().between(bounds.min[axis], bounds.max[axis]));
        if self.wrong == Counts {
            corner[0] += COUNTER.fetch_add(1, Ordering::Relaxed) as f64 * 1e-6;
        }
        let path = vec![start, corner, goal];
        let through = self.wrong == ThroughDiscs || path.windows(2).all(|w| plane.is_free(w[0], w[1]));
        let length = geometry::length(&path);
        let memory = if self.wrong == HidesState { &mut self.hidden } else { &mut self.memory };
        memory.evaluations += 1;
        memory.tried = corner;
        if through && (self.wrong == Rises || memory.best.as_ref().is_none_or(|(least, _)| length < *least)) {
            memory.best = Some((length, path));
        }
    }
}

impl Planner for OneCorner {
    fn advance(&mut self) -> Progress {
        self.part.take(1000, self.tries as usize).for_each(|_| self.try_corner());
        if self.part.is_under_way() {
            if self.wrong == DependsOnParts {
                self.rng.as_mut().unwrap().unit();
            }
            return Progress::Partly;
        }
        // Else the hash would see it.
        self.steps.taken += u64::from(self.wrong != HidesState);
        match self.wrong {
            ThroughDiscs if self.steps.taken > 3 => Progress::Done(Status::Solved),
            EndsEarly if self.steps.taken > 3 => Progress::Done(Status::Exhausted),
            NeverEnds => Progress::Done(Status::Running),
            _ => Progress::Continue,
        }
    }

    fn evaluations(&self) -> u64 {
        let evaluations = self.memory().evaluations;
        if self.wrong == TakesBack { 1_000_000 - evaluations } else { evaluations }
    }

    fn best(&self) -> Option<Candidate> {
        let (cost, mut path) = self.memory().best.clone()?;
        let solution = match self.wrong {
            EmptyPath => Solution::Path(Vec::new()),
            Position => Solution::Position(vec![0.0]),
            OtherEnd => {
                path[2][0] -= 0.5;
                Solution::Path(path)
            }
            _ => Solution::Path(path),
        };
        Some(Candidate { cost, solution })
    }

    fn read(&self, out: &mut Readings) {
        let best = self.memory().best.as_ref().map_or(f64::NAN, |best| best.0);
        out.push(BEST, if self.wrong == InfiniteReading { 1.0 / 0.0 } else { best });
        if self.wrong == ChangesReadings && self.steps.taken > 2 {
            out.push(OTHER, 1.0);
        }
        match self.wrong {
            NoReading => {}
            OtherReading => out.push(OTHER, 1.0),
            LosesField => out.push(TRIED, self.steps.taken as f64),
            _ => out.push(TRIED, self.memory().evaluations as f64),
        }
    }

    fn draw(&self, frame: &mut Frame) {
        let memory = self.memory();
        if let Some((_, path)) = &memory.best {
            frame.begin(layers::BEST.key, Shape::Polyline);
            let corners = if self.wrong == ShortLine { 1 } else { path.len() };
            path[..corners].iter().for_each(|&corner| frame.push(corner, 0.0));
        }
        frame.begin(if self.wrong == Unlisted { LayerKey("unlisted") } else { CORNER.key }, Shape::Points);
        frame.push(if self.wrong == NotANumber { [f64::NAN; 2] } else { memory.tried }, 0.0);
    }

    fn facets(&self) -> Facets<'_> {
        let facets = Facets::default().members(self);
        if self.wrong == NoExplanation { facets } else { facets.explain(self) }
    }
}

impl Members for OneCorner {
    fn members(&self, out: &mut Vec<f64>) {
        out.push(self.memory().evaluations as f64);
        if self.wrong != OneNumber {
            out.push(1.0);
        }
    }
}

impl Explain for OneCorner {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        if item.layer != CORNER.key || (item.index > 0 && self.wrong != ExplainsBeyond) {
            return None;
        }
        let mut inspection =
            Inspection::new(item, message!("corner", "Corner"), "tried", message!("corner-drawn", "It was drawn at random."));
        inspection.values = vec![label!("corner-x", "x", "x", "Coordinate").is(self.memory().tried[0])];
        inspection.formulas = if self.wrong == OtherFormula { vec!["other"] } else { Vec::new() };
        Some(inspection)
    }
}

/// Starts a planner with the fault of this number.
pub fn start<const WRONG: u8>(start: &Start) -> Result<Started, Error> {
    let wrong = WRONGS[WRONG as usize];
    let settings = start.parameters;
    let tries = settings[TRIES];
    match wrong {
        RefusesMost if tries == 1000 => return Err(Error::refused("tries", tries, Message::verbatim("fewer"))),
        PanicsInStart => panic!("no scene today"),
        PanicsAtLeast => assert!(tries > 1, "too few tries"),
        UnlistedParameter => {
            let _ = settings[SPEED];
        }
        _ => {}
    }
    let rng = Stream::new(start.seed, 0);
    let (rng, hidden_rng) = if wrong == HidesStream { (None, Some(rng)) } else { (Some(rng), None) };
    let planner = OneCorner {
        wrong,
        scene: Arc::clone(start.scene),
        tries,
        memory: Memory::default(),
        hidden: Memory::default(),
        rng,
        hidden_rng,
        steps: Steps { taken: 0, lost: wrong == LosesField },
        part: Part::default(),
        weightless: Weightless(vec![0.5; if wrong == LosesSize { 1000 } else { 0 }]),
    };
    Ok(Started::new(planner, if wrong == IgnoresLimit { 500 } else { settings[ITERATIONS] }))
}

pub const PARAMETERS: &[&[Parameter]] = &[&[ITERATIONS.entry(), TRIES.entry()]];

pub const fn entry(start: fn(&Start) -> Result<Started, Error>) -> Entry {
    named("one-corner", "Tries paths with one corner.", start)
}

pub const fn named(name: &'static str, summary: &'static str, start: fn(&Start) -> Result<Started, Error>) -> Entry {
    Entry::new(name, "One corner", "not published", summary, start)
        .family("examples")
        .kinds(&[DISCS])
        .parameters(PARAMETERS)
        .readings(&[BEST, TRIED])
        .layers(&[layers::BEST, CORNER])
        .members(&[STEPS, TRIES_OF_IT])
}
