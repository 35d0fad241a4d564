//! The robot's body in simulated time: how it follows a plan, and every stretch of even motion that comes of it. What is
//! foreseen and what is driven are made of the same stretches.

use crate::{
    kernel::{Border, Error, State},
    message,
    params::Parameters,
    scene::{GridScene, Robot},
};

use super::parameters::{BORDER, GIVEN, LOOK_AHEAD, MARGIN, ROBOT_RADIUS, SENSOR, SPEED, TURN_TIME};

/// What the robot can do. Lengths in the scene's unit, times in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Body {
    /// The radius of the disc that it is for moving obstacles.
    pub radius: f64,
    /// How far it keeps them away beyond that.
    pub margin: f64,
    pub speed: f64,
    /// What a turn takes, by however much; it stands meanwhile, [WOLF-ANT](crate#papers) §5.3.
    pub turn_time: f64,
    /// How far it sees: an obstacle whose rim is nearer than that.
    pub sensor: f64,
    /// How far it looks ahead.
    pub look_ahead: f64,
    pub border: Border,
}

impl Body {
    /// The robot of a scene, or as the parameters say.
    pub fn new(grid: &GridScene, settings: &Parameters) -> Result<Self, Error> {
        // A disc of half a cell's radius that goes from centre to centre meets no blocked cell unless it cuts corners.
        let fits = grid.radius().max(if grid.corner_cutting { 0.0 } else { grid.cell / 2.0 });
        let given = settings[GIVEN];
        let Robot { disc, margin, speed, turn_time, sensor, look_ahead, .. } = grid.robot.unwrap_or_default();
        let own = if grid.radius() > 0.0 { grid.radius() } else { fits };
        let body = if given {
            Self {
                radius: settings[ROBOT_RADIUS] * grid.cell,
                margin: settings[MARGIN] * grid.cell,
                speed: settings[SPEED] * grid.cell,
                turn_time: settings[TURN_TIME],
                sensor: settings[SENSOR] * grid.cell,
                look_ahead: settings[LOOK_AHEAD],
                border: Border::default(),
            }
        } else {
            Self {
                radius: disc.unwrap_or(own),
                margin: margin.unwrap_or(grid.cell / 2.0),
                speed: speed.unwrap_or(grid.cell),
                turn_time: turn_time.unwrap_or(1.0),
                sensor: sensor.unwrap_or(8.0 * grid.cell),
                look_ahead: look_ahead.unwrap_or(6.0),
                border: Border::default(),
            }
        };
        if body.radius > fits * (1.0 + 1e-12) {
            let (field, value, most) =
                if given { (ROBOT_RADIUS.name(), settings[ROBOT_RADIUS], fits / grid.cell) } else { ("robot.radius", body.radius, fits) };
            let allowed = message!(
                "drive-radius",
                "at most {most}: what goes from cell to cell without touching blocked ones; a larger robot needs a length and a width",
                most
            );
            return Err(Error::refused(field, value, allowed));
        }
        Ok(Self { border: settings[BORDER], ..body })
    }
}

/// One piece of a plan: wait, turn if need be, and go straight to a point.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub(super) struct Step {
    pub to: [f64; 2],
    /// The cell that it comes to.
    pub cell: usize,
    /// Seconds to stand before it turns and goes.
    pub wait: f64,
}

/// Where the robot is on its plan.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub(super) struct Pose {
    pub at: [f64; 2],
    /// The cell that it comes from and the one that it goes to; the same where it is in a cell's middle (or before it set
    /// out, or beyond the last cell's middle).
    pub between: [usize; 2],
    /// A unit vector; 0 before it set out: the first step needs no turn.
    pub heading: [f64; 2],
    /// The turn that it is in: where to, and for how long already.
    pub turn: Option<([f64; 2], f64)>,
}

/// What the robot does in a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
pub(super) enum Deed {
    Wait,
    Turn,
    Go,
}

/// A stretch of even motion.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub(super) struct Stretch {
    pub from: f64,
    pub until: f64,
    pub at: [f64; 2],
    pub velocity: [f64; 2],
    pub deed: Deed,
    /// The number of the step, from where the plan is now.
    pub step: usize,
}

