//! How a node came about, and what became of a sample.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Mark, Message, Shape},
    label, message,
};

use super::{
    grow::{By, Extension, Sample, SampleOutcome, Source},
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
        }
    }
}

impl<const N: usize> Seen<'_, N> {
    /// What can be said from the present state: of samples of the last extension, and of a root.
    pub(super) fn explain(&self, item: Item) -> Option<Inspection> {
        match item.layer {
            layer if layer == layers::SAMPLES.key => self.tell_sample(item),
            layer if layer == layers::NODES.key && self.forest.births.get(item.index)?.iteration == 0 => {
                let birth = self.forest.births[item.index];
                let mut told = self.node(item)?;
                told.event = "root";
                told.summary = if birth.tree == 0 {
                    message!("tree-root", "The tree begins here, at the start.")
                } else {
                    message!("tree-root-of-goal", "The goal’s tree begins here.")
                };
                Some(told)
            }
            _ => None,
        }
    }

    /// How the newest node came about: the state is that after the step.
    pub(super) fn tell_birth(&self, item: Item) -> Option<Inspection> {
        let birth = *self.forest.births.get(item.index).filter(|_| item.layer == layers::NODES.key)?;
        if u64::from(birth.iteration) != self.forest.iteration {
            return None;
        }
        let (last, tree) = (&self.forest.last, &self.forest.trees[usize::from(birth.tree)]);
        let mut told = self.node(item)?;
        told.event = match last.source {
            Source::Guided(_) if last.fell_back => "random step",
            Source::Guided(_) => "guided",
            Source::Goal => "towards the goal",
            Source::Informed => "informed",
            Source::Other => "towards the other tree",
            Source::Uniform => "random",
        };
        told.summary = summary(last);
        let near = tree.points[last.near];
        let from = self.task.space.place(&near);
        let to = told.marks.iter().find(|mark| mark.layer == layers::AFTER.key).map(|mark| mark.vertices[0]);
        told.marks.push(Mark {
            layer: layers::STEP.key,
            shape: Shape::Segments,
            vertices: to.into_iter().flat_map(|to| [from, to]).collect(),
        });
        if let Some(sample) = last.samples.iter().find(|sample| sample.outcome == SampleOutcome::Taken) {
            self.tell_taken(sample, &near, &mut told);
        }
        self.table(&near, &mut told);
        told.suppositions = vec![label!("tree-other-random-numbers", "random", "x_{\\text{rand}}", "with other random numbers")];
        Some(told)
    }

    /// What would have grown instead of a node: the first of those from `index` on, if there is one.
    pub(super) fn tell_supposed(&self, item: Item, index: usize) -> Inspection {
        let Some(mut told) = self.tell_birth(Item { index, ..item }) else {
            let title = message!("tree-node", "Node {i}", i = item.index + 1);
            return Inspection::new(item, title, "nothing", message!("tree-supposed-nothing", "Nothing would have grown."));
        };
        for mark in &mut told.marks {
            if mark.layer == layers::STEP.key {
                mark.layer = layers::JUMP.key;
            }
        }
        told
    }

    /// A node's name, numbers and way.
    fn node(&self, item: Item) -> Option<Inspection> {
        let birth = *self.forest.births.get(item.index)?;
        let (tree, node) = (&self.forest.trees[usize::from(birth.tree)], birth.node as usize);
        let place = |point: &[f64; N]| self.task.space.place(point);
        let at = place(&tree.points[node]);
        let mut values = vec![label!("tree-way", "cost", "g", "way from the root").is(tree.costs[node])];
        values.extend(PLACE.iter().zip(at).take(self.task.space.dimensions()).map(|(label, at)| label.is(at)));
        let way = tree.path_to(node).iter().map(place).collect();
        let mut marks = vec![Mark { layer: layers::WAY.key, shape: Shape::Polyline, vertices: way }];
        marks.push(Mark { layer: layers::AFTER.key, shape: Shape::Points, vertices: vec![at] });
        let title = message!("tree-node", "Node {i}", i = item.index + 1);
        Some(Inspection { values, marks, ..Inspection::new(item, title, "node", Message::default()) })
    }

    fn tell_taken(&self, sample: &Sample<N>, near: &[f64; N], told: &mut Inspection) {
        told.values.extend([
            label!("tree-sample-distance", "far", "\\lVert x_{\\text{rand}} - x_{\\text{near}} \\rVert", "from the node to the sample")
                .is(distance(near, &sample.point)),
            label!("tree-step-size", "step", "L", "step size").is(self.task.step),
        ]);
        told.formulas.push("extend");
        if sample.angle.is_finite() {
            told.values.extend([
                label!("tree-goal-angle", "angle", "\\varphi", "angle with the goal’s direction").is(sample.angle),
                label!("tree-share", "share", "p", "share of the roulette wheel").is(sample.share),
            ]);
            if self.forest.last.source == Source::Guided(By::Distance) {
                told.values.push(
                    label!("tree-goal-distance", "to_goal", "d", "distance to the goal").is(distance(&self.task.goal(), &sample.point)),
                );
                told.formulas.push("roulette-distance");
            } else {
                told.formulas.extend(["angle", "roulette"]);
            }
        }
    }

    /// The samples of the last extension, and where they are.
    fn table(&self, near: &[f64; N], told: &mut Inspection) {
        let last = &self.forest.last;
        let place = |point: &[f64; N]| self.task.space.place(point);
        if let Source::Guided(by) = last.source {
            told.columns = vec![if by == By::Angle { ANGLE } else { TO_GOAL }];
            told.columns.extend(COLUMNS);
            let goal = self.task.goal();
            for (i, sample) in last.samples.iter().enumerate().filter(|(_, sample)| sample.angle.is_finite()) {
                told.labels.push(sample.outcome.row(i + 1));
                let key = if by == By::Angle { sample.angle.to_degrees() } else { distance(&goal, &sample.point) };
                told.rows.push(vec![key, sample.share, distance(near, &sample.point)]);
            }
        }
        let from = place(near);
        told.marks.push(Mark { layer: layers::BEFORE.key, shape: Shape::Points, vertices: vec![from] });
        if matches!(last.source, Source::Guided(_)) {
            told.marks.push(Mark { layer: layers::TO_GOAL.key, shape: Shape::Segments, vertices: vec![from, place(&self.task.goal())] });
        }
        let lines = |fates: &dyn Fn(&Sample<N>) -> bool| -> Vec<[f64; 3]> {
            last.samples.iter().filter(|sample| fates(sample)).flat_map(|sample| [from, place(&sample.point)]).collect()
        };
        let kept = lines(&|sample| !matches!(sample.outcome, SampleOutcome::NotKept | SampleOutcome::Taken));
        let chosen = lines(&|sample| sample.outcome == SampleOutcome::Taken);
        let all = last.samples.iter().map(|sample| place(&sample.point)).collect();
        told.marks.push(Mark { layer: layers::SAMPLES.key, shape: Shape::Points, vertices: all });
        told.marks.push(Mark { layer: layers::KEPT.key, shape: Shape::Segments, vertices: kept });
        told.marks.push(Mark { layer: layers::CHOSEN.key, shape: Shape::Segments, vertices: chosen });
        told.marks.retain(|mark| !mark.vertices.is_empty());
    }

    fn tell_sample(&self, item: Item) -> Option<Inspection> {
        let last = &self.forest.last;
        let sample = last.samples.get(item.index)?;
        let near = *self.forest.trees[last.tree].points.get(last.near)?;
        let place = |point: &[f64; N]| self.task.space.place(point);
        let title = message!("tree-sample", "Sample {i}", i = item.index + 1);
        let mut told = Inspection {
            marks: vec![Mark { layer: layers::AFTER.key, shape: Shape::Points, vertices: vec![place(&sample.point)] }],
            ..Inspection::new(item, title, sample.outcome.name(), sample.outcome.sentence(last.source))
        };
        self.tell_taken(sample, &near, &mut told);
        self.table(&near, &mut told);
        Some(told)
    }
}

/// An extension in a sentence.
fn summary<const N: usize>(last: &Extension<N>) -> Message {
    let rewired = match last.rewired {
        0 => Message::default(),
        1 => message!("tree-rewired-one", "One neighbour has become its child."),
        n => message!("tree-rewired", "{n} neighbours have become its children.", n),
    };
    let count = |outcome: SampleOutcome| last.samples.iter().filter(|sample| sample.outcome == outcome).count();
    match last.source {
        Source::Guided(_) if last.fell_back => {
            let kept = last.samples.iter().filter(|sample| sample.angle.is_finite() && sample.outcome != SampleOutcome::NotKept).count();
            message!("tree-fell-back", "None of the {kept} kept samples led on, so the tree took a plain random step.", kept)
        }
        Source::Guided(by) => {
            let (drawn, kept) = (last.samples.len(), last.samples.len() - count(SampleOutcome::NotKept));
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
