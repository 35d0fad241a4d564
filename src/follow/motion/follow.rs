//! Which postures bring the tip to a point of the path, and what is done about a point that none brings it to.

use nalgebra::{Isometry3, UnitQuaternion};

use crate::{
    arm::{Arm, ArmScene, Hand, Holding, Links, Posture, Unreachable, squared},
    kernel::{Message, rng::Stream},
    message,
};

use super::course::{Station, between, distance};

/// How the tool is turned at the path's points.
#[derive(Debug)]
pub(super) enum Pointing {
    /// Any way.
    Free,
    /// So, point by point.
    PointByPoint(Vec<UnitQuaternion<f64>>),
}

/// What can be asked of the arm on its way.
#[derive(Debug)]
pub(super) struct Postures<'a> {
    pub(super) scene: &'a ArmScene,
    pub(super) links: Links<'a>,
    pub(super) holding: Holding,
    pub(super) hands: Vec<Hand>,
    pub(super) pointing: Pointing,
    pub(super) resolution: f64,
    /// Whether a point without a posture is mirrored or drawn.
    pub(super) replaces: bool,
    pub(super) tries: u64,
    pub(super) random: Stream,
}

/// A point of the path with its posture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stop {
    pub(super) station: Station,
    pub(super) posture: Posture,
}

/// How far the arm came, and how.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Followed {
    /// From the start as far as it came.
    pub(super) stops: Vec<Stop>,
    pub(super) mirrored: u64,
    pub(super) drawn: u64,
    /// Why it came no farther.
    pub(super) failure: Option<Message>,
}

impl Followed {
    /// The arm ends before this point.
    pub(super) fn end(mut self, follower: &Postures, stations: &[Station], point: usize) -> Self {
        self.failure = Some(follower.failure(stations, point));
        self
    }
}

impl Postures<'_> {
    pub(super) fn arm(&self) -> &Arm {
        &self.scene.arm
    }

    /// The postures within the limits that bring the tip to a point, whether they touch anything or not: of those that are whole
    /// turns apart the one near `near`. Where the tool may point anywhere they are some of infinitely many.
    pub(super) fn postures(&self, station: usize, at: [f64; 3], hands: &[Hand], near: &Posture) -> Vec<Posture> {
        let mut found = Vec::new();
        match &self.pointing {
            Pointing::Free => {
                hands.iter().for_each(|hand| self.holding.reach(hand, at, near, &mut |posture| found.push(posture)));
                if found.is_empty() {
                    let all = Arm::directions().iter().filter_map(|direction| self.arm().reaching(at, direction, near).ok());
                    all.for_each(|some| found.extend_from_slice(&some));
                }
            }
            Pointing::PointByPoint(rotations) => {
                let pose = Isometry3::from_parts(at.into(), rotations[station]);
                if let Ok(solutions) = self.arm().inverse(&pose, near) {
                    solutions.iter().for_each(|posture| self.with_turns(posture, &mut found));
                }
            }
        }
        found
    }

    /// A posture and those with joints a whole turn off, where limits are that wide.
    fn with_turns(&self, posture: &Posture, found: &mut Vec<Posture>) {
        let first = found.len();
        found.push(*posture);
        for (i, joint) in self.arm().joints.iter().enumerate().filter(|(_, joint)| joint.max - joint.min >= 360.0) {
            for k in first..found.len() {
                for turn in [-360.0_f64, 360.0] {
                    let mut turned = found[k];
                    turned[i] += turn.to_radians();
                    if (joint.min.to_radians()..=joint.max.to_radians()).contains(&turned[i]) {
                        found.push(turned);
                    }
                }
            }
        }
    }

    /// Those of [`Postures::postures`] that touch nothing.
    pub(super) fn safe(&self, station: usize, at: [f64; 3], hands: &[Hand], near: &Posture) -> Vec<Posture> {
        let mut found = self.postures(station, at, hands, near);
        found.retain(|posture| self.is_safe(posture));
        found
    }

    pub(super) fn is_safe(&self, posture: &Posture) -> bool {
        !self.links.touch(&self.arm().skeleton(posture))
    }

    pub(super) fn is_free(&self, from: &Posture, to: &Posture) -> bool {
        self.links.motion_is_free(from, to, self.resolution)
    }

    /// Random joints between two postures', [ARM-RRT](crate#papers) step 6, until a posture touches nothing, and nor does the
    /// move to it.
    pub(super) fn draw(&mut self, from: &Posture, to: &Posture) -> Option<Posture> {
        (0..self.tries).find_map(|_| {
            let posture = std::array::from_fn(|i| from[i] + self.random.unit() * (to[i] - from[i]));
            (self.is_safe(&posture) && self.is_free(from, &posture)).then_some(posture)
        })
    }

    /// Which point has no posture, and why.
    fn failure(&self, stations: &[Station], point: usize) -> Message {
        let Station { at: [x, y, z], along } = stations[point];
        let home = self.arm().home();
        let why = match &self.pointing {
            Pointing::Free => self.arm().reaching_somehow([x, y, z], &home).err(),
            Pointing::PointByPoint(rotations) => {
                self.arm().inverse(&Isometry3::from_parts([x, y, z].into(), rotations[point]), &home).err()
            }
        };
        let why = why.map_or_else(
            || message!("motion-all-touch", "every posture that was tried there touches a cuboid or the column"),
            Unreachable::message,
        );
        message!(
            "motion-ends-before",
            "point {point} of {points}, ({x:.4}, {y:.4}, {z:.4}), {along:.4} m along the path: {why}",
            point = point + 1,
            points = stations.len(),
            x,
            y,
            z,
            along,
            why
        )
    }

    /// The paper's way: at each point the posture nearest to the last, one that touches nothing if there is any.
    pub(super) fn nearest(&mut self, stations: &[Station]) -> Followed {
        let (mut followed, mut last) = (Followed::default(), self.arm().home());
        for (i, &station) in stations.iter().enumerate() {
            let is_first = i == 0;
            let mut found = self.next(i, station.at, &last, is_first);
            if let (None, false, Some(after)) = (found, is_first, stations.get(i + 1).filter(|_| self.replaces)) {
                found = self.next(i, mirrored(stations[i - 1].at, station.at, after.at), &last, false);
                followed.mirrored += u64::from(found.is_some());
            }
            if found.is_none() && !is_first {
                let next = (i + 1..stations.len()).find_map(|j| self.next(j, stations[j].at, &last, true));
                found = next.and_then(|next| self.draw(&last, &next));
                followed.drawn += u64::from(found.is_some());
            }
            let Some(posture) = found else {
                return followed.end(self, stations, i);
            };
            followed.stops.push(Stop { station, posture });
            last = posture;
        }
        followed
    }

    /// The posture nearest to the last one: that which can be gone to without touching anything, else that which touches
    /// nothing once it is there.
    fn next(&self, station: usize, at: [f64; 3], last: &Posture, jumps: bool) -> Option<Posture> {
        let own = self.holding.hand([last[3], last[4], last[5]]);
        let mut found = self.postures(station, at, &[own], last);
        found.extend(self.postures(station, at, &self.hands, last));
        let order = crate::math::ordered(found.iter().map(|posture| squared(posture, last)));
        let mut safe = order.into_iter().map(|(_, place)| &found[place]).filter(|posture| self.is_safe(posture));
        let nearest = *safe.next()?;
        if jumps || self.is_free(last, &nearest) {
            return Some(nearest);
        }
        Some(safe.find(|posture| self.is_free(last, posture)).copied().unwrap_or(nearest))
    }
}

