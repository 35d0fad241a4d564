//! How a node came about, and what became of a sample.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Mark, Message, Shape},
    label, message,
};

use super::{
    grow::{Birth, By, Sample, SampleOutcome, Source},
    method::Seen,
    vector::distance,
};

const PLACE: [Label; 3] = [
    label!("tree-position", "x", "x", "where it is"),
    label!("tree-position", "y", "y", "where it is"),
    label!("tree-position", "z", "z", "where it is"),
];
const ANGLE: Label = label!("tree-goal-angle-degrees", "angle", "\\varphi_i", "angle with the goal’s direction, in degrees");
const TO_GOAL: Label = label!("tree-goal-distance", "to_goal", "d_i", "distance to the goal");
const COLUMNS: [Label; 2] = [
    label!("tree-share", "share", "p_i", "share of the roulette wheel"),
    label!("tree-node-distance", "far", "d", "distance from the node"),
];

impl SampleOutcome {
    /// Its name as an event.
    fn name(self) -> &'static str {
        match self {
            Self::Taken => "taken",
            Self::NotKept => "not kept",
            Self::NotDrawn => "kept, not drawn",
            Self::TooNear => "nearer than a step",
            Self::Outside => "leads outside",
            Self::Blocked => "blocked",
            Self::DoublesBack => "doubles back",
            Self::Unreachable => "no posture",
        }
    }

    /// Its row in the table, by the sample's number.
    fn row(self, i: usize) -> Message {
        match self {
            Self::Taken => message!("tree-row-taken", "{i}: taken", i),
            Self::NotKept => message!("tree-row-not-kept", "{i}: not kept", i),
            Self::NotDrawn => message!("tree-row-not-drawn", "{i}: kept, not drawn", i),
            Self::TooNear => message!("tree-row-too-near", "{i}: nearer than a step", i),
            Self::Outside => message!("tree-row-outside", "{i}: leads outside", i),
            Self::Blocked => message!("tree-row-blocked", "{i}: blocked", i),
            Self::DoublesBack => message!("tree-row-doubles-back", "{i}: doubles back", i),
            Self::Unreachable => message!("tree-row-unreachable", "{i}: no posture", i),
        }
    }

    /// In a sentence.
    fn sentence(self, source: Source) -> Message {
        match self {
            Self::NotKept if source == Source::Guided(By::Distance) => {
                message!("tree-sample-not-on-wheel", "The roulette wheel did not draw it.")
            }
            Self::Taken => message!("tree-sample-taken", "The tree has grown towards it."),
            Self::NotKept => message!("tree-sample-not-kept", "Its direction was not among those nearest to the goal’s."),
            Self::NotDrawn => {
                message!("tree-sample-not-drawn", "It was kept; the tree could grow toward another before its turn came.")
            }
            Self::TooNear => message!("tree-sample-too-near", "It is nearer to the node than a step, so it was skipped."),
            Self::Outside => message!("tree-sample-outside", "The new node would have been outside."),
            Self::Blocked => message!("tree-sample-blocked", "The way to the new node is blocked."),
            Self::DoublesBack => {
                message!("tree-sample-doubles-back", "The new node would have been nearer to another node than to its parent.")
            }
            Self::Unreachable => {
                message!(
                    "tree-sample-unreachable",
                    "The arm did not get there without touching anything, neither with its hand as it was nor with it turned a little."
                )
            }
        }
    }
}

/// A sample of the last extension, without its coordinates.
struct Drawn {
    place: [f64; 3],
    /// Its distances from the node that was to grow, and from the goal.
    far: f64,
    to_goal: f64,
    angle: f64,
    share: f64,
    outcome: SampleOutcome,
}

/// Nodes by their tree and number, without their coordinates.
trait Nodes {
    /// Where one is drawn.
    fn place(&self, tree: usize, node: usize) -> [f64; 3];
    /// The length of the way from the root, and where that leads.
    fn way(&self, tree: usize, node: usize) -> (f64, Vec<[f64; 3]>);
}

