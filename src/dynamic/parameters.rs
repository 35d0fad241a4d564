//! What the entries of the drives share: parameters, readings, equations, layers and kinds of events.

use crate::{
    describe::{EventKind, Formula, Group, Layer, Reading, Tone, layers},
    kernel::{Border, Message, SceneKindId},
    message,
    params::{Choice, Param, ParamValue, Parameter},
    scene::{GRID, Robot},
};

/// The kinds of scene that a robot drives on.
pub(super) const KINDS: &[SceneKindId] = &[GRID];

impl ParamValue for Border {}

/// For drives that do not plan step by step.
pub(super) const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "k_{\\max}",
    "Iterations",
    [1, 1_000_000_000, 1_000_000],
    "After how many periods the drive stops at the latest, arrived or not.",
)
.slider(1.0, 5000.0, true);
pub(super) const BORDER: Param<Border> = Param::choice(
    "border",
    "",
    "At the border obstacles",
    &[
        Choice::new("leave", "Leave", "They go on and are gone."),
        Choice::new("bounce", "Bounce", "They bounce off as soon as they touch it."),
    ],
    &[Border::Leave, Border::Bounce],
    "What obstacles with a velocity do when they come to the border of the grid. Walls inside it do not stop them.",
);
pub(super) const GIVEN: Param<bool> = Param::choice(
    "robot",
    "",
    "Robot",
    &[
        Choice::new(
            "scene",
            "As the scene says",
            "What its robot leaves open: radius (where it has no length and width either) and margin half a cell, a cell a second, a second a turn, sensor 8 cells, 6 seconds ahead.",
        ),
        Choice::new("given", "Given here", "By the parameters below, lengths in cells."),
    ],
    &[false, true],
    "What the robot can do. Published: 20 px/s and 1 s a turn.",
);
/// What a scene’s robot may have, too.
const fn given(
    name: &'static str,
    symbol: &'static str,
    title: &'static str,
    range: [f64; 2],
    usual: f64,
    help: &'static str,
) -> Param<f64> {
    Param::number(name, symbol, title, [range[0], range[1], usual], help).when(GIVEN, "given")
}
pub(super) const ROBOT_RADIUS: Param<f64> = given(
    "robot_radius",
    "R",
    "Robot’s radius",
    [0.0, 0.5],
    0.5,
    "The robot is a disc for moving obstacles, in cells; of half a cell’s radius it touches no wall as it goes from cell to cell. The paper’s is a point, and nothing would ever be foreseen in its case.",
);
pub(super) const MARGIN: Param<f64> = given(
    "margin",
    "m",
    "Safety margin",
    Robot::LENGTHS,
    0.5,
    "How far obstacles are kept from the robot’s rim, in cells; given up only where nothing keeps it.",
)
.slider(0.0, 3.0, false);
pub(super) const SPEED: Param<f64> =
    given("speed", "v", "Speed", Robot::SPEEDS, 1.0, "How far the robot goes, in cells a second. Published: 20 px, a cell.")
        .slider(0.1, 10.0, true);
pub(super) const TURN_TIME: Param<f64> = given(
    "turn_time",
    "t_t",
    "Time of a turn",
    Robot::TIMES,
    1.0,
    "Seconds that a turn takes, by however much; the robot stands meanwhile. Published: 1.",
)
.slider(0.0, 5.0, false);
pub(super) const SENSOR: Param<f64> =
    given("sensor", "r_s", "Sensor", Robot::LENGTHS, 8.0, "How far the robot sees the rim of an obstacle, in cells. Walls do not hide it.")
        .slider(0.0, 30.0, false);
pub(super) const LOOK_AHEAD: Param<f64> = given(
    "look_ahead",
    "t_a",
    "Look-ahead",
    Robot::TIMES,
    6.0,
    "How many seconds ahead the robot foresees: it expects what it sees to go on as it goes.",
)
.slider(0.0, 30.0, false);
pub(super) const PERIOD: Param<f64> = Param::number(
    "period",
    "\\Delta t",
    "Period",
    [0.001, 10.0, 0.1],
    "Seconds from step to step: how often the robot looks and decides. Whether anything meets is exact between steps too.",
)
.slider(0.01, 1.0, true);
pub(super) const TIME_LIMIT: Param<f64> = Param::number(
    "time_limit",
    "",
    "Time limit",
    [0.0, 1e6, 0.0],
    "After how many seconds the robot gives up. 0: four times what the shortest way takes without obstacles, and a minute.",
)
.slider(0.0, 1000.0, false);

