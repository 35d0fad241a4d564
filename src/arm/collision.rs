//! Collision tests of an arm, [ARM-RRT](crate#papers) §3.1: the links of its skeleton, as capsules, against the cuboids and the
//! column that it stands on.
//!
//! A link is everything as near as its radius to its segment, closed: to touch is to collide, as in the paper. Every link is
//! tested against every cuboid. Against the column (a capsule about the base's axis, from the workspace's floor up to the
//! base) all are but the first, which stands on it. The upper arm is mounted at the shoulder, which may be no farther from the
//! column than the two are thick: it must not come nearer than its mount is. With a shoulder right above the column that asks
//! nothing of the upper arm; the forearm's elbow is asked all the same.
//!
//! Motions between postures, all joints turning evenly, are tested as a whole and not at samples: a posture with more
//! room about each link than the link can travel answers for a whole stretch, and a stretch without such a posture is halved.

#[cfg(test)]
mod tests;

use crate::{arm::ArmScene, geometry::Cuboid, math::clamp};

use super::{Arm, Posture, Skeleton};

/// The column under an arm's base: everything as near as `radius` to the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// From the workspace's floor up to the base: a cuboid without width.
    pub axis: Cuboid,
    /// Its radius, in metres.
    pub radius: f64,
}

impl Column {
    /// Whether the segment `a`–`b` touches the column.
    #[inline]
    pub fn meets(&self, a: [f64; 3], b: [f64; 3]) -> bool {
        self.axis.is_within(self.radius, a, b)
    }
}

/// The column under the scene's arm, if it has one: a radius, and a base above the workspace's floor.
#[inline]
pub fn column(scene: &ArmScene) -> Option<Column> {
    let ([x, y, top], radius, floor) = (scene.arm.base.position, scene.arm.base.column_radius, scene.workspace.min[2]);
    (radius > 0.0 && top > floor).then_some(Column { axis: Cuboid { min: [x, y, floor], max: [x, y, top] }, radius })
}

/// Whether a segment of the tip's path touches the column under the arm.
#[inline]
pub fn segment_meets_column(scene: &ArmScene, a: [f64; 3], b: [f64; 3]) -> bool {
    column(scene).is_some_and(|column| column.meets(a, b))
}

/// Whether a link with this radius touches a cuboid or the column.
pub fn touches(scene: &ArmScene, skeleton: &Skeleton, radius: f64) -> bool {
    Links::new(scene, radius).touch(skeleton)
}

/// The smallest distance of a link's surface from a cuboid, in metres; `None` without cuboids. It is the distance of the link's
/// segment minus the radius, so a link whose segment meets a cuboid has −radius, however deep it is.
pub fn clearance(scene: &ArmScene, skeleton: &Skeleton, radius: f64) -> Option<f64> {
    Links::new(scene, radius).clearance(skeleton)
}

/// Whether no link touches anything between one posture and another, with all joints turning evenly.
///
/// The answer "free" is exact wherever there is more room than `resolution`, in metres. Where there is less, the tested
/// postures are so near each other that no point of a link travels farther than `resolution` in between. "Not free" is always
/// exact.
pub fn motion_is_free(scene: &ArmScene, from: &Posture, to: &Posture, radius: f64, resolution: f64) -> bool {
    Links::new(scene, radius).motion_is_free(from, to, resolution)
}

/// How much nearer to the column than the shoulder the upper arm may be: rounding.
const HAIR: f64 = 1e-9;

/// The finest resolution, as a share of the arm's reach, so that every test has an end.
const FINEST: f64 = 1e-6;

/// The links of a scene's arm and their obstacles, prepared for tests of many postures.
#[derive(Debug, Clone)]
pub struct Links<'a> {
    arm: &'a Arm,
    cuboids: &'a [Cuboid],
    radius: f64,
    column: Option<Column>,
    /// How near the upper arm may come to the column's axis.
    mount: f64,
    /// How far base, shoulder, elbow, wrist and tip are from one to the next.
    lengths: [f64; 4],
    /// Whether the tool turns about its own axis in the last joint, and goes nowhere.
    spins: bool,
}

/// What a test of one posture says about a motion.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Room {
    /// A link touches something.
    None,
    /// No link does, but one could on its way.
    Little,
    /// No link can, wherever it goes.
    Enough,
}

/// How far base–shoulder, upper arm, forearm and tool go at most.
struct Travel {
    all: [f64; 4],
    /// Without what the first joint turns them about the column: that changes no distance from it.
    about: [f64; 4],
}

impl Travel {
    const NONE: Self = Self { all: [0.0; 4], about: [0.0; 4] };
}

