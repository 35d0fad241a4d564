//! The drive: period by period the robot looks around, foresees, decides and goes on, [WOLF-ANT](crate#papers) §5.3.
//!
//! When its plan would come too near to an obstacle: round its predicted range to a local goal on the planned way; if that
//! gives no way, a new way to the goal; if there is none, it waits; and where standing is not safe either, it gets out of
//! the way. What does not keep the margin is tried only when nothing does.

use std::sync::Arc;

use crate::{
    geometry::{closest_approach, first_within},
    kernel::{Event, Message, State},
    message,
    scene::CONTACT,
};

use super::{
    body::{Deed, Plan, Pose, Stretch, same},
    ground::Ground,
    route::{Ways, plan},
    world::{Distance, View},
};

/// What a drive has cost so far.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub(super) struct Tally {
    pub length: f64,
    pub turns: u64,
    /// Seconds it stood, turns included.
    pub stood: f64,
    pub detours: u64,
    pub replans: u64,
    pub waits: u64,
    pub escapes: u64,
    pub collisions: u64,
    /// The smallest distance to an obstacle so far, negative where they overlapped; infinite without obstacles.
    pub gap: f64,
}

/// The robot stands though its plan leads on.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub(super) struct Hold {
    pub since: f64,
    pub obstacle: usize,
    /// When it looks for a way round next.
    pub retry: f64,
}

/// A drive under way.
#[derive(Clone, State)]
pub(super) struct Journey {
    #[state(shared)]
    pub ground: Arc<Ground>,
    pub now: f64,
    pub pose: Pose,
    pub plan: Plan,
    pub view: View,
    pub tally: Tally,
    pub events: Vec<Event>,
    /// `[t, x, y]` at every change of its motion.
    pub moments: Vec<[f64; 3]>,
    /// Where a detour comes back to the planned way.
    pub local_goal: Option<usize>,
    pub arrived: bool,
    pub hold: Option<Hold>,
    /// What it keeps away by now.
    pub distance: Distance,
    /// Where no safe motion was found, which was said then: when it searches again. Infinite while it overlaps something.
    pub cornered: Option<f64>,
    /// It was said already that it gets out of the way.
    pub evading: bool,
    /// Of each obstacle: whether it was seen, whether it touches.
    seen: Vec<bool>,
    touching: Vec<bool>,
    velocity: [f64; 2],
    heading: [f64; 2],
    iteration: u64,
    /// How often it searched for an escape.
    pub searches: u64,
    /// Scratch space.
    pub stretches: Vec<Stretch>,
    #[state(skip)]
    pub occupied: Vec<bool>,
}

impl Journey {
    /// At the start of a way over cells.
    pub fn new(ground: &Arc<Ground>, way: &[usize]) -> Self {
        let at = ground.endpoints.ends[0];
        let n = ground.grid.moving.len();
        let mut journey = Self {
            now: 0.0,
            pose: Pose { at, between: [ground.endpoints.start; 2], heading: [0.0; 2], turn: None },
            plan: plan(&ground.cells, &ground.endpoints, way),
            view: View::default(),
            tally: Tally {
                length: 0.0,
                turns: 0,
                stood: 0.0,
                detours: 0,
                replans: 0,
                waits: 0,
                escapes: 0,
                collisions: 0,
                gap: f64::INFINITY,
            },
            events: Vec::new(),
            moments: vec![[0.0, at[0], at[1]]],
            local_goal: None,
            arrived: false,
            hold: None,
            distance: Distance::Margin,
            cornered: None,
            evading: false,
            seen: vec![false; n],
            touching: vec![false; n],
            velocity: [0.0; 2],
            heading: [0.0; 2],
            iteration: 0,
            searches: 0,
            stretches: Vec::new(),
            occupied: vec![false; ground.cells.len()],
            ground: Arc::clone(ground),
        };
        journey.view.look(&ground.grid, &ground.body, at, 0.0);
        journey
    }

    /// One period, or less if it arrives. It has no meaning if it waits for something in the end.
    pub fn step(&mut self, ways: &mut Ways, iteration: u64) {
        self.iteration = iteration;
        if self.now == 0.0 {
            let (length, n) = (self.length_of(self.left()), self.turns_left());
            let said = message!(
                "drive-set-out",
                "It sets out on a way of {length} with {n} {turns}.",
                length,
                n,
                turns = n => "turn" | "turns"
            );
            self.tell("set-out", None, said);
        }
        if self.now == 0.0 {
            // Where start and goal are one there is no stretch at all.
            let moment = self.standing(0.0);
            self.watch(&moment);
        }
        self.look();
        self.think(ways);
        if ways.open.is_some() {
            return;
        }
        self.advance();
        if let Some(goal) = self.local_goal.filter(|&goal| self.pose.between == [goal; 2]) {
            self.local_goal = None;
            let [x, y] = self.ground.cells.centre(goal);
            let said = message!("drive-back", "The local goal at ({x:.1}, {y:.1}) is reached: on along the planned way.", x, y);
            self.tell("back", None, said);
        }
        if self.arrived {
            let said = self.arrival();
            self.tell("arrived", None, said);
        }
    }

