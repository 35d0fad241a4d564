//! A planner, an objective function and a layer with a look of its own, all in this file, and the whole command line:
//!
//! ```console
//! $ cargo run --release -- list
//! $ cargo run --release -- run compass-search --scene himmelblau --json
//! $ cargo run --release -- run wcpso-himmelblau --scene himmelblau --svg swarm.svg
//! ```

use std::{process::ExitCode, sync::Arc};

use forage::{
    Error, Frame, Registry, Scene,
    describe::{Color, Entry, Formula, Glyph, Group, Layer, Look, Reading, SceneKind, Start, layers},
    geometry::Bounds,
    kernel::{
        Backdrop, Candidate, Explain, Facets, Inspection, Item, LayerKey, Mark, Minimum, Planner, Progress, Readings, SceneBody,
        SceneKindId, Shape, Solution, Started, State, Verdict, rng::Stream,
    },
    label, message,
    params::Param,
    scene::{FUNCTION, FunctionScene},
    swarm::{
        objective::{Evaluation, Objective, Scratch, SearchBox},
        wcpso,
    },
};
use serde_json::Value;

fn main() -> ExitCode {
    forage_cli::main_with(registry())
}

fn registry() -> Registry {
    Registry::standard().with(&KIND).with(&COMPASS_SEARCH).with(&WCPSO)
}

// ---- An objective function, and the kind of scene that asks for its minimum.

/// Himmelblau's function, (x² + y − 11)² + (x + y² − 7)²: four minima, all 0.
struct Himmelblau(SearchBox);

impl Objective for Himmelblau {
    fn search_box(&self) -> &SearchBox {
        &self.0
    }

    fn evaluate(&self, x: &[f64], _scratch: &mut Scratch) -> Evaluation {
        let [x, y] = [x[0], x[1]];
        let [a, b] = [x * x + y - 11.0, x + y * y - 7.0];
        (a * a + b * b).into()
    }
}

const HIMMELBLAU: SceneKindId = SceneKindId("himmelblau");

/// Nothing in it differs from scene to scene.
struct HimmelblauScene;

