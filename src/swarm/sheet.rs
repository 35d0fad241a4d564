//! What explanations of all swarms are made of: sheets, tables, marks.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, LayerKey, Mark, Message, Shape, rng::Stream},
    label, message,
};

use super::{objective::Objective, population::Population};

const COST: [Label; 1] = [label!("swarm-cost", "cost", "f(x)", "cost")];
const START: [Label; 1] = [label!("swarm-position", "x", "x", "position")];

/// The random numbers of one step are others.
pub(super) const OTHER_NUMBERS: Label = label!("swarm-other-random-numbers", "random", "r", "with other random numbers");
/// What can be supposed of a flight.
pub(super) const SUPPOSITIONS: [Label; 4] = [
    label!("swarm-without-inertia", "inertia", "v = 0", "without inertia"),
    label!("swarm-without-own-best", "own", "c_1 = 0", "without its own best"),
    label!("swarm-without-swarm-best", "best", "c_2 = 0", "without the swarm’s best"),
    OTHER_NUMBERS,
];

/// What is supposed of a particle's step, by its label's name, and other random numbers.
pub(super) type Supposed<'a> = Option<(&'a str, &'a Stream)>;

/// Adds numbers to an explanation.
// Explaining is rare: what its parts share is not copied into each.
#[inline(never)]
pub(super) fn quantities(inspection: &mut Inspection, labels: &[Label], values: &[f64]) {
    inspection.values.extend(labels.iter().zip(values).map(|(label, &value)| label.is(value)));
}

/// The particle that an item means, if there is one.
#[inline(never)]
pub(super) fn particle(population: &Population, item: Item) -> Option<usize> {
    let known = [layers::PARTICLES.key, layers::PERSONAL_BESTS.key].contains(&item.layer);
    (known && item.index < population.size).then_some(item.index)
}

/// The particle before anything has moved it, and where it comes from; `None` within the first step, which may have moved it.
pub(super) fn introduce(population: &Population, item: Item, origin: Message) -> Option<Inspection> {
    let i = particle(population, item).filter(|_| !population.is_under_way())?;
    let (meaning, x) = (&*population.objective, &population.x[population.row(i)]);
    let mut inspection = sheet(meaning, item, "start", origin, x.len());
    inspection.columns = START.to_vec();
    inspection.rows = x.iter().map(|&x| vec![x]).collect();
    quantities(&mut inspection, &COST, &[population.cost[i]]);
    inspection.marks = vec![mark(meaning, layers::AFTER.key, x)];
    Some(inspection)
}

#[inline(never)]
pub(super) fn sheet(meaning: &dyn Objective, item: Item, event: &'static str, summary: Message, dimension: usize) -> Inspection {
    let title = message!("swarm-particle", "Particle {i}", i = item.index);
    let labels = (0..dimension).map(|j| Message::verbatim(meaning.coordinate(j))).collect();
    Inspection { labels, ..Inspection::new(item, title, event, summary) }
}

#[inline(never)]
pub(super) fn mark(meaning: &dyn Objective, layer: LayerKey, x: &[f64]) -> Mark {
    let mut vertices: Vec<_> = meaning.points(x).collect();
    let shape = match meaning.ends() {
        Some((start, goal)) => {
            vertices.insert(0, start);
            vertices.push(goal);
            Shape::Polyline
        }
        None => Shape::Points,
    };
    Mark::plane(layer, shape, vertices)
}

#[inline(never)]
pub(super) fn arrows(meaning: &dyn Objective, layer: LayerKey, from: &[f64], to: &[f64]) -> Mark {
    let vertices = meaning.points(from).zip(meaning.points(to)).flat_map(|(a, b)| [a, b]).collect();
    Mark::plane(layer, Shape::Segments, vertices)
}