    /// How it arrived.
    fn arrival(&self) -> Message {
        let (time, way, n) = (self.now, self.length_of(self.tally.length), self.tally.turns);
        match self.tally.collisions {
            0 => message!(
                "drive-arrived",
                "It is at the goal after {time:.1} s, {way} and {n} {turns}, without touching anything that moves.",
                time,
                way,
                n,
                turns = n => "turn" | "turns"
            ),
            1 => message!(
                "drive-arrived-collision",
                "It is at the goal after {time:.1} s, {way} and {n} {turns}, after a collision.",
                time,
                way,
                n,
                turns = n => "turn" | "turns"
            ),
            collisions => message!(
                "drive-arrived-collisions",
                "It is at the goal after {time:.1} s, {way} and {n} {turns}, after {collisions} collisions.",
                time,
                way,
                n,
                turns = n => "turn" | "turns",
                collisions
            ),
        }
    }

    /// Looks around, and says what it sees for the first time.
    fn look(&mut self) {
        let ground = Arc::clone(&self.ground);
        self.view.look(&ground.grid, &ground.body, self.pose.at, self.now);
        for i in 0..self.view.threats.len() {
            let (number, distance) = (self.view.threats[i].number, self.view.threats[i].distance);
            if !std::mem::replace(&mut self.seen[number], true) {
                let rim = distance - ground.grid.moving[number].radius;
                let said = message!(
                    "drive-seen",
                    "Obstacle {obstacle} comes into the sensor’s reach, {distance} away.",
                    obstacle = number + 1,
                    distance = self.length_of(rim.max(0.0))
                );
                self.tell("seen", Some(number), said);
            }
        }
    }

    pub fn standing(&self, until: f64) -> Stretch {
        Stretch { from: self.now, until, at: self.pose.at, velocity: [0.0; 2], deed: Deed::Wait, step: 0 }
    }

    /// Drives for a period.
    fn advance(&mut self) {
        let ground = Arc::clone(&self.ground);
        let until = self.now + ground.period;
        self.stretches.clear();
        let end = if self.hold.is_some() {
            self.pose.turn = None;
            let standing = self.standing(until);
            self.stretches.push(standing);
            until
        } else {
            let (stretches, pose, done) = (&mut self.stretches, &mut self.pose, &mut self.plan.done);
            let end = pose.follow(&self.plan.steps, done, &ground.body, [self.now, until], &mut |stretch| stretches.push(stretch));
            self.arrived = self.plan.left().is_empty();
            end
        };
        for i in 0..self.stretches.len() {
            let stretch = self.stretches[i];
            self.count(&stretch);
            self.watch(&stretch);
        }
        self.now = end;
        if self.arrived {
            self.mark(end, self.pose.at);
        }
    }

    /// Adds a stretch to the tally and to the track.
    fn count(&mut self, stretch: &Stretch) {
        let seconds = stretch.until - stretch.from;
        if stretch.deed == Deed::Go {
            self.tally.length += seconds * self.ground.body.speed;
            let heading = stretch.velocity.map(|c| c / self.ground.body.speed);
            self.tally.turns += u64::from(self.heading != [0.0; 2] && !same(heading, self.heading));
            self.heading = heading;
        } else {
            self.tally.stood += seconds;
        }
        let slack = 1e-6 * self.ground.body.speed;
        if (0..2).any(|axis| (stretch.velocity[axis] - self.velocity[axis]).abs() > slack) {
            self.mark(stretch.from, stretch.at);
            self.velocity = stretch.velocity;
        }
    }

    fn mark(&mut self, time: f64, [x, y]: [f64; 2]) {
        if self.moments.last() != Some(&[time, x, y]) {
            self.moments.push([time, x, y]);
        }
    }

