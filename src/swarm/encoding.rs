//! How a position stands for a path: the parameters that every swarm has on scenes with a way to find.

use std::sync::Arc;

use crate::{
    kernel::Error,
    params::{Choice, Fixed, Parameter, Settings},
    scene::{DISCS, DiscsScene, FunctionScene, GRID, GridScene, Scene},
};

use super::{
    objective::{FunctionObjective, Objective},
    parameters::PATHS,
    polar::Polar,
    terrain::Terrain,
    waypoints::Waypoints,
};

/// What a swarm minimises on this scene. This is where a position's meaning is chosen; what moves the particles does
/// not know it.
///
/// # Errors
/// A grid without start and goal.
pub(super) fn objective(scene: &Scene, settings: &Settings) -> Result<Arc<dyn Objective>, Error> {
    if let Ok(function) = scene.get::<FunctionScene>() {
        return Ok(Arc::new(FunctionObjective::new(function)));
    }
    let terrain = if let Ok(discs) = scene.get::<DiscsScene>() {
        Terrain::among_discs(discs, settings)
    } else if let Ok(grid) = scene.get::<GridScene>() {
        Terrain::on_grid(grid, settings)?
    } else {
        // The entries say that swarms do not run there.
        return Err(Error::refused("kind", scene.kind().name(), "function, discs or grid"));
    };
    Ok(match settings.choice("encoding") {
        "polar" => Arc::new(Polar::new(terrain, settings)),
        _ => Arc::new(Waypoints::new(terrain, settings)),
    })
}

/// A swarm's own parameters, and then those of every swarm: when to stop, and how paths are encoded, charged and smoothed.
/// After `@` and before `;`: another `ENCODING` and `WAYPOINTS`, whose defaults differ.
macro_rules! with_paths {
    (@ $encoding:expr, $waypoints:expr; $($own:expr),* $(,)?) => {
        &[
            $($own,)*
            $crate::swarm::encoding::EARLY_STOP,
            $encoding,
            $waypoints,
            $crate::swarm::encoding::ORDERED,
            $crate::swarm::encoding::SEGMENTS,
            $crate::swarm::encoding::INITIAL,
            $crate::swarm::encoding::INITIAL_MEAN,
            $crate::swarm::encoding::INITIAL_STD,
            $crate::swarm::encoding::REDRAWS,
            $crate::swarm::encoding::F1,
            $crate::swarm::encoding::F2,
            $crate::swarm::encoding::PENALTY,
            $crate::swarm::encoding::PENALTY_WEIGHT,
            $crate::swarm::encoding::SMOOTH,
            $crate::swarm::encoding::SMOOTHING,
            $crate::swarm::encoding::PASSES,
        ]
    };
    ($($own:expr),* $(,)?) => {
        $crate::swarm::encoding::with_paths![@ $crate::swarm::encoding::ENCODING, $crate::swarm::encoding::WAYPOINTS; $($own),*]
    };
}
pub(super) use with_paths;

pub(super) const EARLY_STOP: Parameter = Parameter::integer(
    "early_stop",
    "k_s",
    "Early stop",
    [0, 1_000_000_000, 0],
    "Stop when the best has not changed for this many iterations; 0: never. [LTQPSO] §4 (9) stops, but gives no number.",
)
.slider(0.0, 200.0, false);
pub(super) const ENCODING: Parameter = Parameter::choice(
    "encoding",
    "",
    "A path is",
    &[
        Choice { value: "waypoints", title: "way-points", help: "Points anywhere in the bounds, [WCPSO] §3.2.2." },
        Choice { value: "polar", title: "angles on circles", help: "A point on each of several circles about the start, [LTQPSO] §4." },
    ],
    "How a particle’s coordinates encode a path. A few coordinates describe only a path with few turns; in rooms and mazes use ants or a graph search.",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Text("polar"))]);
