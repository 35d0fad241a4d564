//! `rrt-joint`: RRT-Connect in an arm's six joints, where the whole arm must be free: the way it is done today.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Member, Start},
    kernel::{Error, Started},
    params::Param,
    scene::ARM,
};

use super::{
    draw::CONNECT_LAYERS,
    finish::{FITTED, HERMITE},
    joints::{GOALS, Joints, RADIUS, RESOLUTION},
    parameters::{BLEND, FORMULA_STEP, ITERATIONS, POLYLINE, READINGS, SHORTEN, SMOOTH, TOLERANCE},
    rrt_connect,
};

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "cuboid",
        "Trees of postures",
        "The whole arm keeps clear. The same tree is shown in pairs of joints and in space.",
        "arm-cuboid",
        &[],
    ),
    Case::new("puma", "Another arm: PUMA 560", "Its postures, its motion and its reach follow from a table of joints.", "arm-puma", &[]),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "one tree begins at the first posture, one at up to @goals@ postures at the goal",
    "repeat until they meet:",
    "  draw random joint angles; the nearest posture of one tree turns by @step_size@ rad toward them",
    "  if no link touches anything on the way: the other tree turns straight toward it",
    "  the trees change places",
    "  postures: @nodes@, rejected: @rejected@",
    "follow both trees from where they meet: the tip’s path is @final_length@ long",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "rrt-joint",
    "RRT-Connect in the joints",
    "Kuffner and LaValle 2000",
    "Two trees of postures: one from the posture at the start, one from several at the goal. Every step is tested with all the arm’s links. The tip’s path follows from the joints, not the other way round.",
    start,
)
.family("tree")
.evaluating(crate::tree::EVALUATION)
.kinds(&[ARM])
.parameters(&[
    &[ITERATIONS.entry(), STEP_ANGLE.entry(), GOALS.entry(), RADIUS.entry(), RESOLUTION.entry()],
    &[SHORTEN.entry(), POLYLINE.entry(), TOLERANCE.entry(), SMOOTH.entry(), BLEND.entry()],
])
.readings(READINGS)
.formulas(&[FORMULA_STEP, FITTED, HERMITE])
.layers(CONNECT_LAYERS)
.members(MEMBERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

fn start(start: &Start) -> Result<Started, Error> {
    rrt_connect::on(Arc::new(Joints::new(start.scene, start.parameters)?), start.parameters, start.seed)
}

const STEP_ANGLE: Param<f64> = Param::number(
    "step_size",
    "L",
    "Step size",
    [0.001, 10.0, 0.1],
    "How far a node grows: the root of the sum of the squares of the joints’ turns, in radians.",
)
.slider(0.01, 1.0, true);
const MEMBERS: &[Member] = &[
    Member::new("parent", "", "Parent", "The number of the node that it has grown from; −1: the root."),
    Member::new("tree", "", "Tree", "Which tree it belongs to.").words(&["start", "goal"]),
    Member::new("q1", "\\theta_1", "Joint 1", "In degrees."),
    Member::new("q2", "\\theta_2", "Joint 2", "In degrees."),
    Member::new("q3", "\\theta_3", "Joint 3", "In degrees."),
    Member::new("q4", "\\theta_4", "Joint 4", "In degrees."),
    Member::new("q5", "\\theta_5", "Joint 5", "In degrees."),
    Member::new("q6", "\\theta_6", "Joint 6", "In degrees."),
];