/// What obstacles and robot do; a drive's own parameters come before.
pub(super) const DRIVE: &[Parameter] = &[
    BORDER.entry(),
    GIVEN.entry(),
    ROBOT_RADIUS.entry(),
    MARGIN.entry(),
    SPEED.entry(),
    TURN_TIME.entry(),
    SENSOR.entry(),
    LOOK_AHEAD.entry(),
    PERIOD.entry(),
    TIME_LIMIT.entry(),
];

/// The kinds of events and their titles, which explanations of an event say too.
macro_rules! events {
    ($($name:literal, $key:literal, $title:literal, $tone:expr, $help:literal;)+) => {
        pub(super) const EVENTS: &[EventKind] = &[$(EventKind::new($name, $title, $tone, $help)),+];

        /// The title of a kind of event.
        pub(super) fn title_of(kind: &str) -> Option<Message> {
            match kind {
                $($name => Some(message!($key, $title)),)+
                _ => None,
            }
        }
    };
}

events! {
    "set-out", "drive-event-set-out", "Sets out", Tone::Plain, "The drive begins on the planned way.";
    "seen", "drive-event-seen", "Seen", Tone::Plain, "An obstacle comes into the sensor’s reach for the first time.";
    "foreseen", "drive-event-foreseen", "Foreseen", Tone::Warning, "The plan would come too near to an obstacle.";
    "detour", "drive-event-detour", "Detour", Tone::Decision,
        "Round the predicted range along the pheromone to a local goal on the planned way.";
    "back", "drive-event-back", "Back", Tone::Good, "The local goal is reached: on along the planned way.";
    "replan", "drive-event-replan", "New plan", Tone::Decision, "A new way to the goal round the predicted range.";
    "wait", "drive-event-wait", "Waits", Tone::Decision, "There is no safe way round: the robot stands, which is safe.";
    "go-on", "drive-event-go-on", "Goes on", Tone::Good, "What it waited for or could not keep from is past.";
    "evade", "drive-event-evade", "Evades", Tone::Decision, "Standing is not safe either: the robot gets out of the way.";
    "squeeze", "drive-event-squeeze", "Without margin", Tone::Warning, "Nothing keeps the margin: on as planned, which does not touch.";
    "cornered", "drive-event-cornered", "Cornered", Tone::Warning,
        "No safe motion was found, or the search gave up at its limit: the robot takes the motion that delays a collision longest.";
    "collision", "drive-event-collision", "Collision", Tone::Bad, "The robot and an obstacle touch.";
    "arrived", "drive-event-arrived", "Arrived", Tone::Good, "The robot is at the goal.";
}

pub(super) const PLANNED: Reading = Reading::new(
    "planned",
    "L",
    "Planned",
    Group::Cost,
    "The length of the way in all, as it is planned now: what is gone and what is ahead. It rises where the robot goes round something.",
);
pub(super) const TIME: Reading = Reading::new("time", "T", "Time", Group::Measure, "Seconds since the robot set out.");
pub(super) const DRIVING: Reading = Reading::new("driving", "t_d", "Driving", Group::Measure, "Seconds that it drove.");
pub(super) const TURNING_TIME: Reading = Reading::new("turning_time", "n_t t_t", "Turning", Group::Measure, "Seconds that it turned.");
pub(super) const WAITED: Reading = Reading::new("waited", "t_w", "Waiting", Group::Measure, "Seconds that it stood without turning.");
pub(super) const GONE: Reading =
    Reading::new("length", "L_{\\text{gone}}", "Gone", Group::Length, "The length of the way that it has gone.");
