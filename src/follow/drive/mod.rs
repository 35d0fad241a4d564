//! A robot that drives along a path: the differential drive of [LTQPSO](crate#papers) §5.
//!
//! Once every control period it looks where it is and steers by pure pursuit ([`PARAMETERS`] has its limits); in between
//! it keeps speed and turn rate, so that it moves on exact arcs. It begins at the path's first corner, looking along it,
//! and starts and stops at once: its motion is given, not the forces, and the paper's mass of 2.3 kg plays no part.
//! [`simulate`] is the whole of it; [`along`] says when there is something to simulate.
//!
//! What it touches is decided by its outline, a rectangle turned as it stands, not by the circle that planners keep clear
//! of obstacles with. Only blocked cells count: the grid's border is no wall, and the outline may hang over it.
//!
//! A turn from x towards y is one to the left, unless the scene's y points down: then it is one to the right, and wheels
//! and errors are named accordingly.

mod motion;
mod parameters;
mod pursuit;
mod sweep;

use std::{f64::consts::PI, sync::Arc};

use serde_json::Value;

use crate::{
    describe::{Extra, FollowOutcome, FollowedPath, Follower},
    geometry::{self, YAxis},
    kernel::{Error, Solution, words},
    math,
    params::{self, Overrides, Param, Parameters},
    scene::{GRID, GridScene, Robot, Scene},
};

pub use parameters::{COLUMNS, PARAMETERS, SPEED};

use motion::{Pose, Wheels};
use parameters::{ANY, DECODER, FORMULAS, GEAR, LOOK_AHEAD, PERIOD, PULSES, TURN_RATE, WHEEL_DISTANCE, WHEEL_RADIUS};
use pursuit::{Course, Limits, distance};
use sweep::Sweep;

/// See the module.
pub const ENTRY: Follower = Follower {
    name: "drive",
    title: words("How a robot drives along a path"),
    kind: GRID,
    needs: words("a grid whose robot has a length and a width"),
    applies: |scene| robot(scene).is_some(),
    source: words("[LTQPSO] §5"),
    summary: words(
        "A robot with two driven wheels follows the path by pure pursuit, within its limits. Its outline, turned as it \
              stands, is checked against the obstacles all along the way.",
    ),
    parameters: &[PARAMETERS],
    columns: COLUMNS,
    formulas: FORMULAS,
    follow: |scene, solution, overrides| {
        let drive = along(scene, solution.and_then(Solution::path), overrides)?;
        Ok(drive.map(|drive| Box::new(drive) as Box<dyn FollowedPath>))
    },
};

/// How near the goal the centre must be to have arrived, as a share of the robot's length: 4 mm for one of 0.4 m.
pub const ARRIVED: f64 = 0.01;

/// Overlaps that are less deep may go unnoticed: a share of the robot's length, 0.04 mm for one of 0.4 m.
/// On a path of more than a hundred robots' lengths it is a millionth of the path, so that the work has an end.
pub const RESOLUTION: f64 = 1e-4;

/// The drive ends without having arrived after this many times the time that the path would take at top speed, with half a
/// turn and all its corners taken on the spot.
pub const PATIENCE: f64 = 4.0;

/// And after this many periods, whatever the time.
pub const MOST_PERIODS: u64 = 100_000;

/// How a drive along a path went.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DriveOutcome {
    /// Seconds from start to stop.
    pub time: f64,
    /// How far the robot's centre went.
    pub distance: f64,
    /// It stopped at the goal, within a hundredth of the robot's length ([`ARRIVED`]).
    pub arrived: bool,
    /// Its outline overlapped a blocked cell somewhere on the way, not only where a period ended. To touch with
    /// distance 0 is allowed.
    pub touched: bool,
    /// Where its centre was when it first did.
    #[cfg_attr(feature = "types", ts(optional))]
    pub touched_at: Option<[f64; 2]>,
    /// The smallest distance of its outline from a blocked cell on the way, to within a share of the robot's length
    /// ([`RESOLUTION`]) and a hundredth of itself; negative: overlap. `None` without obstacles.
    pub clearance: Option<f64>,
    /// The largest distance of its centre from the path where a period ended.
    pub max_error: f64,
    /// The root of the mean of their squares.
    pub rms_error: f64,
    /// What the wheel encoders counted in all: left, right.
    pub counts: [f64; 2],
}