impl<const N: usize> Nodes for Seen<'_, N> {
    fn place(&self, tree: usize, node: usize) -> [f64; 3] {
        self.task.space.place(&self.forest.trees[tree].points[node])
    }

    fn way(&self, tree: usize, node: usize) -> (f64, Vec<[f64; 3]>) {
        let tree = &self.forest.trees[tree];
        (tree.costs[node], tree.path_to(node).iter().map(|point| self.task.space.place(point)).collect())
    }
}

/// What is explained, in any number of dimensions: the code is there once.
struct Explainer<'a> {
    nodes: &'a dyn Nodes,
    births: &'a [Birth],
    iteration: u64,
    dimensions: usize,
    step: f64,
    goal: [f64; 3],
    last: Summary,
    samples: Vec<Drawn>,
}

/// The last extension.
#[derive(Clone, Copy)]
struct Summary {
    source: Source,
    tree: usize,
    near: usize,
    fell_back: bool,
    rewired: usize,
}

impl<const N: usize> Seen<'_, N> {
    fn explainer(&self) -> Explainer<'_> {
        let (forest, task, last) = (self.forest, self.task, &self.forest.last);
        let goal = task.goal();
        // Nothing was drawn before there is a node.
        let near = forest.trees[last.tree].points.get(last.near).copied().unwrap_or(goal);
        let samples = last.samples.iter().map(|&Sample { point, angle, share, outcome }| Drawn {
            place: task.space.place(&point),
            far: distance(&near, &point),
            to_goal: distance(&goal, &point),
            angle,
            share,
            outcome,
        });
        Explainer {
            nodes: self,
            births: &forest.births,
            iteration: forest.iteration,
            dimensions: task.space.dimensions(),
            step: task.step,
            goal: task.space.place(&goal),
            last: Summary { source: last.source, tree: last.tree, near: last.near, fell_back: last.fell_back, rewired: last.rewired },
            samples: samples.collect(),
        }
    }

    /// What can be said from the present state: of samples of the last extension, and of a root.
    pub(super) fn explain(&self, item: Item) -> Option<Inspection> {
        self.explainer().explain(item)
    }

    /// How the newest node came about: the state is that after the step.
    pub(super) fn describe_birth(&self, item: Item) -> Option<Inspection> {
        self.explainer().describe_birth(item)
    }

    /// What would have grown instead of a node: the first of those from `index` on, if there is one.
    pub(super) fn describe_supposed(&self, item: Item, index: usize) -> Inspection {
        self.explainer().describe_supposed(item, index)
    }
}