impl<'a> Links<'a> {
    /// The links of a scene's arm, with a radius in metres.
    pub fn new(scene: &'a ArmScene, radius: f64) -> Self {
        let arm = &scene.arm;
        let long = |a: f64, d: f64| (a * a + d * d).sqrt();
        let [_, shoulder, elbow, wrist, ..] = &arm.joints;
        // The first joint turns about the column's axis: wherever it stands, the shoulder is as far from it.
        let from_base = [shoulder.a, shoulder.d, arm.joints[0].d];
        let lengths = [
            (from_base[0] * from_base[0] + from_base[1] * from_base[1] + from_base[2] * from_base[2]).sqrt(),
            long(elbow.a, elbow.d),
            long(wrist.a, wrist.d),
            arm.joints[5].d.abs() + arm.tool.length,
        ];
        let mut links = Self {
            arm,
            cuboids: &scene.cuboids,
            radius,
            column: column(scene),
            mount: 0.0,
            lengths,
            spins: arm.tool.axis == super::Axis::Z,
        };
        if let Some(Column { axis, radius: thick }) = links.column {
            let [at, _] = links.upper_arm(0.0);
            let (needed, mounted) = (thick + radius, axis.distance_squared(at, at).sqrt() - HAIR);
            links.mount = if needed < mounted { needed } else { mounted };
        }
        links
    }

    /// Whether a link touches a cuboid or the column.
    pub fn touch(&self, skeleton: &Skeleton) -> bool {
        self.room(skeleton, &Travel::NONE) == Room::None
            || self.column.is_some_and(|column| self.leans_in(&column, [skeleton[1], skeleton[2]]))
    }

    /// The smallest distance of a link's surface from a cuboid; see [`clearance`].
    pub fn clearance(&self, skeleton: &Skeleton) -> Option<f64> {
        let mut least = f64::INFINITY;
        for link in skeleton.windows(2) {
            for cuboid in self.cuboids {
                if cuboid.gap_squared(link[0], link[1]) < least {
                    least = least.min(cuboid.distance_squared(link[0], link[1]));
                }
            }
        }
        least.is_finite().then(|| least.sqrt() - self.radius)
    }

    /// Whether no link touches anything between one posture and another; see [`motion_is_free`].
    pub fn motion_is_free(&self, from: &Posture, to: &Posture, resolution: f64) -> bool {
        if !from.iter().chain(to).all(|angle| angle.is_finite()) {
            return false;
        }
        let finest = FINEST * self.reach();
        let resolution = if resolution > finest { resolution } else { finest };
        self.upper_arm_keeps_off(from[1], to[1], resolution) && self.stretch_is_free(from, to, resolution, true)
    }

    /// How far any point of each link travels at most when the joints turn by so much: the sum of each joint's turn times
    /// the farthest that the link can be from its axis.
    fn travel(&self, turn: [f64; 6]) -> Travel {
        let [_, upper, fore, tool] = self.lengths;
        let wrist = turn[1] * (upper + fore) + turn[2] * fore;
        let hand = turn[1] + turn[2] + turn[3] + turn[4];
        let tip = wrist + hand * tool + if self.spins { 0.0 } else { turn[5] * self.arm.tool.length };
        let about = [0.0, turn[1] * upper, wrist, tip];
        let mut far = 0.0;
        let all = std::array::from_fn(|i| {
            far += self.lengths[i];
            about[i] + turn[0] * far
        });
        Travel { all, about }
    }

    /// The recursion of [`Links::motion_is_free`], for all but the upper arm and the column. `ends`: they are not known to be free.
    fn stretch_is_free(&self, from: &Posture, to: &Posture, resolution: f64, ends: bool) -> bool {
        let half = self.travel(std::array::from_fn(|i| 0.5 * (to[i] - from[i]).abs()));
        let middle: Posture = std::array::from_fn(|i| 0.5 * (from[i] + to[i]));
        match self.room(&self.arm.skeleton(&middle), &half) {
            Room::None => false,
            Room::Enough => true,
            Room::Little => {
                let is_free = |posture: &Posture| self.room(&self.arm.skeleton(posture), &Travel::NONE) != Room::None;
                if ends && !(is_free(from) && is_free(to)) {
                    return false;
                }
                2.0 * half.all[3] <= resolution
                    || (self.stretch_is_free(from, &middle, resolution, false) && self.stretch_is_free(&middle, to, resolution, false))
            }
        }
    }

