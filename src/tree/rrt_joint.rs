//! `rrt-joint`: RRT-Connect in an arm's six joints, where the whole arm must be free: the way it is done today.

use std::sync::Arc;

use crate::{
    describe::{Entry, Member},
    params::Parameter,
    scene::ARM,
};

use super::{
    draw::CONNECT_LAYERS,
    finish::{FITTED, HERMITE},
    grow::Grown,
    joints::Joints,
    parameters::{BLEND, FORMULA_STEP, ITERATIONS, POLYLINE, READINGS, SHORTEN, SMOOTH, TOLERANCE},
    rrt_connect::Connect,
    task::Task,
};

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "rrt-joint",
    title: "RRT-Connect in the joints",
    family: "tree",
    source: "Kuffner and LaValle 2000",
    summary: "Two trees of postures: one from the posture at the start, one from several at the goal. Every step is tested with all the arm’s links. The tip’s path follows from the joints, not the other way round.",
    kinds: &[ARM],
    stops: false,
    most_stops: None,
    parameters: &[ITERATIONS, STEP, GOALS, RADIUS, RESOLUTION, SHORTEN, POLYLINE, TOLERANCE, SMOOTH, BLEND],
    readings: READINGS,
    formulas: &[FORMULA_STEP, FITTED, HERMITE],
    layers: CONNECT_LAYERS,
    members: MEMBERS,
    events: &[],
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, seed| {
        let joints = Joints::new(scene, settings)?;
        Ok(Grown::new(Task::new(Arc::new(joints), settings, 0.0), Connect::default(), seed).into())
    },
};

const STEP: Parameter = Parameter::number(
    "step_size",
    "L",
    "Step size",
    [0.001, 10.0, 0.1],
    "How far a node grows: the root of the sum of the squares of the joints’ turns, in radians.",
)
.slider(0.01, 1.0, true);
const GOALS: Parameter = Parameter::integer(
    "goals",
    "n_g",
    "Goal postures",
    [1, 300, 8],
    "In how many postures the arm may end: of those at the goal that touch nothing, the ones nearest to the first.",
)
.slider(1.0, 50.0, false);
const RADIUS: Parameter = Parameter::number(
    "radius",
    "r",
    "Radius of the links",
    [0.0, 1.0, 0.0],
    "In metres. The links are their skeleton, grown by this. In the paper 0.",
)
.slider(0.0, 0.1, false);
const RESOLUTION: Parameter = Parameter::number(
    "resolution",
    "\\delta",
    "Resolution",
    [1e-4, 0.1, 0.005],
    "How far any point of a link may go between two tests, in metres, where a cuboid is near; and how far the links keep away, so that nothing is touched in between.",
)
.slider(1e-3, 0.05, true);

const MEMBERS: &[Member] = &[
    member("parent", "", "Parent", "The number of the node that it has grown from; −1: the root."),
    Member { name: "tree", symbol: "", title: "Tree", help: "Which tree it belongs to.", full: None, words: &["start", "goal"] },
    member("q1", "\\theta_1", "Joint 1", "In degrees."),
    member("q2", "\\theta_2", "Joint 2", "In degrees."),
    member("q3", "\\theta_3", "Joint 3", "In degrees."),
    member("q4", "\\theta_4", "Joint 4", "In degrees."),
    member("q5", "\\theta_5", "Joint 5", "In degrees."),
    member("q6", "\\theta_6", "Joint 6", "In degrees."),
];

const fn member(name: &'static str, symbol: &'static str, title: &'static str, help: &'static str) -> Member {
    Member { name, symbol, title, help, full: None, words: &[] }
}