const KIND: SceneKind = SceneKind {
    id: HIMMELBLAU,
    title: "Himmelblau's function",
    read: |_| Ok(Arc::new(HimmelblauScene)),
    optimum: None,
    shipped: &[r#"{"format": "forage-scene", "version": 1, "kind": "himmelblau", "name": "himmelblau", "title": "Himmelblau's function"}"#],
};

impl SceneBody for HimmelblauScene {
    fn kind_id() -> SceneKindId {
        HIMMELBLAU
    }

    fn kind(&self) -> SceneKindId {
        HIMMELBLAU
    }

    fn check(&self, _stored: Option<&Value>) -> Result<(), Error> {
        Ok(())
    }

    fn judge(&self, _solution: &Solution) -> Verdict {
        Verdict::NO_PATH
    }

    fn view(&self) -> Bounds {
        Bounds { min: [-5.0; 2], max: [5.0; 2] }
    }

    fn write(&self, _out: &mut Vec<(&'static str, Value)>) {}

    fn backdrop(&self, draw: &mut dyn FnMut(Backdrop)) {
        draw(Backdrop::Border(self.view()));
    }

    fn minimum(&self) -> Option<Minimum> {
        Some(Minimum::from(0.0))
    }
}

/// What a scene asks to be minimised: ours, or one of the test functions that ship.
fn objective(scene: &Scene) -> Result<Arc<dyn Objective>, Error> {
    match scene.get::<FunctionScene>() {
        Ok(function) => Ok(Arc::clone(function.objective())),
        Err(_) => Ok(Arc::new(Himmelblau(SearchBox::cube(2, -5.0, 5.0)?))),
    }
}

/// A swarm that ships, on the objective.
const WCPSO: Entry = Entry::new(
    "wcpso-himmelblau",
    "WCPSO on Himmelblau's function",
    "[WCPSO] §2",
    "The swarm with hens and chicks, on a function that has four minima.",
    |start| Ok(wcpso::on(objective(start.scene)?, start.parameters, start.seed)),
)
.like(&wcpso::ENTRY)
.kinds(&[HIMMELBLAU]);

// ---- A planner.

const ITERATIONS: Param<u64> = Param::integer("iterations", "k_{\\max}", "Iterations", [1, 100_000, 300], "After how many steps it stops.");
const STEP: Param<f64> = Param::number("step", "\\Delta_0", "First step", [0.001, 0.5, 0.25], "As a share of the box's sides.");
const CONTRACTION: Param<f64> =
    Param::number("contraction", "\\theta", "Contraction", [0.1, 0.9, 0.5], "What a step is multiplied by when no probe was better.");

const BEST: Reading = Reading::new("best", "f(g)", "Best", Group::Cost, "The least cost so far.");
const STEP_NOW: Reading =
    Reading::new("step_now", "\\Delta_k", "Step", Group::Schedule, "How far the probes are, as a share of the sides.");
const STARTS: Reading = Reading::new("starts", "s", "Starts", Group::Count, "How many times it began somewhere else.");

/// A layer of its own: its key, and how it looks on light and on dark ground.
const STENCIL: LayerKey = LayerKey("stencil");
const STENCIL_LOOK: Look = Look { color: Color::new("#8a3ffc", "#be95ff"), point: 7.0, glyph: Glyph::Diamond, order: 30, ..Look::PLAIN };

const COMPASS_SEARCH: Entry = Entry::new(
    "compass-search",
    "Compass search",
    "Kolda, Lewis and Torczon, SIAM Review 45 (2003), §1.1",
    "It probes a step forth and back along each coordinate and goes where the cost is least; where no probe is better, the step \
     shrinks. When the step is tiny it begins again somewhere else.",
    |start: &Start| {
        let search = CompassSearch::new(objective(start.scene)?, start.parameters[STEP], start.parameters[CONTRACTION], start.seed);
        Ok(Started::new(search, start.parameters[ITERATIONS]))
    },
)
.family("direct search")
.kinds(&[HIMMELBLAU, FUNCTION])
.parameters(&[&[ITERATIONS.entry(), STEP.entry(), CONTRACTION.entry()]])
.readings(&[BEST, STEP_NOW, STARTS])
.formulas(&[Formula::new(
    "contract",
    "Kolda, Lewis and Torczon 2003, fig. 1.1",
    "Contraction",
    "\\Delta_{k+1} = \\theta \\Delta_k",
    "\\Delta_{k+1} = @contraction@ \\cdot \\Delta_k = @step_now@",
)])
.layers(&[layers::BEST, Layer::new(STENCIL, "Stencil", "The probes of this iteration, around where it stands.", &STENCIL_LOOK).pickable()]);

/// Steps that are smaller, as a share of the sides, are not worth their probes.
const TINY: f64 = 1e-9;

#[derive(Clone, State)]
struct CompassSearch {
    #[state(shared)]
    objective: Arc<dyn Objective>,
    #[state(shared)]
    first: f64,
    #[state(shared)]
    contraction: f64,
    #[state(skip)]
    scratch: Scratch,
    at: Vec<f64>,
    cost: f64,
    step: f64,
    /// Two probes for each coordinate, and their costs.
    probes: Vec<Vec<f64>>,
    costs: Vec<f64>,
    best: Vec<f64>,
    best_cost: f64,
    evaluations: u64,
    starts: u64,
    rng: Stream,
}

impl CompassSearch {
    fn new(objective: Arc<dyn Objective>, first: f64, contraction: f64, seed: u64) -> Self {
        let n = objective.search_box().dimension();
        let mut search = Self {
            objective,
            first,
            contraction,
            scratch: Scratch::default(),
            at: vec![0.0; n],
            cost: f64::INFINITY,
            step: first,
            probes: vec![vec![0.0; n]; 2 * n],
            costs: vec![f64::INFINITY; 2 * n],
            best: vec![0.0; n],
            best_cost: f64::INFINITY,
            evaluations: 0,
            starts: 0,
            rng: Stream::new(seed, 0),
        };
        search.start();
        search
    }

    /// Begins somewhere.
    fn start(&mut self) {
        self.objective.draw(&mut self.at, &mut self.rng);
        self.cost = self.objective.evaluate(&self.at, &mut self.scratch).cost;
        self.evaluations += 1;
        self.step = self.first;
        self.starts += 1;
        let at = &self.at;
        self.probes.iter_mut().for_each(|probe| probe.copy_from_slice(at));
        self.costs.fill(self.cost);
        self.keep();
    }

    fn keep(&mut self) {
        if self.cost < self.best_cost {
            self.best_cost = self.cost;
            self.best.copy_from_slice(&self.at);
        }
    }

    /// Evaluates a step forth and back along each coordinate.
    fn probe(&mut self) {
        let area = self.objective.search_box();
        for (i, probe) in self.probes.iter_mut().enumerate() {
            let (j, sign) = (i / 2, if i % 2 == 0 { 1.0 } else { -1.0 });
            probe.copy_from_slice(&self.at);
            probe[j] = area.clamp(j, probe[j] + sign * self.step * (area.high()[j] - area.low()[j]));
            self.costs[i] = self.objective.evaluate(probe, &mut self.scratch).cost;
        }
        self.evaluations += self.costs.len() as u64;
    }
}

impl Planner for CompassSearch {
    fn advance(&mut self) -> Progress {
        if self.step < TINY {
            self.start();
            return Progress::Continue;
        }
        self.probe();
        let best = (0..self.costs.len()).min_by(|&a, &b| self.costs[a].total_cmp(&self.costs[b]));
        match best.filter(|&i| self.costs[i] < self.cost) {
            Some(i) => {
                self.at.copy_from_slice(&self.probes[i]);
                self.cost = self.costs[i];
                self.keep();
            }
            None => self.step *= self.contraction,
        }
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn best(&self) -> Option<Candidate> {
        Some(Candidate { cost: self.best_cost, solution: self.objective.solution(&self.best) })
    }

    fn read(&self, out: &mut Readings) {
        out.push(BEST, self.best_cost);
        out.push(STEP_NOW, self.step);
        out.push(STARTS, self.starts as f64);
    }

    fn draw(&self, frame: &mut Frame) {
        frame.begin(STENCIL, Shape::Points);
        self.probes.iter().for_each(|probe| frame.push(self.objective.point(probe, 0), 0.0));
        frame.begin(layers::BEST.key, Shape::Points);
        frame.push(self.objective.point(&self.best, 0), 0.0);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self)
    }
}

impl Explain for CompassSearch {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        let cost = *self.costs.get(item.index).filter(|_| item.layer == STENCIL)?;
        let here = self.objective.point(&self.at, 0);
        let probe = self.objective.point(&self.probes[item.index], 0);
        let title = message!("compass-probe", "Probe {i}", i = item.index + 1);
        let event = if cost <= self.cost { "taken" } else { "rejected" };
        let summary =
            message!("compass-cost", "Its cost is {cost:.6}; the search stands where the cost is {here:.6}.", cost, here = self.cost);
        let mut inspection = Inspection::new(item, title, event, summary);
        inspection.values = vec![label!("compass-label-cost", "cost", "f(x)", "Cost").is(cost)];
        inspection.marks = vec![Mark::plane(STENCIL, Shape::Segments, vec![here, probe])];
        Some(inspection)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use forage::testing;

    use super::{COMPASS_SEARCH, registry};

    /// What every planner must keep to, ours and yours.
    #[test]
    fn it_conforms() {
        testing::assert_conforms(&Arc::new(registry()), COMPASS_SEARCH.name);
    }
}