/// A robot driving along a path.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// [`COLUMNS`]' numbers for the start and for the end of each control period.
    pub rows: Vec<f64>,
    /// How it went.
    pub outcome: DriveOutcome,
    /// The robot's length and width.
    pub outline: [f64; 2],
    /// Every parameter's value.
    pub parameters: Parameters,
}

impl FollowedPath for Drive {
    fn rows(&self) -> &[f64] {
        &self.rows
    }

    fn outcome(&self) -> Arc<dyn FollowOutcome> {
        Arc::new(self.outcome.clone())
    }

    fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    fn extra(&self) -> Vec<(&'static str, Extra<'_>)> {
        let [length, width] = self.outline;
        vec![("outline", Extra::Named(vec![("length", length), ("width", width)]))]
    }
}

impl FollowOutcome for DriveOutcome {
    fn fields(&self) -> Vec<(&'static str, Value)> {
        let list = |numbers: [f64; 2]| Value::from(numbers.to_vec());
        let mut fields = vec![
            ("time", Value::from(self.time)),
            ("distance", self.distance.into()),
            ("arrived", self.arrived.into()),
            ("touched", self.touched.into()),
            ("clearance", self.clearance.into()),
            ("max_error", self.max_error.into()),
            ("rms_error", self.rms_error.into()),
            ("counts", list(self.counts)),
        ];
        fields.extend(self.touched_at.map(|place| ("touched_at", list(place))));
        fields
    }
}

/// The values for a scene's robot: what was given, then what the scene says of it, then the defaults. Those are the
/// figures of a robot 0.4 m long and 0.3 m wide; for another size (and another unit) lengths keep their proportion to it.
///
/// # Errors
/// As [`Parameters::new`]: the field, its value and what is allowed.
pub fn parameters(robot: Option<Robot>, given: &Overrides) -> Result<Parameters, Error> {
    let usual = |param: Param<f64>| number(&param.entry().default_on(GRID));
    let Robot { length, width, speed, .. } = robot.unwrap_or_default();
    let (long, wide) = (length.map_or(1.0, |length| length / 0.4), width.map_or(1.0, |width| width / 0.3));
    let asked = |param: Param<f64>, otherwise: f64| given.get(param.name()).map_or(otherwise, number);
    let speed = speed.unwrap_or(usual(SPEED) * long);
    // A target nearer than the way of a period would be overrun.
    let way = asked(SPEED, speed) * asked(PERIOD, usual(PERIOD));
    let own = [
        (SPEED, speed),
        (LOOK_AHEAD, math::clamp(usual(LOOK_AHEAD) * long, 2.0 * way, f64::INFINITY)),
        (WHEEL_RADIUS, usual(WHEEL_RADIUS) * long),
        (WHEEL_DISTANCE, usual(WHEEL_DISTANCE) * wide),
    ];
    let mut given = given.clone();
    for (param, value) in own {
        if given.get(param.name()).is_none() {
            // A scene's speed is never beyond; what goes with a very large or small robot ends there.
            given.insert(param.name(), params::Value::Number(math::clamp(value, ANY[0], ANY[1])));
        }
    }
    Parameters::new(ENTRY.parameters, GRID, &given)
}

fn number(value: &params::Value) -> f64 {
    if let params::Value::Number(number) = value { *number } else { f64::NAN }
}

/// The scene and the robot's length and width, if it is a grid with such a robot.
pub fn robot(scene: &Scene) -> Option<(&GridScene, [f64; 2])> {
    let grid = scene.get::<GridScene>().ok()?;
    Some((grid, grid.outline()?))
}

/// The drive along a path; `None` in a scene without a robot that has length and width, and without a path.
///
/// # Errors
/// As [`parameters()`], whether there is anything to drive or not.
pub fn along(scene: &Scene, path: Option<&[[f64; 2]]>, given: &Overrides) -> Result<Option<Drive>, Error> {
    let grid = robot(scene);
    let parameters = parameters(grid.and_then(|(grid, _)| grid.robot), given)?;
    Ok(grid.zip(path).and_then(|((grid, _), path)| simulate(grid, path, &parameters)))
}

