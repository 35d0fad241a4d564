//! A planner whose steps are calls of a script.

use std::sync::Arc;

use forage::{
    describe::{Entry, Start},
    kernel::{
        Candidate, Digest, Error, Explain, Facets, Failure, Frame, Inspection, Item, Message, Planner, Progress, Readings, Shape, Solution,
        Started, State, Status, objective::Scratch,
    },
    message,
    scene::{FunctionScene, TourScene},
};

use super::{
    description::ITERATIONS,
    tools::{Tools, each_stop},
};

/// What a call led to, and the tools that were lent.
pub struct Call<T> {
    /// They come back whatever happened; none: they are lost, and the run with them.
    pub tools: Option<Tools>,
    /// What the script did, or what went wrong, in words.
    pub result: Result<T, Message>,
}

/// What a step led to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Advanced {
    /// The number of the state that there is now; the one before is forgotten.
    pub state: u32,
    /// There is nothing more to do.
    pub done: bool,
}

/// Something that a script draws.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// Which of the entry's layers.
    pub layer: usize,
    /// How the vertices belong together.
    pub shape: Shape,
    /// x, y and a weight each, in the scene's unit.
    pub vertices: Vec<[f64; 3]>,
}

/// The code of a planner. It keeps states, each of them known by a number.
pub trait Script: Send + Sync {
    /// Makes the state before the first step.
    fn start(&self, start: &Start, tools: Tools) -> Call<u32>;
    /// Takes a step.
    fn advance(&self, state: u32, tools: Tools) -> Call<Advanced>;
    /// The best solution so far.
    ///
    /// # Errors
    /// What went wrong, in words.
    fn best(&self, state: u32) -> Result<Option<Candidate>, Message>;
    /// A number for each of the entry's readings.
    ///
    /// # Errors
    /// What went wrong, in words.
    fn readings(&self, state: u32) -> Result<Vec<f64>, Message>;
    /// What there is to see.
    fn draw(&self, state: u32) -> Vec<Drawn>;
    /// Explains an item of a layer.
    fn explain(&self, state: u32, item: Item) -> Option<Inspection>;
    /// A copy of a state.
    fn copy(&self, state: u32) -> u32;
    /// A state is not needed any more.
    fn forget(&self, state: u32);
    /// A number that is the same for equal states.
    fn digest(&self, state: u32) -> u64;
    /// The memory that a state takes, in bytes, about.
    fn size(&self, state: u32) -> usize;
}

/// A state that its script forgets with it.
struct Held {
    script: Arc<dyn Script>,
    state: u32,
}

impl Clone for Held {
    fn clone(&self) -> Self {
        Self { script: Arc::clone(&self.script), state: self.script.copy(self.state) }
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        self.script.forget(self.state);
    }
}

#[derive(Clone)]
struct Scripted {
    entry: &'static Entry,
    held: Held,
    /// Lent during a call.
    tools: Option<Box<Tools>>,
    best: Option<Candidate>,
    failed: Option<Message>,
}

/// Starts a run of a script.
///
/// # Errors
/// [`Error::Refused`] for the planner, where its code cannot start.
pub fn begin(script: &Arc<dyn Script>, entry: &'static Entry, start: &Start) -> Result<Started, Error> {
    let broken = |why: Message| Error::refused("planner", entry.name, message!("script-starts", "one whose code starts: {why}", why));
    let Call { tools, result } = script.start(start, Tools::new(start.scene, start.seed));
    let held = Held { script: Arc::clone(script), state: result.map_err(broken)? };
    let mut scripted = Scripted { entry, held, tools: tools.map(Box::new), best: None, failed: None };
    scripted.ask_best();
    match scripted.failed.take() {
        Some(why) => Err(broken(why)),
        None => Ok(Started::new(scripted, start.parameters[ITERATIONS]).open_ended()),
    }
}

impl Scripted {
    /// The best solution, which must be one of the scene.
    fn ask_best(&mut self) {
        let found = self.held.script.best(self.held.state).and_then(|best| match best {
            Some(best) => self.checked(best).map(Some),
            None => Ok(None),
        });
        match found {
            Ok(best) => self.best = best,
            Err(why) => self.failed = Some(why),
        }
    }

