//! `@NAME@`: not published. TODO: what it does, and where that is from, with equation numbers.
//!
//! TODO: what stands here works, and is to be replaced: it tries paths with one random corner, and keeps the shortest free one.

use std::sync::Arc;

use crate::{
    describe::{Entry, Group, Layer, Look, Reading, Start, layers},
    geometry,
    kernel::{
        Candidate, Error, Explain, Facets, Frame, Inspection, Item, LayerKey, Planner, Progress, Readings, Scene, Shape, Solution,
        Started, State, rng::Stream,
    },
    label, message,
    params::Param,
    scene::GRID,
};

const ITERATIONS: Param<u64> =
    Param::integer("iterations", "k_{\\max}", "Iterations", [1, 1_000_000, 500], "The number of iterations after which it stops.");
/// A parameter of its own. TODO: replace it.
const TRIES: Param<u64> =
    Param::integer("tries", "", "Tries", [1, 10_000, 20], "The number of corners tried in an iteration. More take longer and find more.");

const BEST: Reading = Reading::new("best", "L", "Shortest", Group::Cost, "The length of the shortest free path so far.");
const FOUND: Reading = Reading::new("found", "", "Free paths", Group::Count, "The number of free paths found so far.");

/// The corner that was tried last.
const CORNER: Layer = Layer::new(LayerKey("@NAME@-corner"), "Corner", "The corner that was tried last.", &CORNER_LOOK).pickable();
const CORNER_LOOK: Look = Look { point: 6.0, order: 30, ..Look::PLAIN };

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "@NAME@",
    "@TITLE@",
    "not published",
    "Tries paths with one random corner and keeps the shortest that is free.",
    start,
)
.family("@FAMILY@")
.kinds(&[GRID])
.parameters(&[&[ITERATIONS.entry(), TRIES.entry()]])
.readings(&[BEST, FOUND])
.layers(&[CORNER, layers::BEST]);

/// The state: all that the next step depends on. A clone of it is a keyframe, and `State` gives its hash and size.
#[derive(Clone, State)]
struct @TYPE@ {
    /// What follows from the setup is shared.
    #[state(shared)]
    scene: Arc<Scene>,
    #[state(shared)]
    ends: [[f64; 2]; 2],
    #[state(shared)]
    tries: u64,
    /// The only source of random numbers.
    rng: Stream,
    corner: [f64; 2],
    found: u64,
    evaluations: u64,
    best: Option<(f64, Vec<[f64; 2]>)>,
}

fn start(start: &Start) -> Result<Started, Error> {
    let Some((from, to)) = start.scene.ends() else {
        return Err(Error::refused("kind", start.scene.kind().name(), message!("@NAME@-kind", "grid, with start and goal")));
    };
    let planner = @TYPE@ {
        scene: Arc::clone(start.scene),
        ends: [from, to],
        tries: start.parameters[TRIES],
        rng: Stream::new(start.seed, 0),
        corner: from,
        found: 0,
        evaluations: 0,
        best: None,
    };
    Ok(Started::new(planner, start.parameters[ITERATIONS]))
}

impl @TYPE@ {
    fn try_corner(&mut self) {
        let view = self.scene.view();
        self.corner = [0, 1].map(|axis| self.rng.between(view.min[axis], view.max[axis]));
        self.evaluations += 1;
        let [from, to] = self.ends;
        let path = [from, self.corner, to];
        if !path.windows(2).all(|leg| self.scene.is_free(leg[0], leg[1])) {
            return;
        }
        self.found += 1;
        let length = geometry::length(&path);
        if self.best.as_ref().is_none_or(|(least, _)| length < *least) {
            self.best = Some((length, path.to_vec()));
        }
    }
}

impl Planner for @TYPE@ {
    /// One iteration. TODO: the algorithm's steps, each a function with the number of its equation.
    fn advance(&mut self) -> Progress {
        (0..self.tries).for_each(|_| self.try_corner());
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn best(&self) -> Option<Candidate> {
        self.best.as_ref().map(|(cost, path)| Candidate { cost: *cost, solution: Solution::Path(path.clone()) })
    }

    fn read(&self, out: &mut Readings) {
        // What is not there yet is not a number.
        out.push(BEST, self.best.as_ref().map_or(f64::NAN, |(length, _)| *length));
        out.push(FOUND, self.found as f64);
    }

    fn draw(&self, frame: &mut Frame) {
        frame.begin(CORNER.key, Shape::Points);
        frame.push(self.corner, 0.0);
        if let Some((_, path)) = &self.best {
            frame.begin(layers::BEST.key, Shape::Polyline);
            path.iter().for_each(|&corner| frame.push(corner, 0.0));
        }
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self)
    }
}

impl Explain for @TYPE@ {
    /// TODO: what the last step did to an item and why.
    fn inspect(&self, item: Item) -> Option<Inspection> {
        if item.layer != CORNER.key || item.index != 0 {
            return None;
        }
        let summary = message!("@NAME@-drawn", "It was drawn uniformly in the scene.");
        let mut inspection = Inspection::new(item, message!("@NAME@-corner", "Corner"), "drawn", summary);
        inspection.values = vec![
            label!("@NAME@-x", "x", "x", "x coordinate").is(self.corner[0]),
            label!("@NAME@-y", "y", "y", "y coordinate").is(self.corner[1]),
        ];
        Some(inspection)
    }
}