/// Drives the scene's robot along a path. `None` for a robot without length and width, and for a path without corners.
pub fn simulate(scene: &GridScene, path: &[[f64; 2]], parameters: &Parameters) -> Option<Drive> {
    let (outline, course) = (scene.outline()?, Course::new(path)?);
    let limits = Limits { speed: parameters[SPEED], turn_rate: parameters[TURN_RATE], period: parameters[PERIOD] };
    let wheels = Wheels {
        radius: parameters[WHEEL_RADIUS],
        distance: parameters[WHEEL_DISTANCE],
        counts: parameters[PULSES] * parameters[DECODER] * parameters[GEAR],
        left_is: if scene.y_axis == YAxis::Up { 1.0 } else { -1.0 },
    };
    let ahead = parameters[LOOK_AHEAD];
    // The nearest point is looked for a little way back, and ahead as far as the robot can have come by steering for its
    // last target: enough to get round a corner that was cut, not enough to change to a later pass.
    let reach = limits.speed * limits.period;
    let patience = PATIENCE * (course.length() / limits.speed + (geometry::turning(path) + PI) / limits.turn_rate);

    let mut pose = course.start();
    let mut log = Log::new(wheels);
    let resolution = (RESOLUTION * outline[0]).max(1e-6 * course.length());
    let (mut sweep, mut clearance) = Sweep::new(scene.field(), outline.map(|side| side / 2.0), resolution, &pose);
    log.row(&pose, 0.0, clearance);
    // How far along the path the nearest point was, and the target: neither ever goes back.
    let (mut progress, mut aim) = (0.0_f64, 0.0_f64);
    let mut periods = 0;
    let arrived = loop {
        let target = course.target(progress.max(aim), pose.at, ahead);
        aim = target.along;
        if target.is_goal && distance(pose.at, target.point) <= ARRIVED * outline[0] {
            break true;
        }
        if log.time >= patience || periods == MOST_PERIODS {
            break false;
        }
        let (motion, seconds) = limits.steer(&pose, target);
        clearance = sweep.follow(&pose, clearance, motion, seconds);
        pose = pose.after(motion, seconds);
        let nearest = course.nearest(progress - ahead - reach, aim + reach, pose.at);
        progress = progress.max(nearest.along);
        log.moved(motion, seconds);
        log.row(&pose, nearest.aside, clearance);
        periods += 1;
    };
    let outcome = log.outcome(arrived, &sweep);
    Some(Drive { rows: log.rows, outcome, outline, parameters: parameters.clone() })
}

/// What is written down on the way.
#[derive(Debug)]
struct Log {
    wheels: Wheels,
    rows: Vec<f64>,
    time: f64,
    distance: f64,
    motion: motion::Motion,
    /// How far each wheel has turned in all.
    angles: [f64; 2],
    max_error: f64,
    squares: f64,
}

impl Log {
    fn new(wheels: Wheels) -> Self {
        let motion = motion::Motion { speed: 0.0, turn_rate: 0.0 };
        Self { wheels, rows: Vec::new(), time: 0.0, distance: 0.0, motion, angles: [0.0; 2], max_error: 0.0, squares: 0.0 }
    }

    fn moved(&mut self, motion: motion::Motion, seconds: f64) {
        self.motion = motion;
        self.time += seconds;
        self.distance += motion.speed * seconds;
        let speeds = self.wheels.speeds(motion);
        self.angles = [0, 1].map(|wheel| self.angles[wheel] + speeds[wheel] * seconds);
    }

    fn counts(&self) -> [f64; 2] {
        self.angles.map(|angle| self.wheels.count(angle))
    }

    fn row(&mut self, pose: &Pose, aside: f64, clearance: f64) {
        let ([x, y], [left, right], counts) = (pose.at, self.wheels.speeds(self.motion), self.counts());
        // Adding 0 turns −0 into 0: a wheel at rest has no direction.
        let error = aside * self.wheels.left_is + 0.0;
        self.max_error = self.max_error.max(error.abs());
        self.squares += error * error;
        let motion = self.motion;
        let row = [self.time, x, y, pose.heading, motion.speed, motion.turn_rate, left, right, counts[0], counts[1], error, clearance];
        self.rows.extend(row);
    }

    fn outcome(&self, arrived: bool, sweep: &Sweep) -> DriveOutcome {
        DriveOutcome {
            time: self.time,
            distance: self.distance,
            arrived,
            touched: sweep.touched_at.is_some(),
            touched_at: sweep.touched_at,
            clearance: sweep.least.is_finite().then_some(sweep.least),
            max_error: self.max_error,
            rms_error: (self.squares * COLUMNS.len() as f64 / self.rows.len() as f64).sqrt(),
            counts: self.counts(),
        }
    }
}
