//! What can be set about a drive, what it tells, and the equations it carries out.

use crate::{
    describe::{Column, Formula},
    params::{Param, Parameter},
    scene::{LARGEST, Robot, SMALLEST_CELL},
};

/// Everything that can be set. The figures are those of the paper’s robot, in metres and seconds; look-ahead excepted.
/// Beside a path on which the circle about the robot just touches, its outline has 0.1 m to spare. On the 10 m grid it
/// keeps 0.08 m of that when it looks 0.35 m ahead; with 0.25 m it keeps a centimetre more and takes a second longer,
/// with 0.8 m hardly any is left.
/// (Its mass, 2.3 kg, is not among them: how it moves is given, not what forces it takes.)
pub const PARAMETERS: &[Parameter] = &[
    SPEED.entry(),
    TURN_RATE.entry(),
    PERIOD.entry(),
    LOOK_AHEAD.entry(),
    WHEEL_RADIUS.entry(),
    WHEEL_DISTANCE.entry(),
    PULSES.entry(),
    DECODER.entry(),
    GEAR.entry(),
];

/// Any speed of a scene's robot, whose cells may have any size, and lengths to go with it.
pub(super) const ANY: [f64; 2] = [Robot::SPEEDS[0] * SMALLEST_CELL, Robot::SPEEDS[1] * LARGEST];

/// How fast it drives at most.
pub const SPEED: Param<f64> = Param::number(
    "speed",
    "v_{\\max}",
    "Top speed",
    [ANY[0], ANY[1], 0.24],
    "How fast the robot drives at most, a second. Published: 0.24 m/s; a scene’s robot may say otherwise.",
)
.slider(0.02, 2.0, true);
pub(super) const TURN_RATE: Param<f64> = Param::number(
    "turn_rate",
    "\\omega_{\\max}",
    "Top turn rate",
    [0.001, 10.0, 0.2],
    "How fast the robot turns at most, in radians a second. Published: 0.2.",
)
.slider(0.05, 3.0, true);
pub(super) const PERIOD: Param<f64> =
    Param::number("period", "T", "Control period", [0.01, 2.0, 0.4], "Seconds from one command to the next. Published: 0.4.")
        .slider(0.05, 1.0, false);
pub(super) const LOOK_AHEAD: Param<f64> = Param::number(
    "look_ahead",
    "L_d",
    "Look-ahead distance",
    [ANY[0], ANY[1], 0.35],
    "How far ahead the point lies that the robot steers for. Shorter keeps closer to the path, longer goes faster round \
         corners. It must be well more than the way of one period. The paper gives none; 0.35 m is a little less than its \
         robot’s length.",
)
.slider(0.1, 2.0, true);
pub(super) const WHEEL_RADIUS: Param<f64> =
    Param::number("wheel_radius", "R", "Wheel radius", [ANY[0], ANY[1], 0.068], "Of the driven wheels. Published: 0.068 m.")
        .slider(0.02, 0.2, false);
pub(super) const WHEEL_DISTANCE: Param<f64> =
    Param::number("wheel_distance", "b", "Wheel distance", [ANY[0], ANY[1], 0.3], "Between the driven wheels. Published: 0.3 m.")
        .slider(0.1, 1.0, false);
pub(super) const PULSES: Param<u64> =
    Param::integer("pulses", "n_p", "Encoder pulses", [1, 100_000, 16], "Pulses a turn of the motor. Published: 16.")
        .slider(1.0, 1000.0, true);
pub(super) const DECODER: Param<u64> =
    Param::integer("decoder", "n_d", "Decoder", [1, 4, 2], "How many edges of a pulse are counted. Published: 2.");
pub(super) const GEAR: Param<u64> =
    Param::integer("gear", "n_g", "Gear ratio", [1, 10_000, 131], "Turns of the motor a turn of the wheel. Published: 131.")
        .slider(1.0, 300.0, true);

/// The numbers of a row: where the robot is at the end of a period, and what it was to do in it (at the start, nothing).
/// Without obstacles the clearance is infinite.
pub const COLUMNS: &[Column] = &[
    Column::new("time", "t", "Time", "s"),
    Column::new("x", "x", "Centre, x", "m"),
    Column::new("y", "y", "Centre, y", "m"),
    Column::new("heading", "\\theta", "Heading, from x towards y", "rad"),
    Column::new("speed", "v", "Speed", "m/s"),
    Column::new("turn_rate", "\\omega", "Turn rate, from x towards y", "rad/s"),
    Column::new("left", "\\omega_l", "Left wheel", "rad/s"),
    Column::new("right", "\\omega_r", "Right wheel", "rad/s"),
    Column::new("left_count", "N_l", "Left encoder", ""),
    Column::new("right_count", "N_r", "Right encoder", ""),
    Column::new("error", "e", "Off the path, to the left", "m"),
    Column::new("clearance", "d", "From the nearest obstacle", "m"),
];

pub(super) const FORMULAS: &[Formula] = &[
    Formula::new("curvature", "Coulter, CMU-RI-TR-92-01", "Pure pursuit", "\\kappa = \\frac{2 \\sin\\eta}{L_d}", ""),
    Formula::new(
        "command",
        "limits of [LTQPSO] §5",
        "Command",
        "v = \\min\\left(v_{\\max},\\, \\frac{\\omega_{\\max}}{|\\kappa|}\\right), \\quad \\omega = \\kappa v",
        "",
    ),
    Formula::new(
        "wheels",
        "differential drive",
        "Wheel speeds",
        "\\omega_l = \\frac{v - \\omega b / 2}{R}, \\quad \\omega_r = \\frac{v + \\omega b / 2}{R}",
        "",
    ),
    Formula::new(
        "counts",
        "[LTQPSO] §5",
        "Encoder counts",
        "N = \\left\\lfloor \\frac{n_p\\, n_d\\, n_g}{2\\pi} \\int \\omega_{l,r}\\, \\mathrm{d}t \\right\\rfloor",
        "",
    ),
];