    fn checked(&self, best: Candidate) -> Result<Candidate, Message> {
        if !best.cost.is_finite() {
            return Err(message!("script-cost", "the cost of its best is {cost}, which is not a finite number", cost = best.cost));
        }
        let Some(tools) = &self.tools else { return Ok(best) };
        let scene = tools.scene();
        if let Ok(function) = scene.get::<FunctionScene>() {
            let search_box = function.search_box();
            let sides = search_box.low().iter().zip(search_box.high());
            let inside = |position: &[f64]| position.iter().zip(sides).all(|(x, (low, high))| (low..=high).contains(&x));
            return match &best.solution {
                Solution::Position(position) if position.len() == search_box.dimension() && inside(position) => {
                    let known = self.best.as_ref() == Some(&best);
                    let cost = if known { best.cost } else { function.objective().evaluate(position, &mut Scratch::default()).cost };
                    // A cost that the code computes itself may be rounded. What is no number is near to nothing.
                    let near = (cost - best.cost).abs() <= 1e-9 * best.cost.abs().max(1.0);
                    if !near {
                        let said = best.cost;
                        return Err(message!("script-untrue", "the cost of its best is said to be {said}; it is {cost}", said, cost));
                    }
                    Ok(best)
                }
                _ => Err(message!("script-position", "its best is no position in the search box")),
            };
        }
        if let Ok(tour) = scene.get::<TourScene>() {
            return match best.solution {
                Solution::Tour { order, .. } if tour.ends().allows(&order, tour.len()) => {
                    let places = tour.places();
                    let mut path: Vec<_> = order.iter().map(|&stop| places[stop]).collect();
                    if tour.ends().closes() {
                        path.push(path[0]);
                    }
                    Ok(Candidate { cost: best.cost, solution: Solution::Tour { order, ends: tour.ends(), path } })
                }
                _ => Err(message!("script-order", "its best has not {stops}", stops = each_stop(tour.len()))),
            };
        }
        match (&best.solution, scene.ends()) {
            (Solution::Path(path), Some((start, goal)))
                if path.len() > 1
                    && path.iter().flatten().all(|x| x.is_finite())
                    && path.first() == Some(&start)
                    && path.last() == Some(&goal) =>
            {
                Ok(best)
            }
            _ => Err(message!("script-path", "its best is no path from the start to the goal")),
        }
    }
}

impl State for Scripted {
    fn digest(&self, out: &mut Digest) {
        out.word(self.held.script.digest(self.held.state));
        if let Some(tools) = &self.tools {
            tools.evaluations().digest(out);
            tools.drawn().cloned().digest(out);
        }
    }

    fn heap_size(&self) -> usize {
        self.held.script.size(self.held.state) + size_of::<Tools>()
    }
}

impl Planner for Scripted {
    fn advance(&mut self) -> Progress {
        let Some(tools) = self.tools.take() else { return Progress::Done(Status::Failed) };
        let Call { tools, result } = self.held.script.advance(self.held.state, *tools);
        self.tools = tools.map(Box::new);
        let done = match result {
            Ok(Advanced { state, done }) => {
                self.held.state = state;
                self.ask_best();
                done
            }
            Err(why) => {
                self.failed = Some(why);
                false
            }
        };
        match (&self.failed, done) {
            (Some(_), _) => Progress::Done(Status::Failed),
            (None, true) => Progress::Done(Status::Exhausted),
            (None, false) => Progress::Continue,
        }
    }

    fn evaluations(&self) -> u64 {
        self.tools.as_ref().map_or(0, |tools| tools.evaluations())
    }

    fn best(&self) -> Option<Candidate> {
        self.best.clone()
    }

    fn read(&self, out: &mut Readings) {
        let values = self.held.script.readings(self.held.state).unwrap_or_default();
        for (i, reading) in self.entry.readings.iter().enumerate() {
            out.push(*reading, values.get(i).copied().unwrap_or(f64::NAN));
        }
    }

    fn draw(&self, frame: &mut Frame) {
        for Drawn { layer, shape, vertices } in self.held.script.draw(self.held.state) {
            let Some(layer) = self.entry.layers.get(layer) else { continue };
            frame.begin(layer.key, shape);
            vertices.iter().for_each(|&[x, y, weight]| frame.push([x, y], weight));
        }
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).failure(self)
    }
}

impl Failure for Scripted {
    fn failure(&self, _status: Status) -> Option<Message> {
        self.failed.clone()
    }
}

impl Explain for Scripted {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        self.held.script.explain(self.held.state, item)
    }
}