    /// How near the obstacles really come, seen or not. Each time that one touches is an event, at the moment when it
    /// begins, however long a period is.
    fn watch(&mut self, stretch: &Stretch) {
        let ground = Arc::clone(&self.ground);
        let (grid, body) = (&ground.grid, &ground.body);
        for (number, disc) in grid.moving.iter().enumerate() {
            let contact = disc.radius + body.radius;
            let reach = contact - CONTACT * grid.cell;
            let span = [stretch.from, stretch.until];
            for (start, seconds, apart, closing) in disc.stretches(stretch.at, stretch.velocity, span, body.border, grid.bounds()) {
                let (_, least) = closest_approach(apart, closing, seconds);
                self.tally.gap = self.tally.gap.min(least - contact);
                let Some(after) = first_within(apart, closing, seconds, reach) else {
                    self.touching[number] = false;
                    continue;
                };
                let end = [0, 1].map(|axis| apart[axis] + seconds * closing[axis]);
                let still = end[0] * end[0] + end[1] * end[1] < reach * reach;
                if !std::mem::replace(&mut self.touching[number], still) {
                    self.tally.collisions += 1;
                    let time = start + after;
                    let place = [0, 1].map(|axis| stretch.at[axis] + (time - stretch.from) * stretch.velocity[axis]);
                    let reason = collision(number + 1, stretch.deed == Deed::Go, &self.cause(number, time));
                    let iteration = self.iteration;
                    self.events.push(Event { iteration, time, place, kind: "collision", obstacle: Some(number), reason });
                }
            }
        }
    }

    /// Why an obstacle touches it at a time: what the robot had seen and found out when it last looked.
    fn cause(&self, number: usize, time: f64) -> Message {
        let ground = &self.ground;
        let searched = self.events.iter().rfind(|event| event.kind == "cornered").filter(|_| self.cornered.is_some());
        let velocity_at = |time: f64| ground.grid.moving[number].leg(time, ground.body.border, ground.grid.bounds()).velocity;
        if let Some(event) = searched {
            message!("drive-cause-cornered", "no safe motion had been found for {seconds:.1} s", seconds = time - event.time)
        } else if !self.view.threats.iter().any(|threat| threat.number == number) {
            message!("drive-cause-unseen", "the obstacle was not within sensor range when the robot last looked")
        } else if velocity_at(self.now) != velocity_at(time) {
            message!("drive-cause-turned", "the obstacle’s velocity had changed since the robot last looked")
        } else {
            message!("drive-cause-period", "the robot looks and decides only every {period:.2} s", period = ground.period)
        }
    }

    pub fn tell(&mut self, kind: &'static str, obstacle: Option<usize>, reason: Message) {
        self.events.push(Event { iteration: self.iteration, time: self.now, place: self.pose.at, kind, obstacle, reason });
    }

    /// The length of the plan that is left.
    pub fn left(&self) -> f64 {
        let mut at = self.pose.at;
        self.plan.left().iter().fold(0.0, |sum, step| {
            let (_, distance) = super::body::endpoints(at, step.to);
            at = step.to;
            sum + distance
        })
    }

    fn turns_left(&self) -> usize {
        let corners: Vec<_> = std::iter::once(self.pose.at).chain(self.plan.left().iter().map(|step| step.to)).collect();
        crate::geometry::turns(&corners)
    }

    /// A length with the scene's unit.
    pub fn length_of(&self, length: f64) -> Message {
        if let Some(unit) = &self.ground.scene.header().units {
            message!("drive-length-unit", "{length:.1} {unit}", length, unit)
        } else {
            message!("drive-length", "{length:.1}", length)
        }
    }

    /// Seconds that turns took, the one that it is in included.
    pub fn turning(&self) -> f64 {
        let under_way = match self.pose.turn {
            Some((_, done)) => done,
            // Turned, and not gone on yet.
            None if self.heading != [0.0; 2] && !same(self.pose.heading, self.heading) => self.ground.body.turn_time,
            None => 0.0,
        };
        self.tally.turns as f64 * self.ground.body.turn_time + under_way
    }

    /// Seconds it stood that no turn took; a turn that was given up is waiting too.
    pub fn waited(&self) -> f64 {
        (self.tally.stood - self.turning()).max(0.0)
    }

    /// How far it goes in a second, each way.
    pub fn velocity(&self) -> [f64; 2] {
        self.velocity
    }

    /// What it waits for, and since when.
    pub fn waits_for(&self) -> Option<(usize, f64)> {
        self.hold.map(|hold| (hold.obstacle, hold.since))
    }

    /// The places where it was when its motion changed, one after another.
    pub fn path(&self) -> Vec<[f64; 2]> {
        let mut path: Vec<_> = self.moments.iter().map(|&[_, x, y]| [x, y]).collect();
        path.dedup();
        path
    }
}

/// That an obstacle, as people count them, touches the robot, and why.
fn collision(obstacle: usize, drove: bool, cause: &Message) -> Message {
    if drove {
        message!("drive-collision", "The robot and obstacle {obstacle} touch while the robot drove: {cause}.", obstacle, cause)
    } else {
        message!("drive-collision-stood", "The robot and obstacle {obstacle} touch while the robot stood: {cause}.", obstacle, cause)
    }
}
