//! Discs in a square that do not touch each other, so that there is always a path between them: scenes of kind `discs`.

use crate::{
    describe::{Draft, Generator},
    geometry::{Bounds, Disc},
    kernel::{rng::Stream, words},
    params::{Param, Parameters},
    scene::{self, DiscsScene, MAX_DISCS},
};

const COUNT: Param<u64> = Param::integer("discs", "", "Discs", [0, MAX_DISCS as u64, 14], "How many.").slider(0.0, 50.0, false);
const SIDE: Param<f64> =
    Param::number("side", "", "Side", [0.001, 1_000_000.0, 10.0], "Coordinates go from 0 to this.").slider(1.0, 100.0, true);
const RADIUS: Param<f64> =
    Param::number("radius", "", "Largest radius", [0.001, 0.5, 0.15], "As a share of the side; the smallest is a third of it.");

/// Discs in a square.
pub const DISCS: Generator = Generator {
    name: "discs",
    title: "Random discs",
    help: words("Discs in a square that do not touch, and a path from corner to corner."),
    kind: scene::DISCS,
    parameters: &[&[COUNT.entry(), SIDE.entry(), RADIUS.entry()]],
    draw,
};

/// How often another place is tried for a disc that would touch another one, or cover start or goal.
const TRIES: usize = 200;
/// Numbers are multiples of the side's so many-th part: they are read and typed.
const DIGITS: f64 = 1000.0;
/// Between two discs, and from a disc to start and goal, at least: a share of the side.
const GAP: f64 = 0.005;

fn draw(parameters: &Parameters, seed: u64) -> Draft {
    let stream = &mut Stream::new(seed, 0);
    let [side, largest] = [parameters[SIDE], parameters[RADIUS]];
    let count = parameters[COUNT] as usize;
    let (start, goal) = ([0.0; 2], [side; 2]);
    let mut discs: Vec<Disc> = Vec::new();
    for _ in 0..count {
        let free = (0..TRIES).find_map(|_| {
            let mut number = |low: f64, high: f64| (DIGITS * stream.between(low, high)).round() * side / DIGITS;
            let radius = number(largest / 3.0, largest).max(side / DIGITS);
            let center = [number(0.0, 1.0), number(0.0, 1.0)];
            let disc = Disc { center, radius };
            let apart = |other: &Disc| other.clearance(center) >= radius + GAP * side;
            (discs.iter().all(apart) && [start, goal].iter().all(|&end| disc.clearance(end) >= GAP * side)).then_some(disc)
        });
        discs.extend(free);
    }
    let there = discs.len();
    let note = (there < count).then(|| format!("There are {there} discs, not {count}: there is room for no more."));
    let bounds = Bounds { min: start, max: goal };
    Draft { note, ..Draft::new(DiscsScene { bounds, start, goal, discs }, there.to_string()) }
}
