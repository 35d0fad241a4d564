//! What explanations of all swarms are made of: sheets, tables, marks.

use crate::{
    describe::layers,
    kernel::{Column, Inspection, Item, LayerKey, Mark, Quantity, Shape},
};

use super::{objective::Objective, population::Population};

/// The TeX strings that inspections use.
pub(super) const SYMBOLS: &[&str] = &[
    "f(x)",
    "f(p)",
    "f(g)",
    "x",
    "p",
    "g",
    "r_1",
    "r_2",
    "\\omega v",
    "c_1 r_1 (p - x)",
    "c_2 r_2 (g - x)",
    "v",
    "x'",
    "r",
    "r'",
    "x_t",
    "s_1",
    "s_2",
    "F_L",
    "\\omega",
    "c_1",
    "c_2",
    "t",
    "\\varphi",
    "u",
    "\\pm",
    "m",
    "ip",
    "gs",
    "\\alpha",
    "f(P)",
    "f(G)",
    "f(X)",
    "P",
    "G",
    "X",
    "X'",
    "\\sigma(P)",
    "\\sigma(X)",
    "f",
    "A",
    "\\bar A",
    "\\epsilon",
    "\\beta",
    "\\sigma",
    "s",
    "H",
    "x_j",
    "x_k",
];

/// What the numbers of an inspection are called: name, TeX, a few words.
pub(super) type Label = (&'static str, &'static str, &'static str);

const COST: [Label; 1] = [("cost", "f(x)", "cost")];
const START: [Column; 1] = [column("x", "x", "position")];

pub(super) fn quantities(labels: &[Label], values: &[f64]) -> impl Iterator<Item = Quantity> {
    labels.iter().zip(values).map(|(&(name, symbol, title), &value)| Quantity { name, symbol, title, value })
}

pub(super) const fn column(name: &'static str, symbol: &'static str, title: &'static str) -> Column {
    Column { name, symbol, title }
}

/// The particle that an item means, if there is one.
pub(super) fn particle(population: &Population, item: Item) -> Option<usize> {
    let known = [layers::PARTICLES.key, layers::PERSONAL_BESTS.key].contains(&item.layer);
    (known && item.index < population.size).then_some(item.index)
}

/// The particle before anything has moved it.
pub(super) fn introduce(population: &Population, item: Item, moreover: &str) -> Option<Inspection> {
    introduce_as(population, item, &format!("drawn at random{moreover}"))
}

/// The same, and where it comes from.
pub(super) fn introduce_as(population: &Population, item: Item, origin: &str) -> Option<Inspection> {
    let i = particle(population, item)?;
    let (meaning, x) = (&*population.objective, &population.x[population.row(i)]);
    let summary = format!("Particle {i} begins here, {origin}.");
    let mut told = sheet(meaning, item, "start", summary, x.len());
    told.columns = START.to_vec();
    told.rows = x.iter().map(|&x| vec![x]).collect();
    told.values.extend(quantities(&COST, &[population.cost[i]]));
    told.marks = vec![mark(meaning, layers::AFTER.key, x)];
    Some(told)
}

pub(super) fn sheet(meaning: &dyn Objective, item: Item, event: &'static str, summary: String, dimension: usize) -> Inspection {
    Inspection {
        item,
        title: format!("Particle {}", item.index),
        event,
        summary,
        values: Vec::new(),
        formulas: Vec::new(),
        columns: Vec::new(),
        labels: (0..dimension).map(|j| meaning.coordinate(j)).collect(),
        rows: Vec::new(),
        marks: Vec::new(),
    }
}

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

pub(super) fn arrows(meaning: &dyn Objective, layer: LayerKey, from: &[f64], to: &[f64]) -> Mark {
    let vertices = meaning.points(from).zip(meaning.points(to)).flat_map(|(a, b)| [a, b]).collect();
    Mark::plane(layer, Shape::Segments, vertices)
}
