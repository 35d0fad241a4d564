//! Moving obstacles: discs with constant velocity, or with timed waypoints, [WOLF-ANT](crate#papers) §5.
//!
//! Reading: walls do not stop them, and they do not stop each other.

use crate::{
    geometry::{Bounds, closest_approach, first_within},
    kernel::{Border, Error, error::list_of},
    message,
};

use super::check::{LARGEST, coordinate, finite, limited, positive};

/// The largest number of waypoints of a moving obstacle.
pub const MAX_WAYPOINTS: usize = 10_000;

/// The largest number of moving obstacles of a scene.
pub const MAX_MOVING: usize = 1000;

/// The least time from one border to the other, in seconds.
const SHORTEST: f64 = 1e-6;

/// A moving obstacle: a disc.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "types",
    derive(ts_rs::TS),
    ts(type = "{
        /** The position of its centre at time 0, in the scene's unit. */
        center: [number, number];
        /** Its radius, in the scene's unit. */
        radius: number;
        /** Its velocity, in the scene's unit per second. */
        velocity?: [number, number];
        /** Instead of a velocity: [t, x, y] by growing t > 0, in seconds. At the last it stays. */
        waypoints?: Array<[number, number, number]>;
    }")
)]
pub struct Moving {
    /// The position of its centre at time 0, in the scene's unit.
    pub center: [f64; 2],
    /// Its radius, in the scene's unit.
    pub radius: f64,
    /// Its motion.
    pub motion: Motion,
}

/// The motion of a moving obstacle.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// A constant velocity, in the scene's unit per second.
    Velocity([f64; 2]),
    /// Waypoints `[t, x, y]` by growing t > 0, in seconds: straight from one to the next, reached at time t. It stays at the
    /// last.
    Waypoints(Vec<[f64; 3]>),
}

/// A leg of a motion, with constant velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// The position of the centre at its beginning.
    pub at: [f64; 2],
    /// The velocity, in the scene's unit per second.
    pub velocity: [f64; 2],
    /// The time of its end, in seconds; infinite for the last leg.
    pub until: f64,
}

impl Moving {
    /// A moving obstacle with constant velocity.
    pub fn straight(center: [f64; 2], radius: f64, velocity: [f64; 2]) -> Self {
        Self { center, radius, motion: Motion::Velocity(velocity) }
    }

    /// The rest of the leg at a time ≥ 0, from its position then. `until` is always later than `time`.
    pub fn leg(&self, time: f64, border: Border, bounds: Bounds) -> Leg {
        match &self.motion {
            Motion::Waypoints(points) => self.between(points, time),
            Motion::Velocity(velocity) if border == Border::Leave => {
                Leg { at: [0, 1].map(|axis| self.center[axis] + time * velocity[axis]), velocity: *velocity, until: f64::INFINITY }
            }
            Motion::Velocity(velocity) => {
                let axes = [0, 1].map(|axis| {
                    let (low, high) = (bounds.min[axis] + self.radius, bounds.max[axis] - self.radius);
                    // Where it begins it has room, even where it reaches over the border.
                    let range = [low.min(self.center[axis]), high.max(self.center[axis])];
                    bounced(self.center[axis], velocity[axis], range, time)
                });
                Leg { at: axes.map(|leg| leg[0]), velocity: axes.map(|leg| leg[1]), until: axes[0][2].min(axes[1][2]) }
            }
        }
    }

    /// The position of its centre at a time.
    pub fn at(&self, time: f64, border: Border, bounds: Bounds) -> [f64; 2] {
        self.leg(time, border, bounds).at
    }

    fn between(&self, points: &[[f64; 3]], time: f64) -> Leg {
        let next = points.partition_point(|point| point[0] <= time);
        let [from, x, y] = next.checked_sub(1).map_or([0.0, self.center[0], self.center[1]], |last| points[last]);
        let Some(&[until, to_x, to_y]) = points.get(next) else {
            return Leg { at: [x, y], velocity: [0.0; 2], until: f64::INFINITY };
        };
        let velocity = [(to_x - x) / (until - from), (to_y - y) / (until - from)];
        Leg { at: [x + (time - from) * velocity[0], y + (time - from) * velocity[1]], velocity, until }
    }

