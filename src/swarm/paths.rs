//! What every swarm has on scenes with a way to find: when to stop, and how paths are encoded, charged and smoothed.

use crate::{
    params::{Choice, Fixed, Param, ParamValue, Parameter},
    scene::{DISCS, GRID},
};

use super::parameters::PATHS;

/// What a position stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    /// Points anywhere in the bounds.
    Waypoints,
    /// Angles on circles about the start.
    Polar,
}

impl ParamValue for Encoding {}

/// How the first angles are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Angles {
    /// Uniformly.
    Uniform,
    /// Normally.
    Normal,
}

impl ParamValue for Angles {}

/// Where (15) looks for a path in a disc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Penalty {
    /// At the way-points, as printed. A segment may cut through a disc unpunished.
    Waypoints,
    /// At each segment's point closest to the disc's centre (our reading).
    Segments,
}

impl ParamValue for Penalty {}

/// When to stop, and what a position stands for; a swarm's own parameters come before.
pub(super) const ENCODED: &[Parameter] = &[EARLY_STOP.entry(), ENCODING.entry(), WAYPOINTS.entry()];
/// How that is drawn at first, charged and smoothed.
pub(super) const CHARGED: &[Parameter] = &[
    ORDERED.entry(),
    SEGMENTS.entry(),
    INITIAL.entry(),
    INITIAL_MEAN.entry(),
    INITIAL_STD.entry(),
    REDRAWS.entry(),
    F1.entry(),
    F2.entry(),
    PENALTY.entry(),
    PENALTY_WEIGHT.entry(),
    SMOOTH.entry(),
    SMOOTHING.entry(),
    PASSES.entry(),
];

/// Without a better position for so many iterations a swarm stops.
pub const EARLY_STOP: Param<u64> = Param::integer(
    "early_stop",
    "k_s",
    "Early stop",
    [0, 1_000_000_000, 0],
    "Stop when the best has not changed for this many iterations; 0: never. [LTQPSO] §4 (9) stops, but gives no number.",
)
.slider(0.0, 200.0, false);
pub(super) const ENCODING: Param<Encoding> = Param::choice(
    "encoding",
    "",
    "A path is",
    &[
        Choice::new("waypoints", "way-points", "Points anywhere in the bounds, [WCPSO] §3.2.2."),
        Choice::new("polar", "angles on circles", "A point on each of several circles about the start, [LTQPSO] §4."),
    ],
    &[Encoding::Waypoints, Encoding::Polar],
    "How a particle’s coordinates encode a path. A few coordinates describe only a path with few turns; in rooms and mazes use ants or a graph search.",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Text("polar"))]);
