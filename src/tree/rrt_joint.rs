//! `rrt-joint`: RRT-Connect in an arm's six joints, where the whole arm must be free: the way it is done today.

use std::sync::Arc;

use crate::{
    describe::{Entry, Member},
    params::Param,
    scene::ARM,
};

use super::{
    draw::CONNECT_LAYERS,
    finish::{FITTED, HERMITE},
    grow::Grown,
    joints::{GOALS, Joints, RADIUS, RESOLUTION},
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
    parameters: &[&[
        ITERATIONS.entry(),
        STEP_ANGLE.entry(),
        GOALS.entry(),
        RADIUS.entry(),
        RESOLUTION.entry(),
        SHORTEN.entry(),
        POLYLINE.entry(),
        TOLERANCE.entry(),
        SMOOTH.entry(),
        BLEND.entry(),
    ]],
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

const STEP_ANGLE: Param<f64> = Param::number(
    "step_size",
    "L",
    "Step size",
    [0.001, 10.0, 0.1],
    "How far a node grows: the root of the sum of the squares of the joints’ turns, in radians.",
)
.slider(0.01, 1.0, true);
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
