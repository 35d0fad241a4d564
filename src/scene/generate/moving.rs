//! Discs that move about on a grid, [WOLF-ANT](crate#papers) §5.3: each begins at a point of the grid that is drawn evenly, in
//! any direction. Walls do not stop them, so they may begin in one.

use std::f64::consts::TAU;

use crate::{
    kernel::rng::Stream,
    math,
    params::{Param, Parameter, Parameters},
    scene::{GridScene, Moving, Robot},
};

use super::plot::STOPS;

pub(super) const MOVING: Param<u64> = Param::integer(
    "moving",
    "",
    "Moving obstacles",
    [0, 100, 0],
    "How many discs move about, each straight on at a speed of its own, walls or not. At time 0 they are clear of the start: a \
     robot with a radius of half a cell has a margin of half a cell there.",
)
.slider(0.0, 20.0, false);

pub(super) const MOVING_SPEED: Param<f64> = Param::number(
    "moving_speed",
    "",
    "Their speed",
    [0.0, 100.0, 1.0],
    "How fast the fastest may be, in cells a second; none is slower than a quarter of that. The robot drives one cell a second.",
)
.slider(0.0, 3.0, false);

pub(super) const MOVING_RADIUS: Param<f64> = Param::number(
    "moving_radius",
    "",
    "Their radius",
    [0.01, 100.0, 0.5],
    "How large the largest may be, in cells; none is smaller than a quarter of that.",
)
.slider(0.1, 3.0, true);

/// What can be put on a grid once it is drawn: the last parameters of every generator of grids.
pub(super) const STOPS_AND_MOVING: &[Parameter] = &[STOPS.entry(), MOVING.entry(), MOVING_SPEED.entry(), MOVING_RADIUS.entry()];

/// The least speed and radius, as a share of the greatest.
const LEAST: f64 = 0.25;

/// The robot's radius and its margin, in cells, together: nothing that moves begins nearer to the start.
const APART: f64 = 0.5 + 0.5;

/// How often another disc is drawn for one that begins too near to the start.
const TRIES: usize = 1000;

/// Puts up to as many discs on a grid as the parameters say, and a robot that meets them; returns how many there was room for.
pub(super) fn place(grid: &mut GridScene, parameters: &Parameters, stream: &mut Stream) -> usize {
    let [fastest, largest] = [parameters[MOVING_SPEED], parameters[MOVING_RADIUS]].map(|most| most * grid.cell);
    let max = grid.bounds().max;
    let clear = |disc: &Moving| {
        let apart = disc.radius + APART * grid.cell;
        grid.start.is_none_or(|start| {
            let [x, y] = [0, 1].map(|axis| disc.center[axis] - start[axis]);
            x * x + y * y > apart * apart
        })
    };
    // The whole disc is drawn anew: where there is little room small ones find it. Where one finds none, nor will the others.
    let one = |stream: &mut Stream| (0..TRIES).map(|_| disc(max, fastest, largest, stream)).find(clear);
    grid.moving = (0..parameters[MOVING]).map_while(|_| one(stream)).collect();
    grid.robot.get_or_insert(Robot { speed: Some(grid.cell), turn_time: Some(1.0), ..Robot::default() });
    grid.moving.len()
}

fn disc(max: [f64; 2], fastest: f64, largest: f64, stream: &mut Stream) -> Moving {
    let center = max.map(|side| stream.between(0.0, side));
    let radius = stream.between(LEAST, 1.0) * largest;
    let (speed, angle) = (stream.between(LEAST, 1.0) * fastest, TAU * stream.unit());
    // + 0.0: no −0.
    Moving::straight(center, radius, [math::cos(angle), math::sin(angle)].map(|share| speed * share + 0.0))
}