pub(super) const WAYPOINTS: Parameter = Parameter::integer(
    "waypoints",
    "n",
    "Way-points",
    [1, 50, 3],
    "How many corners a path may have between start and goal; a particle has twice as many coordinates. The paper gives no value.",
)
.only_on(PATHS)
.when("encoding", "waypoints")
.slider(1.0, 20.0, false);
pub(super) const ORDERED: Parameter = Parameter::flag(
    "ordered",
    "Sorted start",
    true,
    "Number each path’s initial way-points along the way from start to goal, so that none begins as a zigzag. Off: as drawn, uniformly (the paper says no more).",
)
.only_on(PATHS)
.when("encoding", "waypoints");
pub(super) const SEGMENTS: Parameter = Parameter::integer(
    "segments",
    "D",
    "Segments",
    [2, 100, 8],
    "How many pieces a path has, so D − 1 circles lie between start and goal, and a particle is their angles. Published: 8 and 16; (12) has D = distance / robot length.",
)
.only_on(PATHS)
.when("encoding", "polar")
.slider(2.0, 40.0, false);
pub(super) const INITIAL: Parameter = Parameter::choice(
    "initial",
    "",
    "Initial angles",
    &[
        Choice { value: "uniform", title: "uniform", help: "Over each circle’s whole range, (15)." },
        Choice { value: "normal", title: "normal", help: "Normally distributed, cut off at the ends of the range." },
    ],
    "How the first angles are drawn.",
)
.only_on(PATHS)
.when("encoding", "polar");
pub(super) const INITIAL_MEAN: Parameter = Parameter::number(
    "initial_mean",
    "\\mu",
    "Mean angle",
    [-180.0, 180.0, 45.0],
    "In degrees from the x axis. Published: 45° in Table 4, 30° in the text.",
)
.only_on(PATHS)
.when("initial", "normal");
pub(super) const INITIAL_STD: Parameter = Parameter::number(
    "initial_std",
    "\\sigma",
    "Spread of angles",
    [0.0, 180.0, 30.0],
    "The standard deviation in degrees. Published: 30° in Table 4, 45° in the text.",
)
.only_on(PATHS)
.when("initial", "normal")
.slider(1.0, 90.0, false);
pub(super) const REDRAWS: Parameter = Parameter::integer(
    "redraws",
    "n_r",
    "Redraws",
    [0, 1000, 0],
    "How often an angle whose piece of the path collides is drawn again at the start, and then a particle that still collides, [LTQPSO] §4 (5); 20,000 particles in all. Each particle counts as an evaluation.",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Number(100.0))])
.slider(0.0, 1000.0, false);
pub(super) const F1: Parameter =
    Parameter::number("f1", "f_1", "Weight of length", [0.0, 1e6, 1.0], "f1 of [LTQPSO] (16).").only_on(PATHS).slider(0.0, 10.0, false);
pub(super) const F2: Parameter = Parameter::number(
    "f2",
    "f_2",
    "Weight of smoothness",
    [0.0, 1e6, 0.0],
    "f2 of [LTQPSO] (16): what uneven pieces cost. The paper gives no value; 0.01 on grids is ours, 0 among discs is [WCPSO] (14).",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Number(0.01))])
.slider(0.0, 1.0, false);
pub(super) const PENALTY: Parameter = Parameter::choice(
    "penalty",
    "V",
    "Penalty",
    &[
        Choice { value: "segments", title: "whole path", help: "(15) at each segment’s point closest to the disc’s centre." },
        Choice { value: "waypoints", title: "way-points only", help: "(15) as printed: a segment may cut through a disc unpunished." },
    ],
    "Where a path is tested for discs.",
)
.only_on(&[DISCS]);
pub(super) const PENALTY_WEIGHT: Parameter = Parameter::number(
    "penalty_weight",
    "w",
    "Penalty weight",
    [0.0, 1e6, 100.0],
    "Among discs the safety factor w of (14): what a path through a disc’s centre costs. On grids what a unit of length inside obstacles costs; that paper gives no value.",
)
.only_on(PATHS)
.defaults_on(&[(GRID, Fixed::Number(10.0))])
.slider(1.0, 1000.0, true);
pub(super) const SMOOTH: Parameter =
    Parameter::flag("smooth", "Smoothing", false, "Smooth the result with a Shuman filter that never leaves free space, [LTQPSO] §4 (9).")
        .only_on(PATHS)
        .defaults_on(&[(GRID, Fixed::Flag(true))]);
pub(super) const SMOOTHING: Parameter = Parameter::number(
    "smoothing",
    "S",
    "Strength",
    [0.0, 1.0, 0.5],
    "S of the filter s = (1 − S) f + S/2 (f before + f after). The paper gives no value.",
)
.only_on(PATHS)
.when("smooth", "true");
pub(super) const PASSES: Parameter = Parameter::integer(
    "passes",
    "n_S",
    "Passes",
    [0, 1000, 20],
    "How often the filter is applied, to eight points on each segment. The paper gives no value.",
)
.only_on(PATHS)
.when("smooth", "true")
.slider(0.0, 100.0, false);