impl Explainer<'_> {
    fn explain(&self, item: Item) -> Option<Inspection> {
        match item.layer {
            layer if layer == layers::SAMPLES.key => self.describe_sample(item),
            layer if layer == layers::NODES.key && self.births.get(item.index)?.iteration == 0 => {
                let birth = self.births[item.index];
                let mut inspection = self.node(item)?;
                inspection.event = "root";
                inspection.summary = if birth.tree == 0 {
                    message!("tree-root", "The tree begins here, at the start.")
                } else {
                    message!("tree-root-of-goal", "The goal’s tree begins here.")
                };
                Some(inspection)
            }
            _ => None,
        }
    }

    fn describe_birth(&self, item: Item) -> Option<Inspection> {
        let birth = *self.births.get(item.index).filter(|_| item.layer == layers::NODES.key)?;
        if u64::from(birth.iteration) != self.iteration {
            return None;
        }
        let last = self.last;
        let mut inspection = self.node(item)?;
        inspection.event = match last.source {
            Source::Guided(_) if last.fell_back => "random step",
            Source::Guided(_) => "guided",
            Source::Goal => "towards the goal",
            Source::Informed => "informed",
            Source::Other => "towards the other tree",
            Source::Uniform => "random",
        };
        inspection.summary = self.summary();
        let from = self.nodes.place(usize::from(birth.tree), last.near);
        let to = inspection.marks.iter().find(|mark| mark.layer == layers::AFTER.key).map(|mark| mark.vertices[0]);
        inspection.marks.push(Mark {
            layer: layers::STEP.key,
            shape: Shape::Segments,
            vertices: to.into_iter().flat_map(|to| [from, to]).collect(),
        });
        if let Some(sample) = self.samples.iter().find(|sample| sample.outcome == SampleOutcome::Taken) {
            self.describe_taken(sample, &mut inspection);
        }
        self.table(from, &mut inspection);
        inspection.suppositions = vec![label!("tree-other-random-numbers", "random", "x_{\\text{rand}}", "with other random numbers")];
        Some(inspection)
    }

    fn describe_supposed(&self, item: Item, index: usize) -> Inspection {
        let Some(mut inspection) = self.describe_birth(Item { index, ..item }) else {
            let title = message!("tree-node", "Node {i}", i = item.index + 1);
            return Inspection::new(item, title, "nothing", message!("tree-supposed-nothing", "Nothing would have grown."));
        };
        for mark in &mut inspection.marks {
            if mark.layer == layers::STEP.key {
                mark.layer = layers::JUMP.key;
            }
        }
        inspection
    }

    /// A node's name, numbers and way.
    fn node(&self, item: Item) -> Option<Inspection> {
        let birth = *self.births.get(item.index)?;
        let (tree, node) = (usize::from(birth.tree), birth.node as usize);
        let at = self.nodes.place(tree, node);
        let (cost, way) = self.nodes.way(tree, node);
        let mut values = vec![label!("tree-way", "cost", "g", "way from the root").is(cost)];
        values.extend(PLACE.iter().zip(at).take(self.dimensions).map(|(label, at)| label.is(at)));
        let mut marks = vec![Mark { layer: layers::WAY.key, shape: Shape::Polyline, vertices: way }];
        marks.push(Mark { layer: layers::AFTER.key, shape: Shape::Points, vertices: vec![at] });
        let title = message!("tree-node", "Node {i}", i = item.index + 1);
        Some(Inspection { values, marks, ..Inspection::new(item, title, "node", Message::default()) })
    }

    fn describe_taken(&self, sample: &Drawn, inspection: &mut Inspection) {
        inspection.values.extend([
            label!("tree-sample-distance", "far", "\\lVert x_{\\text{rand}} - x_{\\text{near}} \\rVert", "from the node to the sample")
                .is(sample.far),
            label!("tree-step-size", "step", "L", "step size").is(self.step),
        ]);
        inspection.formulas.push("extend");
        if sample.angle.is_finite() {
            inspection.values.extend([
                label!("tree-goal-angle", "angle", "\\varphi", "angle with the goal’s direction").is(sample.angle),
                label!("tree-share", "share", "p", "share of the roulette wheel").is(sample.share),
            ]);
            if self.last.source == Source::Guided(By::Distance) {
                inspection.values.push(label!("tree-goal-distance", "to_goal", "d", "distance to the goal").is(sample.to_goal));
                inspection.formulas.push("roulette-distance");
            } else {
                inspection.formulas.extend(["angle", "roulette"]);
            }
        }
    }

    /// The samples of the last extension, and where they are, from the node that was to grow.
    fn table(&self, from: [f64; 3], inspection: &mut Inspection) {
        if let Source::Guided(by) = self.last.source {
            inspection.columns = vec![if by == By::Angle { ANGLE } else { TO_GOAL }];
            inspection.columns.extend(COLUMNS);
            for (i, sample) in self.samples.iter().enumerate().filter(|(_, sample)| sample.angle.is_finite()) {
                inspection.labels.push(sample.outcome.row(i + 1));
                let key = if by == By::Angle { sample.angle.to_degrees() } else { sample.to_goal };
                inspection.rows.push(vec![key, sample.share, sample.far]);
            }
        }
        inspection.marks.push(Mark { layer: layers::BEFORE.key, shape: Shape::Points, vertices: vec![from] });
        if matches!(self.last.source, Source::Guided(_)) {
            inspection.marks.push(Mark { layer: layers::TO_GOAL.key, shape: Shape::Segments, vertices: vec![from, self.goal] });
        }
        let lines = |fates: &dyn Fn(&Drawn) -> bool| -> Vec<[f64; 3]> {
            self.samples.iter().filter(|sample| fates(sample)).flat_map(|sample| [from, sample.place]).collect()
        };
        let kept = lines(&|sample| !matches!(sample.outcome, SampleOutcome::NotKept | SampleOutcome::Taken));
        let chosen = lines(&|sample| sample.outcome == SampleOutcome::Taken);
        let all = self.samples.iter().map(|sample| sample.place).collect();
        inspection.marks.push(Mark { layer: layers::SAMPLES.key, shape: Shape::Points, vertices: all });
        inspection.marks.push(Mark { layer: layers::KEPT.key, shape: Shape::Segments, vertices: kept });
        inspection.marks.push(Mark { layer: layers::CHOSEN.key, shape: Shape::Segments, vertices: chosen });
        inspection.marks.retain(|mark| !mark.vertices.is_empty());
    }

    fn describe_sample(&self, item: Item) -> Option<Inspection> {
        let last = self.last;
        let sample = self.samples.get(item.index)?;
        let title = message!("tree-sample", "Sample {i}", i = item.index + 1);
        let mut inspection = Inspection {
            marks: vec![Mark { layer: layers::AFTER.key, shape: Shape::Points, vertices: vec![sample.place] }],
            ..Inspection::new(item, title, sample.outcome.name(), sample.outcome.sentence(last.source))
        };
        self.describe_taken(sample, &mut inspection);
        self.table(self.nodes.place(last.tree, last.near), &mut inspection);
        Some(inspection)
    }

    /// The last extension in a sentence.
    fn summary(&self) -> Message {
        let last = self.last;
        let rewired = match last.rewired {
            0 => Message::default(),
            1 => message!("tree-rewired-one", "One neighbour has become its child."),
            n => message!("tree-rewired", "{n} neighbours have become its children.", n),
        };
        let count = |outcome: SampleOutcome| self.samples.iter().filter(|sample| sample.outcome == outcome).count();
        match last.source {
            Source::Guided(_) if last.fell_back => {
                let kept =
                    self.samples.iter().filter(|sample| sample.angle.is_finite() && sample.outcome != SampleOutcome::NotKept).count();
                message!("tree-fell-back", "None of the {kept} kept samples led on, so the tree took a plain random step.", kept)
            }
            Source::Guided(by) => {
                let (drawn, kept) = (self.samples.len(), self.samples.len() - count(SampleOutcome::NotKept));
                match by {
                    By::Angle => message!(
                        "tree-guided-by-angle",
                        "Of {drawn} samples the {kept} with the smallest angles were kept. The tree has grown toward the one that the roulette wheel chose.",
                        drawn,
                        kept
                    ),
                    By::Distance => message!(
                        "tree-guided-by-distance",
                        "Of {drawn} samples the roulette wheel kept {kept}. The tree has grown toward the one nearest to the goal that was free.",
                        drawn,
                        kept
                    ),
                }
            }
            Source::Goal => message!("tree-toward-goal", "The goal itself was the sample.").then(rewired),
            Source::Informed => message!("tree-informed", "The sample came from where a shorter path can lead.").then(rewired),
            Source::Other => message!("tree-toward-other", "The tree went for the other tree’s newest node."),
            Source::Uniform => message!("tree-random", "The node nearest to a random point has grown by a step towards it.").then(rewired),
        }
    }
}