pub(super) const WAYPOINTS: Param<u64> = Param::integer(
    "waypoints",
    "n",
    "Way-points",
    [1, 50, 3],
    "How many corners a path may have between start and goal; a particle has twice as many coordinates. The paper gives no value.",
)
.only_on(PATHS)
.when(ENCODING, "waypoints")
.slider(1.0, 20.0, false);
pub(super) const ORDERED: Param<bool> = Param::flag(
    "ordered",
    "Sorted start",
    true,
    "Number each path’s initial way-points along the way from start to goal, so that none begins as a zigzag. Off: as drawn, uniformly (the paper says no more).",
)
.only_on(PATHS)
.when(ENCODING, "waypoints");
pub(super) const SEGMENTS: Param<u64> = Param::integer(
    "segments",
    "D",
    "Segments",
    [2, 100, 8],
    "How many pieces a path has, so D − 1 circles lie between start and goal, and a particle is their angles. Published: 8 and 16; (12) has D = distance / robot length.",
)
.only_on(PATHS)
.when(ENCODING, "polar")
.slider(2.0, 40.0, false);
pub(super) const INITIAL: Param<Angles> = Param::choice(
    "initial",
    "",
    "Initial angles",
    &[
        Choice::new("uniform", "uniform", "Over each circle’s whole range, (15)."),
        Choice::new("normal", "normal", "Normally distributed, cut off at the ends of the range."),
    ],
    &[Angles::Uniform, Angles::Normal],
    "How the first angles are drawn.",
)
.only_on(PATHS)
.when(ENCODING, "polar");
pub(super) const INITIAL_MEAN: Param<f64> = Param::number(
    "initial_mean",
    "\\mu",
    "Mean angle",
    [-180.0, 180.0, 45.0],
    "In degrees from the x axis. Published: 45° in Table 4, 30° in the text.",
)
.only_on(PATHS)
.when(INITIAL, "normal");
pub(super) const INITIAL_STD: Param<f64> = Param::number(
    "initial_std",
    "\\sigma",
    "Spread of angles",
    [0.0, 180.0, 30.0],
    "The standard deviation in degrees. Published: 30° in Table 4, 45° in the text.",
)
.only_on(PATHS)
.when(INITIAL, "normal")
.slider(1.0, 90.0, false);
pub(super) const REDRAWS: Param<u64> = Param::integer(
    "redraws",
    "n_r",
    "Redraws",
    [0, 1000, 0],
    "How often an angle whose piece of the path collides is drawn again at the start, and then a particle that still collides, [LTQPSO] §4 (5); 20,000 particles in all. Each particle counts as an evaluation.",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Number(100.0))])
.slider(0.0, 1000.0, false);
pub(super) const F1: Param<f64> =
    Param::number("f1", "f_1", "Weight of length", [0.0, 1e6, 1.0], "f1 of [LTQPSO] (16).").only_on(PATHS).slider(0.0, 10.0, false);
pub(super) const F2: Param<f64> = Param::number(
    "f2",
    "f_2",
    "Weight of smoothness",
    [0.0, 1e6, 0.0],
    "f2 of [LTQPSO] (16): what uneven pieces cost. The paper gives no value; 0.01 on grids is our choice, 0 among discs is [WCPSO] (14).",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Number(0.01))])
.slider(0.0, 1.0, false);
pub(super) const PENALTY: Param<Penalty> = Param::choice(
    "penalty",
    "V",
    "Penalty",
    &[
        Choice::new("segments", "whole path", "(15) at each segment’s point closest to the disc’s centre."),
        Choice::new("waypoints", "way-points only", "(15) as printed: a segment may cut through a disc unpunished."),
    ],
    &[Penalty::Segments, Penalty::Waypoints],
    "Where a path is tested for discs.",
)
.only_on(&[DISCS]);
pub(super) const PENALTY_WEIGHT: Param<f64> = Param::number(
    "penalty_weight",
    "w",
    "Penalty weight",
    [0.0, 1e6, 100.0],
    "Among discs the safety factor w of (14): what a path through a disc’s centre costs. On grids what a unit of length inside obstacles costs; that paper gives no value.",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Number(10.0))])
.slider(1.0, 1000.0, true);
pub(super) const SMOOTH: Param<bool> =
    Param::flag("smooth", "Smoothing", false, "Smooth the result with a Shuman filter that never leaves free space, [LTQPSO] §4 (9).")
        .only_on(PATHS)
        .defaults_on(&[(GRID, Fixed::Flag(true))]);
pub(super) const SMOOTHING: Param<f64> = Param::number(
    "smoothing",
    "S",
    "Strength",
    [0.0, 1.0, 0.5],
    "S of the filter s = (1 − S) f + S/2 (f before + f after). The paper gives no value.",
)
.only_on(PATHS)
.when(SMOOTH, "true");
pub(super) const PASSES: Param<u64> = Param::integer(
    "passes",
    "n_S",
    "Passes",
    [0, 1000, 20],
    "How often the filter is applied, to eight points on each segment. The paper gives no value.",
)
.only_on(PATHS)
.when(SMOOTH, "true")
.slider(0.0, 100.0, false);