/// A point's mirror image about the middle of its neighbours, [ARM-RRT](crate#papers) step 4.
pub(super) fn mirrored(before: [f64; 3], at: [f64; 3], after: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| before[i] + after[i] - at[i])
}

/// A posture the given share of the way from one to another.
pub(super) fn evenly(from: &Posture, to: &Posture, share: f64) -> Posture {
    between(*from, *to, share)
}

/// Postures that were planned, and as many in between that the tip goes no farther than `spacing` from one to the next.
pub(super) fn densified(arm: &Arm, postures: &[Posture], spacing: f64) -> Vec<Stop> {
    /// Over so many pieces of a move the tip's way is measured.
    const PIECES: i32 = 16;
    /// The most pieces of a move.
    const MOST: f64 = 2000.0;
    let tip = |posture: &Posture| arm.skeleton(posture)[4];
    let mut stops: Vec<_> =
        postures.first().map(|posture| Stop { station: Station { at: tip(posture), along: 0.0 }, posture: *posture }).into_iter().collect();
    for pair in postures.windows(2) {
        let marks: Vec<_> = (0..=PIECES).map(|i| tip(&evenly(&pair[0], &pair[1], f64::from(i) / f64::from(PIECES)))).collect();
        let way: f64 = marks.windows(2).map(|w| distance(w[0], w[1])).sum();
        let pieces = (way / spacing).ceil().clamp(1.0, MOST);
        for i in 1..=pieces as usize {
            let posture = if i as f64 == pieces { pair[1] } else { evenly(&pair[0], &pair[1], i as f64 / pieces) };
            let at = tip(&posture);
            let along = stops.last().map_or(0.0, |last: &Stop| last.station.along + distance(last.station.at, at));
            stops.push(Stop { station: Station { at, along }, posture });
        }
    }
    stops
}