    /// The time at which its centre first is nearer than `reach` to a point that is at `at` at time `from` and moves with
    /// `velocity` until `until`; exact, bounces and waypoints included.
    pub fn first_within(
        &self,
        at: [f64; 2],
        velocity: [f64; 2],
        [from, until]: [f64; 2],
        reach: f64,
        border: Border,
        bounds: Bounds,
    ) -> Option<f64> {
        self.stretches(at, velocity, [from, until], border, bounds)
            .find_map(|(start, seconds, apart, closing)| Some(start + first_within(apart, closing, seconds, reach)?))
    }

    /// The smallest distance of its centre from a point that moves as in [`Moving::first_within`].
    pub fn least_distance(&self, at: [f64; 2], velocity: [f64; 2], [from, until]: [f64; 2], border: Border, bounds: Bounds) -> f64 {
        self.stretches(at, velocity, [from, until], border, bounds)
            .map(|(_, seconds, apart, closing)| closest_approach(apart, closing, seconds).1)
            .fold(f64::INFINITY, f64::min)
    }

    /// The legs between two times, relative to a point with constant velocity: the beginning and the duration of each, the
    /// disc's position relative to the point at its beginning, and the relative velocity.
    pub fn stretches(
        &self,
        at: [f64; 2],
        velocity: [f64; 2],
        [from, until]: [f64; 2],
        border: Border,
        bounds: Bounds,
    ) -> impl Iterator<Item = (f64, f64, [f64; 2], [f64; 2])> + '_ {
        let mut time = from;
        let mut first = true;
        std::iter::from_fn(move || {
            // Of no time at all there is one stretch: the moment.
            if !(time < until || std::mem::replace(&mut first, false)) {
                return None;
            }
            first = false;
            let leg = self.leg(time, border, bounds);
            let start = time;
            time = leg.until.min(until);
            let apart = [0, 1].map(|axis| leg.at[axis] - at[axis] - (start - from) * velocity[axis]);
            let closing = [0, 1].map(|axis| leg.velocity[axis] - velocity[axis]);
            Some((start, (time - start).max(0.0), apart, closing))
        })
    }

    /// Refuses what is no disc in motion. `name` is what to call it.
    pub(super) fn check(&self, name: &str) -> Result<(), Error> {
        (0..2).try_for_each(|axis| coordinate(&format!("{name}.center"), self.center, axis))?;
        positive(&format!("{name}.radius"), self.radius)?;
        match &self.motion {
            Motion::Velocity(velocity) => (0..2).try_for_each(|axis| coordinate(&format!("{name}.velocity"), *velocity, axis)),
            Motion::Waypoints(points) => {
                let field = format!("{name}.waypoints");
                if points.is_empty() || points.len() > MAX_WAYPOINTS {
                    let allowed = message!("scene-waypoints", "1 to {most} waypoints", most = MAX_WAYPOINTS);
                    return Err(Error::refused(field, list_of(points.len()), allowed));
                }
                let [x, y] = self.center;
                let mut before = [0.0, x, y];
                for (i, &point) in points.iter().enumerate() {
                    let field = format!("{field}[{i}]");
                    (0..3).try_for_each(|k| finite(&format!("{field}[{k}]"), point[k]))?;
                    (1..3).try_for_each(|k| limited(&format!("{field}[{k}]"), point[k]))?;
                    let (time, seconds) = (format!("{field}[0]"), point[0] - before[0]);
                    if seconds <= 0.0 || point[0] > LARGEST {
                        let allowed = message!(
                            "scene-waypoint-time",
                            "after {before}, at most {most}: the times of waypoints grow",
                            before = before[0],
                            most = LARGEST
                        );
                        return Err(Error::refused(time, point[0], allowed));
                    }
                    // Nothing is faster than what has a velocity; a time too short to divide by would lead nowhere.
                    if (1..3).any(|k| (point[k] - before[k]).abs() > seconds * LARGEST) {
                        let allowed =
                            message!("scene-waypoint-speed", "late enough to be there at no more than {most} a second", most = LARGEST);
                        return Err(Error::refused(time, point[0], allowed));
                    }
                    before = point;
                }
                Ok(())
            }
        }
    }
}

