//! What can be set about a motion, what it tells, and the equations it carries out.

use crate::{
    describe::{Column, Formula},
    params::{Choice, Param, ParamValue, Parameter},
};

pub(super) const PARAMETERS: &[Parameter] = &[
    SPACING.entry(),
    ORIENTATION.entry(),
    SPREAD.entry(),
    NEAREST.entry(),
    RADIUS.entry(),
    REPLACEMENT.entry(),
    TRIES.entry(),
    SPEED.entry(),
    TOOL_SPEED.entry(),
    RESOLUTION.entry(),
    SEED.entry(),
];

/// How the tool is turned at the points of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Orientation {
    /// As suits the arm best.
    Free,
    /// As in the home posture.
    Home,
    /// At random.
    Random,
}

impl ParamValue for Orientation {}

pub(super) const SPACING: Param<f64> = Param::number(
    "spacing",
    "\\Delta s",
    "Spacing",
    [0.002, 1.0, 0.01],
    "How far apart the points of the path are, in metres, at which the arm takes a posture; corners and ends are always among \
         them. Ours: the paper takes the points of its smoothed path.",
)
.slider(0.002, 0.1, true);
pub(super) const ORIENTATION: Param<Orientation> = Param::choice(
    "orientation",
    "",
    "Where the tool points",
    &[
        Choice::new("free", "anywhere", "Whatever suits the arm best. The paper does not say."),
        Choice::new("home", "as at home", "The tool keeps the orientation that it has in the home posture. The paper does not say."),
        Choice::new(
            "random",
            "at random",
            "Turned by three random angles at every point, about z, then y, then x. Published: 2*(rand(1,3)-0.5), step 4.",
        ),
    ],
    &[Orientation::Free, Orientation::Home, Orientation::Random],
    "How the tool is turned at each point of the path, which says only where its tip is.",
);
pub(super) const SPREAD: Param<f64> = Param::number(
    "spread",
    "\\varphi_{\\max}",
    "Spread of the random angles",
    [0.0, 3.2, 1.0],
    "The random angles are uniform from minus to plus this, in radians. Published: 1.",
)
.when(ORIENTATION, "random")
.slider(0.0, 1.0, false);
pub(super) const NEAREST: Param<bool> = Param::choice(
    "postures",
    "",
    "Which posture",
    &[
        Choice::new(
            "smoothest",
            "smoothest on the whole",
            "Of all ways through all points’ postures the one whose joints turn most gently, among those that touch \
                       nothing. The paper does not say.",
        ),
        Choice::new(
            "nearest",
            "nearest to the last",
            "At each point the one nearest to that before (at the first: to home), one that touches nothing if there is any. \
                       Published.",
        ),
    ],
    &[false, true],
    "Most points can be reached in several postures.",
);
pub(super) const RADIUS: Param<f64> = Param::number(
    "radius",
    "r",
    "Link radius",
    [0.0, 0.5, 0.0],
    "The links are that thick, in metres. Published: none, only the skeleton.",
)
.slider(0.0, 0.1, false);
pub(super) const REPLACEMENT: Param<bool> = Param::flag(
    "replacement",
    "Replace points",
    true,
    "Whether a point without a posture is mirrored or drawn at random, [ARM-RRT] steps 4 and 6. Off: the motion ends there.",
);
pub(super) const TRIES: Param<u64> = Param::integer(
    "tries",
    "",
    "Tries",
    [0, 100_000, 1000],
    "How often joints are drawn at random for a point without a posture before the motion ends there. The paper sets no limit.",
)
.when(REPLACEMENT, "true");
pub(super) const SPEED: Param<f64> = Param::number(
    "speed",
    "\\kappa",
    "Share of the joints’ speeds",
    [0.001, 1.0, 1.0],
    "How much of their speed limits the joints may use. Ours: the paper gives no speeds.",
)
.slider(0.05, 1.0, false);
pub(super) const TOOL_SPEED: Param<f64> = Param::number(
    "tool_speed",
    "v_{\\max}",
    "Tool speed",
    [0.001, 100.0, 0.5],
    "How fast the tip goes at most, in metres a second. The paper gives no value.",
)
.slider(0.05, 5.0, true);
pub(super) const RESOLUTION: Param<f64> = Param::number(
    "resolution",
    "\\varepsilon",
    "Resolution of the collision test",
    [0.000_01, 0.1, 0.001],
    "Where there is less room than this, in metres, no point of a link goes farther between two tests. Where there is more, the \
         test needs no samples and is exact.",
)
.slider(0.0001, 0.02, true);
pub(super) const SEED: Param<u64> = Param::integer(
    "seed",
    "",
    "Seed",
    [0, crate::kernel::limits::WHOLE, 1],
    "Of what is random: the tool’s angles, and joints drawn for points without a posture.",
);

/// The numbers of a row. Angles are degrees, lengths metres.
pub(super) const COLUMNS: &[Column] = &[
    Column::new("time", "t", "Time", "s"),
    Column::new("along", "s", "Along the path", "m"),
    Column::new("x", "x", "Tip, x", "m"),
    Column::new("y", "y", "Tip, y", "m"),
    Column::new("z", "z", "Tip, z", "m"),
    Column::new("q1", "\\theta_1", "Joint 1", "°"),
    Column::new("q2", "\\theta_2", "Joint 2", "°"),
    Column::new("q3", "\\theta_3", "Joint 3", "°"),
    Column::new("q4", "\\theta_4", "Joint 4", "°"),
    Column::new("q5", "\\theta_5", "Joint 5", "°"),
    Column::new("q6", "\\theta_6", "Joint 6", "°"),
    Column::new("clearance", "d", "From the nearest cuboid", "m"),
];

pub(super) const FORMULAS: &[Formula] = &[
    Formula::new(
        "forward",
        "[ARM-RRT] (1)",
        "Forward kinematics",
        "{}^0T_6 = \\prod_{i=1}^{6} R_x(\\alpha_{i-1})\\, T_x(a_{i-1})\\, R_z(\\theta_i)\\, T_z(d_i)",
        "",
    ),
    Formula::new(
        "smoothest",
        "ours",
        "What is least for the smoothest postures",
        "\\sum_k \\frac{\\lVert \\theta_{k+1} - \\theta_k \\rVert^2}{s_{k+1} - s_k}",
        "",
    ),
    Formula::new("limits", "[ARM-RRT] Table 1", "Limits", "\\theta_i^{\\min} \\le \\theta_i \\le \\theta_i^{\\max}", ""),
    Formula::new("mirror", "[ARM-RRT] step 4", "A point without a posture is mirrored", "p_k \\leftarrow p_{k-1} + p_{k+1} - p_k", ""),
    Formula::new(
        "draw",
        "[ARM-RRT] step 6",
        "Then joints are drawn",
        "\\theta_i = \\theta_i^{k-1} + r_i\\, (\\theta_i^{k+1} - \\theta_i^{k-1}), \\quad r_i \\sim U(0,1)",
        "",
    ),
    Formula::new(
        "timing",
        "joint and tool speeds",
        "Time from one row to the next",
        "\\Delta t = \\max\\left( \\max_i \\frac{|\\Delta\\theta_i|}{\\kappa\\, \\omega_i},\\, \\frac{\\lVert \\Delta p \\rVert}{v_{\\max}} \\right)",
        "",
    ),
];