/// From one point to another: the unit vector and the distance.
pub(super) fn endpoints([x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> ([f64; 2], f64) {
    let (dx, dy) = (to_x - x, to_y - y);
    let distance = (dx * dx + dy * dy).sqrt();
    if distance > 0.0 { ([dx / distance, dy / distance], distance) } else { ([0.0; 2], 0.0) }
}

/// Whether two headings are one but for rounding.
pub(super) fn same([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> bool {
    (ax - bx).abs() + (ay - by).abs() < 1e-6
}

impl Pose {
    /// How long it still has to turn to go that way.
    pub fn turning(&self, way: [f64; 2], body: &Body) -> f64 {
        if self.heading == [0.0; 2] || way == [0.0; 2] || same(self.heading, way) {
            return 0.0;
        }
        let done = self.turn.filter(|(to, _)| same(*to, way)).map_or(0.0, |(_, done)| done);
        (body.turn_time - done).max(0.0)
    }

    /// Goes on by a plan until a time at most and tells each stretch. Returns the time at which it stopped: earlier than
    /// `until` only at the end of the plan.
    pub fn follow(&mut self, steps: &[Step], done: &mut Done, body: &Body, [from, until]: [f64; 2], tell: &mut dyn FnMut(Stretch)) -> f64 {
        let first = done.steps;
        let mut now = from;
        while let Some(step) = steps.get(done.steps) {
            let number = done.steps - first;
            let (way, distance) = endpoints(self.at, step.to);
            let at = self.at;
            let mut stand = |now: &mut f64, seconds: f64, deed| {
                let stood = seconds.min(until - *now);
                if stood > 0.0 {
                    tell(Stretch { from: *now, until: *now + stood, at, velocity: [0.0; 2], deed, step: number });
                    *now += stood;
                }
                stood
            };
            let wait = step.wait - done.waited;
            if wait > 0.0 {
                // Whoever waits gives up a turn that was begun.
                self.turn = None;
                let stood = stand(&mut now, wait, Deed::Wait);
                done.waited += stood;
                if stood < wait {
                    return until;
                }
            }
            let left = self.turning(way, body);
            if left > 0.0 {
                let stood = stand(&mut now, left, Deed::Turn);
                if stood < left {
                    self.turn = Some((way, body.turn_time - left + stood));
                    return until;
                }
            }
            if distance > 0.0 {
                (self.heading, self.turn) = (way, None);
                if now >= until {
                    return until;
                }
                let end = now + distance / body.speed;
                let velocity = way.map(|c| c * body.speed);
                tell(Stretch { from: now, until: end.min(until), at: self.at, velocity, deed: Deed::Go, step: number });
                if end > until {
                    self.at = [0, 1].map(|axis| self.at[axis] + (until - now) * velocity[axis]);
                    // Back to where it came from: what was ahead is behind it.
                    self.between = [if self.between[0] == step.cell { self.between[1] } else { self.between[0] }, step.cell];
                    return until;
                }
                now = end;
                (self.at, self.between) = (step.to, [step.cell; 2]);
            }
            *done = Done { steps: done.steps + 1, waited: 0.0 };
        }
        now
    }
}

/// How much of a plan is done.
#[derive(Debug, Clone, Copy, PartialEq, Default, State)]
pub(super) struct Done {
    /// Whole steps.
    pub steps: usize,
    /// Of the next step's wait, seconds.
    pub waited: f64,
}

/// The steps to the goal.
#[derive(Debug, Clone, PartialEq, Default, State)]
pub(super) struct Plan {
    pub steps: Vec<Step>,
    pub done: Done,
}

impl Plan {
    /// Of these steps.
    pub fn new(steps: Vec<Step>) -> Self {
        Self { steps, done: Done::default() }
    }

    /// The steps that are left.
    pub fn left(&self) -> &[Step] {
        &self.steps[self.done.steps.min(self.steps.len())..]
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{Run, Setup, Value, params::Overrides, standard};

    const BODY: Body = Body { radius: 1.0, margin: 1.0, speed: 2.0, turn_time: 1.5, sensor: 9.0, look_ahead: 5.0, border: Border::Leave };

    fn step(to: [f64; 2], cell: usize, wait: f64) -> Step {
        Step { to, cell, wait }
    }

    /// 4 east (2 s), a wait of 0.5 s, a turn of 1.5 s, 2 north (1 s).
    fn plan() -> [Step; 3] {
        [step([2.0, 0.0], 1, 0.0), step([4.0, 0.0], 2, 0.0), step([4.0, 2.0], 3, 0.5)]
    }

    #[test]
    fn a_plan_takes_its_length_its_turns_and_its_waits() {
        let mut pose = Pose { at: [0.0; 2], between: [0; 2], heading: [0.0; 2], turn: None };
        let mut stretches = Vec::new();
        let end = pose.follow(&plan(), &mut Done::default(), &BODY, [10.0, 99.0], &mut |stretch| stretches.push(stretch));
        assert_eq!(end, 15.0);
        let deeds: Vec<_> = stretches.iter().map(|s| (s.deed, s.from, s.until, s.step)).collect();
        assert_eq!(
            deeds,
            [
                (Deed::Go, 10.0, 11.0, 0),
                (Deed::Go, 11.0, 12.0, 1),
                (Deed::Wait, 12.0, 12.5, 2),
                (Deed::Turn, 12.5, 14.0, 2),
                (Deed::Go, 14.0, 15.0, 2)
            ]
        );
        assert_eq!((pose.at, pose.between, pose.heading), ([4.0, 2.0], [3; 2], [0.0, 1.0]));
    }

    #[test]
    fn it_can_be_stopped_and_go_on_at_any_time() {
        for pieces in [1, 2, 3, 7, 50, 500] {
            let (mut done, mut pose) = (Done::default(), Pose { at: [0.0; 2], between: [0; 2], heading: [0.0; 2], turn: None });
            let (mut turned, mut waited, mut now) = (0.0, 0.0, 0.0);
            for k in 1..=pieces {
                let until = 6.0 * f64::from(k) / f64::from(pieces);
                now = pose.follow(&plan(), &mut done, &BODY, [now, until], &mut |stretch| match stretch.deed {
                    Deed::Turn => turned += stretch.until - stretch.from,
                    Deed::Wait => waited += stretch.until - stretch.from,
                    Deed::Go => {}
                });
                if done.steps == 3 {
                    break;
                }
                assert_eq!(now, until);
            }
            assert!((now - 5.0).abs() < 1e-12 && (turned - 1.5_f64).abs() < 1e-12 && (waited - 0.5_f64).abs() < 1e-12, "{pieces}");
            assert_eq!(pose.at, [4.0, 2.0]);
        }
    }

    #[test]
    fn a_turn_is_gone_on_with_only_where_it_leads_the_same_way() {
        let mut pose = Pose { at: [4.0, 0.0], between: [2; 2], heading: [1.0, 0.0], turn: None };
        pose.follow(&[step([4.0, 2.0], 3, 0.0)], &mut Done::default(), &BODY, [0.0, 0.5], &mut |_| {});
        assert_eq!(pose.turning([0.0, 1.0], &BODY), 1.0);
        assert_eq!(pose.turning([0.0, -1.0], &BODY), 1.5);
        assert_eq!(pose.turning([1.0, 0.0], &BODY), 0.0, "it has not left its heading yet");
    }

    /// What a robot may have is the same in a scene and among the parameters: both ends are taken by both, what lies beyond by neither,
    /// and a drive with any of it goes on.
    /// With an outline a scene's disc may be larger: the parameter has the range that every grid takes.
    #[test]
    fn scenes_and_parameters_take_the_same_robots() {
        const CELL: f64 = 2.0;
        let lengths = (Robot::LENGTHS, CELL);
        let fields = [
            ("radius", ROBOT_RADIUS, ([0.0, 0.5], CELL)),
            ("margin", MARGIN, lengths),
            ("speed", SPEED, (Robot::SPEEDS, CELL)),
            ("turn_time", TURN_TIME, (Robot::TIMES, 1.0)),
            ("sensor", SENSOR, lengths),
            ("look_ahead", LOOK_AHEAD, (Robot::TIMES, 1.0)),
        ];
        let ten = |robot: &str, params: Overrides| {
            let text = format!(
                r#"{{"format": "forage-scene", "version": 1, "kind": "grid", "name": "a", "title": "A", "cell": {CELL},
                    "rows": ["......", "......", "......", "......"], "start": [3, 3], "goal": [9, 5], "robot": {{{robot}}},
                    "moving": [{{"center": [9, 1], "radius": 0.5, "velocity": [-1, 0.25]}}]}}"#
            );
            let scene = Arc::new(standard().read_scene(&text)?);
            let mut run = Run::new(standard(), Setup { planner: "a-star-drive".to_owned(), scene, params, seed: 1 })?;
            run.step(10);
            Ok::<_, Error>(())
        };
        for (field, parameter, ([least, most], unit)) in fields {
            let in_scene = |value: f64| ten(&format!(r#""{field}": {value}"#), Overrides::new());
            let given = |value: f64| {
                let params = [("robot", Value::Text("given".to_owned())), (parameter.name(), Value::Number(value))];
                ten("", params.into_iter().collect())
            };
            for value in [least, most] {
                assert_eq!((in_scene(value * unit), given(value)), (Ok(()), Ok(())), "{field} {value}");
            }
            let below = if least > 0.0 { least / 2.0 } else { -1e-3 };
            for value in [below, most * 1.001] {
                let refused = |result: Result<(), Error>, name: &str| result.unwrap_err().field() == name;
                assert!(refused(in_scene(value * unit), &format!("robot.{field}")), "{field} {value}");
                assert!(refused(given(value), parameter.name()), "{field} {value}");
            }
        }
    }
}