    /// The share of the motion from one posture to another after which a link first touches something, from 0 to 1 and to a
    /// ten-thousandth; `None` exactly if [`Links::motion_is_free`].
    pub fn first_touch(&self, from: &Posture, to: &Posture, resolution: f64) -> Option<f64> {
        if self.motion_is_free(from, to, resolution) {
            return None;
        }
        // Of the two halves of a way that is not free, one is not.
        let (mut share, mut length, mut ends) = (0.0, 1.0, [*from, *to]);
        while length > 1e-4 {
            let middle: Posture = std::array::from_fn(|i| 0.5 * (ends[0][i] + ends[1][i]));
            length *= 0.5;
            if self.motion_is_free(&ends[0], &middle, resolution) {
                (share, ends[0]) = (share + length, middle);
            } else {
                ends[1] = middle;
            }
        }
        Some(share)
    }

    /// The largest distance of the tip from the base, in metres.
    pub fn reach(&self) -> f64 {
        self.lengths.iter().sum()
    }

    /// Whether every link has more room than it travels, but for the upper arm and the column.
    fn room(&self, skeleton: &Skeleton, travel: &Travel) -> Room {
        let mut room = Room::Enough;
        let mut test = |obstacle: &Cuboid, thick: f64, way: f64, [a, b]: [[f64; 3]; 2]| {
            let needed = thick + way;
            if obstacle.gap_squared(a, b) <= needed * needed {
                let distance = obstacle.distance_squared(a, b);
                if distance <= thick * thick {
                    return false;
                }
                if distance <= needed * needed {
                    room = Room::Little;
                }
            }
            true
        };
        for i in (0..4).rev() {
            let link = [skeleton[i], skeleton[i + 1]];
            if !self.cuboids.iter().all(|cuboid| test(cuboid, self.radius, travel.all[i], link)) {
                return Room::None;
            }
            if let Some(Column { axis, radius }) = self.column.filter(|_| i >= 2)
                && !test(&axis, radius + self.radius, travel.about[i], link)
            {
                return Room::None;
            }
        }
        room
    }

    /// Shoulder and elbow with the first joint, and the base, turned by 0.
    fn upper_arm(&self, theta2: f64) -> [[f64; 3]; 2] {
        let [base, shoulder, elbow, ..] = &self.arm.joints;
        let [x, y, z] = self.arm.base.position;
        let (sine, cosine) = (libm::sin(theta2), libm::cos(theta2));
        // Rx(±90°) takes y to ±z and z to ∓y.
        let up = if shoulder.alpha < 0.0 { -1.0 } else { 1.0 };
        let at = [x + shoulder.a, y - up * shoulder.d, z + base.d];
        [at, [at[0] + elbow.a * cosine, at[1] - up * elbow.d, at[2] + up * elbow.a * sine]]
    }

    /// Whether the upper arm touches the column.
    fn leans_in(&self, column: &Column, [shoulder, elbow]: [[f64; 3]; 2]) -> bool {
        self.mount > 0.0 && column.axis.is_within(self.mount, shoulder, elbow)
    }

    /// Whether the upper arm keeps off the column while the second joint turns: how near it comes depends on no other.
    fn upper_arm_keeps_off(&self, from: f64, to: f64, resolution: f64) -> bool {
        let Some(column) = self.column.filter(|_| self.mount > 0.0) else {
            return true;
        };
        let keeps_off = |theta2: f64| !self.leans_in(&column, self.upper_arm(theta2));
        self.upper_arm_keeps_off_between(&column, from, to, resolution) && keeps_off(from) && keeps_off(to)
    }

    fn upper_arm_keeps_off_between(&self, column: &Column, from: f64, to: f64, resolution: f64) -> bool {
        let turn = (to - from).abs();
        let middle = 0.5 * (from + to);
        let [shoulder, elbow] = self.upper_arm(middle);
        if self.leans_in(column, [shoulder, elbow]) {
            return false;
        }
        let foot: [f64; 3] = std::array::from_fn(|i| clamp(shoulder[i], column.axis.min[i], column.axis.max[i]));
        let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
        let (out, arm) = (minus(shoulder, foot), minus(elbow, shoulder));
        // The distance from the axis is convex along the arm: it grows from the shoulder on at least as it begins to. If that is
        // faster than what a point so far out travels, no point can come nearer than the shoulder is.
        let (way, grows) = (0.5 * turn * self.lengths[1], dot(arm, out) / dot(out, out).sqrt());
        if grows >= way || !column.axis.is_within(self.mount + way, shoulder, elbow) {
            return true;
        }
        2.0 * way <= resolution
            || (self.upper_arm_keeps_off_between(column, from, middle, resolution)
                && self.upper_arm_keeps_off_between(column, middle, to, resolution))
    }
}