/// A coordinate that goes to and fro in a range: where it is at a time, how fast it goes, and when it turns next.
fn bounced(start: f64, velocity: f64, [low, high]: [f64; 2], time: f64) -> [f64; 3] {
    let span = high - low;
    // Between borders that it all but touches both it stands: it would turn more often than anybody can follow.
    if velocity == 0.0 || span <= velocity.abs() * SHORTEST {
        return [start, 0.0, f64::INFINITY];
    }
    let speed = velocity.abs();
    let ahead = if velocity > 0.0 { high } else { low };
    let (first, period) = ((ahead - start).abs() / speed, span / speed);
    // The k-th turn is at first + (k − 1) · period; the division may be off by one.
    let turn = |k: f64| first + (k - 1.0) * period;
    let mut k = if time < first { 0.0 } else { ((time - first) / period).floor() + 1.0 };
    while k > 0.0 && turn(k) > time {
        k -= 1.0;
    }
    while turn(k + 1.0) <= time {
        k += 1.0;
    }
    if k == 0.0 {
        return [start + time * velocity, velocity, first];
    }
    let odd = k % 2.0 == 1.0;
    let (from, now) = match (odd, velocity > 0.0) {
        (true, true) | (false, false) => (high, -speed),
        _ => (low, speed),
    };
    [from + (time - turn(k)) * now, now, turn(k + 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    const BOUNDS: Bounds = Bounds { min: [0.0, 0.0], max: [10.0, 20.0] };

    #[test]
    fn it_leaves_or_bounces_off_as_soon_as_it_touches() {
        // Radius 1, from (4, 5) by (3, −2) a second: the right border after 5/3 s, the lower one after 2 s.
        let disc = Moving::straight([4.0, 5.0], 1.0, [3.0, -2.0]);
        assert_eq!(disc.leg(4.0, Border::Leave, BOUNDS), Leg { at: [16.0, -3.0], velocity: [3.0, -2.0], until: f64::INFINITY });
        let first = disc.leg(0.0, Border::Bounce, BOUNDS);
        assert_eq!(first, Leg { at: [4.0, 5.0], velocity: [3.0, -2.0], until: 5.0 / 3.0 });
        let second = disc.leg(5.0 / 3.0, Border::Bounce, BOUNDS);
        assert_eq!((second.velocity, second.until), ([-3.0, -2.0], 2.0));
        let third = disc.leg(3.0, Border::Bounce, BOUNDS);
        assert_eq!((third.at, third.velocity), ([5.0, 3.0], [-3.0, 2.0]), "9 − 3 · 4/3, 1 + 2 · 1");
        assert_eq!(third.until, 5.0 / 3.0 + 8.0 / 3.0);
    }

    #[test]
    fn it_goes_from_way_point_to_way_point_and_stays_at_the_last() {
        let disc =
            Moving { motion: Motion::Waypoints(vec![[2.0, 8.0, 5.0], [3.0, 8.0, 2.0]]), ..Moving::straight([4.0, 5.0], 1.0, [0.0; 2]) };
        let leg = |t| disc.leg(t, Border::Bounce, BOUNDS);
        assert_eq!(leg(1.0), Leg { at: [6.0, 5.0], velocity: [2.0, 0.0], until: 2.0 });
        assert_eq!(leg(2.0), Leg { at: [8.0, 5.0], velocity: [0.0, -3.0], until: 3.0 });
        assert_eq!(leg(9.0), Leg { at: [8.0, 2.0], velocity: [0.0, 0.0], until: f64::INFINITY });
    }

    #[test]
    fn the_first_contact_is_found_over_bounces() {
        // Between y = 1 and 19 it goes down, up and down again; a point waits at (4, 10), 3 apart is too near.
        let disc = Moving::straight([4.0, 5.0], 1.0, [0.0, -4.0]);
        let met = disc.first_within([4.0, 10.0], [0.0; 2], [0.0, 9.0], 3.0, Border::Bounce, BOUNDS);
        assert_eq!(met, Some(2.5), "4 down, 6 up");
        assert_eq!(disc.first_within([4.0, 10.0], [0.0; 2], [0.0, 2.4], 3.0, Border::Bounce, BOUNDS), None);
        assert_eq!(disc.first_within([4.0, 10.0], [0.0; 2], [0.0, 9.0], 3.0, Border::Leave, BOUNDS), None);
        // The point comes to meet it: 9 apart at 1 s, together by 4 + 1 a second.
        let met = disc.first_within([4.0, 10.0], [0.0, -1.0], [1.0, 9.0], 3.0, Border::Bounce, BOUNDS);
        assert_eq!(met, Some(1.0 + 6.0 / 5.0));
    }

    /// What is found along the legs is what fine steps find, and the motion never jumps.
    #[test]
    fn motion_is_continuous_and_stays_inside_when_it_bounces() {
        let mut rng = Stream::new(9, 0);
        for _ in 0..300 {
            let fast = crate::math::pow(10.0, rng.between(-1.0, 3.0));
            let disc = Moving::straight(
                [rng.between(1.0, 9.0), rng.between(1.0, 19.0)],
                1.0,
                [rng.between(-fast, fast), rng.between(-fast, fast)],
            );
            let (mut time, mut before) = (0.0, disc.center);
            for _ in 0..50 {
                let leg = disc.leg(time, Border::Bounce, BOUNDS);
                assert!(leg.until > time);
                let slack = 1e-9 * (1.0 + fast);
                assert!((0..2).all(|axis| (leg.at[axis] - before[axis]).abs() < slack), "{:?} {before:?}", leg.at);
                assert!((1.0 - slack..=9.0 + slack).contains(&leg.at[0]) && (1.0 - slack..=19.0 + slack).contains(&leg.at[1]));
                if leg.until.is_infinite() {
                    break;
                }
                before = [0, 1].map(|axis| leg.at[axis] + (leg.until - time) * leg.velocity[axis]);
                time = leg.until;
            }
        }
    }

    /// However little room it has and however fast it is: the stretches of a minute can be counted.
    #[test]
    fn a_disc_that_all_but_fills_the_grid_stands() {
        for room in [0.0, 1e-300, 1e-12, 1e-6] {
            let disc = Moving::straight([5.0, 5.0], 5.0 - room / 2.0, [1e6, 1e-3]);
            assert_eq!(disc.leg(1e6, Border::Bounce, BOUNDS).velocity[0], 0.0);
            assert!(disc.stretches([0.0; 2], [0.0; 2], [0.0, 60.0], Border::Bounce, BOUNDS).count() < 3);
        }
        let disc = Moving::straight([5.0, 5.0], 4.0, [1e4, 0.0]);
        let count = disc.stretches([0.0; 2], [0.0; 2], [0.0, 1.0], Border::Bounce, BOUNDS).count();
        assert!((5000..=5001).contains(&count), "2 wide at 10 000 a second: {count}");
    }

    #[test]
    fn what_is_no_motion_is_refused_by_name() {
        let disc = |points: Vec<[f64; 3]>| Moving { motion: Motion::Waypoints(points), ..Moving::straight([4.0, 5.0], 1.0, [0.0; 2]) };
        let refused = |points| disc(points).check("moving[2]").unwrap_err().to_string();
        assert!(refused(vec![[1.0, 2.0, 3.0], [1.0, 4.0, 5.0]]).contains("moving[2].waypoints[1][0]"));
        assert!(refused(vec![]).contains("moving[2].waypoints"));
        for k in 0..3 {
            for wrong in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
                let mut point = [2.0, 3.0, 4.0];
                point[k] = wrong;
                assert!(refused(vec![[1.0, 2.0, 3.0], point]).contains(&format!("moving[2].waypoints[1][{k}]")));
            }
        }
        for (wrong, field) in [
            (Moving::straight([f64::NAN, 5.0], 1.0, [0.0; 2]), "moving[0].center[0]"),
            (Moving::straight([4.0, 5.0], f64::NAN, [0.0; 2]), "moving[0].radius"),
            (Moving::straight([4.0, 5.0], f64::INFINITY, [0.0; 2]), "moving[0].radius"),
            (Moving::straight([4.0, 5.0], 1.0, [0.0, f64::NAN]), "moving[0].velocity[1]"),
        ] {
            assert_eq!(wrong.check("moving[0]").unwrap_err().field(), field);
        }
        assert!(disc(vec![[1.0, 2.0, 3.0]]).check("moving[0]").is_ok());
    }
}