pub(super) const TURNS: Reading = Reading::new("turns", "n_t", "Turns", Group::Count, "How often it has turned.");
pub(super) const DETOURS: Reading = Reading::new("detours", "", "Detours", Group::Count, "How often it went round along the pheromone.");
pub(super) const REPLANS: Reading = Reading::new("replans", "", "New plans", Group::Count, "How often it planned a new way to the goal.");
pub(super) const WAITS: Reading = Reading::new("waits", "", "Waits", Group::Count, "How often it began to wait.");
pub(super) const ESCAPES: Reading = Reading::new("escapes", "", "Escapes", Group::Count, "How often it had to get out of the way.");
pub(super) const IN_SIGHT: Reading = Reading::new("in_sight", "", "In sight", Group::Count, "Moving obstacles that it sees now.");
pub(super) const SMALLEST_DISTANCE: Reading = Reading::new(
    "smallest_distance",
    "d_{\\min}",
    "Nearest",
    Group::Measure,
    "The smallest distance between the robot’s rim and an obstacle’s so far, seen or not; negative where they overlapped.",
);
pub(super) const COLLISIONS: Reading = Reading::new("collisions", "", "Collisions", Group::Count, "How often an obstacle has touched it.");

/// What every drive tells.
pub(super) const READINGS: &[Reading] =
    &[PLANNED, TIME, DRIVING, TURNING_TIME, WAITED, GONE, TURNS, DETOURS, REPLANS, WAITS, ESCAPES, IN_SIGHT, SMALLEST_DISTANCE, COLLISIONS];

pub(super) const FORMULA_APPROACH: Formula = Formula::of_item(
    "approach",
    "[WOLF-ANT] §5",
    "Closest approach",
    "t^* = \\max\\left(0, -\\frac{\\class{before}{\\Delta p} \\cdot \\class{velocity}{\\Delta v}}{|\\class{velocity}{\\Delta v}|^2}\\right), \\quad d^* = \\class{candidates}{|\\Delta p + t^* \\Delta v|} - R - r",
    "t^* = \\max\\left(0, \\frac{@towards@}{@squared@}\\right) = @t@, \\quad d^* = \\class{candidates}{@centres@} - @robot@ - @radius@ = @d@",
);
pub(super) const FORMULA_TIME: Formula = Formula::new(
    "time",
    "[WOLF-ANT] §6",
    "Time",
    "T = \\frac{L}{v} + n_t \\, t_t + t_w",
    "T = @driving@ + @turning_time@ + @waited@ = @time@",
);

const CLOSEST: Layer =
    layers::CANDIDATES.titled("Closest approach", "The robot and an obstacle when they will be nearest, if both go on as they do.");

/// What a drive on searched ways draws.
pub(super) const LAYERS_BARE: &[Layer] = &[
    layers::PREDICTED,
    layers::SENSOR,
    layers::AHEAD,
    layers::TRACK,
    layers::LOCAL_GOAL,
    layers::EVENTS,
    layers::MOVING,
    layers::ROBOT,
    layers::VELOCITY,
    CLOSEST,
    layers::BEFORE,
    layers::AFTER,
    layers::SUPPOSED,
];

/// What a drive on pheromone draws.
pub(super) const LAYERS: &[Layer] = &[
    layers::PHEROMONE
        .titled("Pheromone", "How much more lies on each cell’s strongest step than where no ant has been; the drive leaves it as it is."),
    layers::TRAILS.titled("Trails", "How much lies on each step; seen from near."),
    layers::ANTS.titled("Ants", "The ways of this iteration’s ants, while they plan."),
    layers::BEST.titled("Planned", "The shortest way so far, while the ants plan."),
    layers::PREDICTED,
    layers::SENSOR,
    layers::AHEAD,
    layers::TRACK,
    layers::LOCAL_GOAL,
    layers::EVENTS,
    layers::MOVING,
    layers::ROBOT,
    layers::VELOCITY,
    CLOSEST,
    layers::WAY,
    layers::TO_GOAL,
    layers::STEP,
    layers::BEFORE,
    layers::AFTER,
    layers::SUPPOSED,
];
