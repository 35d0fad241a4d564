//! Where the wrist and the tip can come, whatever the joints' limits: the first three joints.

use std::f64::consts::FRAC_PI_2;

use crate::math::{acos, atan2, clamp, cos, sin};

use super::{Arm, Posture, Unreachable};

/// How far beyond its reach the wrist is let be, in metres: what rounding may do to a pose at the very border.
const REACH: f64 = 1e-11;
/// How near to the first or the second joint's axis the wrist lies on it, in metres: that joint may then turn as it likes.
const AXIS: f64 = 1e-10;
/// How many circles of latitude of the wrist's sphere are looked at before those between them are.
const LATITUDES: u32 = 32;

/// The lengths of the first three joints. The wrist turns about the elbow, and the elbow about the shoulder, in a plane that
/// turns with joint 1 and lies `aside` of its axis.
pub(super) struct Limbs {
    /// The sign of α1 and of α3.
    shoulder_sign: f64,
    forearm_sign: f64,
    /// From the base up to the shoulder.
    height: f64,
    /// From joint 1's axis to the shoulder.
    shoulder: f64,
    /// d2 + d3.
    aside: f64,
    /// a2.
    upper: f64,
    /// From the elbow to the wrist, as joint 3's frame has it, and how long that is.
    fore: [f64; 2],
    forearm: f64,
}

/// Angles of the first three joints that bring the wrist somewhere.
pub(super) struct Stretch {
    pub(super) theta: [f64; 3],
    /// Sine and cosine of θ1, and of θ2 + θ3.
    first: [f64; 2],
    both: [f64; 2],
    shoulder_sign: f64,
    forearm_sign: f64,
}

impl Stretch {
    /// A vector of the base's frame in that of the wrist's first axis: turned back by joint 1, α1, joints 2 and 3, α3.
    #[inline]
    pub(super) fn back(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let turn = |[sine, cosine]: [f64; 2], x: f64, y: f64| [cosine * x + sine * y, cosine * y - sine * x];
        let [x, y] = turn(self.first, x, y);
        let (y, z) = (self.shoulder_sign * z, -self.shoulder_sign * y);
        let [x, y] = turn(self.both, x, y);
        [x, self.forearm_sign * z, -self.forearm_sign * y]
    }
}

impl Limbs {
    pub(super) fn of(arm: &Arm) -> Self {
        let [j1, j2, j3, j4, ..] = &arm.joints;
        let fore = [j4.a, -j4.alpha.signum() * j4.d];
        Self {
            shoulder_sign: j2.alpha.signum(),
            forearm_sign: j4.alpha.signum(),
            height: j1.d,
            shoulder: j2.a,
            aside: j2.d + j3.d,
            upper: j3.a,
            fore,
            forearm: length(fore[0], fore[1]),
        }
    }

    /// How far the wrist is from the shoulder at least and at most.
    fn range(&self) -> (f64, f64) {
        ((self.upper.abs() - self.forearm).abs() - REACH, self.upper.abs() + self.forearm + REACH)
    }

    /// Every stretch that brings the wrist to a point of the base's frame: two θ1, and two θ3 for each, and θ2 with them.
    /// A joint whose axis the wrist lies on stays where it is in `near`.
    pub(super) fn stretches(&self, [x, y, z]: [f64; 3], near: &Posture, mut found: impl FnMut(&Stretch)) {
        let Self { shoulder_sign, forearm_sign, aside, upper, fore: [along, across], forearm, .. } = *self;
        let (sideways, square) = (shoulder_sign * aside, x * x + y * y);
        let ahead = square - aside * aside;
        let tolerated = 2.0 * REACH * aside.abs().max(REACH);
        if !(-tolerated..).contains(&ahead) {
            return;
        }
        let (least, most) = self.range();
        let v = shoulder_sign * (z - self.height);
        for turned in [1.0, -1.0] {
            // θ1 = atan2(p_y, p_x) or half a turn from it, [ARM-RRT]; here with what the plane lies aside of the axis.
            let r = turned * ahead.max(0.0).sqrt();
            let (theta1, first) = if square < AXIS * AXIS {
                free(near[0] + if turned > 0.0 { 0.0 } else { 2.0 * FRAC_PI_2 })
            } else {
                fixed(y * r + sideways * x, x * r - sideways * y)
            };
            // From the shoulder to the wrist, in the plane.
            let u = r - self.shoulder;
            let away = length(u, v);
            if !(least..=most).contains(&away) {
                continue;
            }
            // The law of cosines: θ3 but for the forearm's own angle.
            let cosine = clamp((away * away - upper * upper - forearm * forearm) / (2.0 * upper * forearm), -1.0, 1.0);
            for bent in [1.0, -1.0] {
                let sine = bent * ((1.0 - cosine) * (1.0 + cosine)).sqrt();
                let (theta3, [sin3, cos3]) = fixed(sine * along - cosine * across, cosine * along + sine * across);
                // Where the wrist is while θ2 = 0.
                let (p, q) = (upper + forearm * cosine, forearm * sine);
                let (theta2, [sin2, cos2]) = if away < AXIS { free(near[1]) } else { fixed(v * p - u * q, u * p + v * q) };
                let both = [sin2 * cos3 + cos2 * sin3, cos2 * cos3 - sin2 * sin3];
                found(&Stretch { theta: [theta1, theta2, theta3], first, both, shoulder_sign, forearm_sign });
            }
        }
    }

    /// Why the wrist cannot come where it should: whether any other direction of the tool, whose tip is `reach` away from the
    /// wrist, would bring the tip to this point of the base's frame.
    ///
    /// The wrist would lie on a sphere about the tip. Turned about joint 1's axis into a half plane that sphere covers a
    /// connected region, whose smallest and greatest distance from the shoulder decide. They are found along the circles of
    /// latitude: each by its closed form, the best circle by sampling and then narrowing down to 1e-9 of the radius.
    #[cold]
    pub(super) fn fault(&self, [x, y, z]: [f64; 3], reach: f64) -> Unreachable {
        let (least, most) = self.range();
        let (out, up, aside) = (length(x, y), z - self.height, self.aside.abs());
        let nearest = length(out, up) - reach;
        if !(..=self.shoulder.abs() + aside + most).contains(&nearest) || out + reach < aside {
            return Unreachable::Position;
        }
        // Only latitudes whose circle comes as far out as the plane lies aside.
        let end = if aside > out { acos(clamp((aside - out) / reach, -1.0, 1.0)) } else { FRAC_PI_2 };
        // Squared distances from the shoulder: nearest and farthest on the circle of one latitude.
        let distances = |shoulder: f64, latitude: f64| {
            let (across, v) = (reach * cos(latitude), up + reach * sin(latitude));
            let inside = |far: f64| (far * far - aside * aside).max(0.0).sqrt();
            let (from, to) = (inside((out - across).abs().max(aside)), inside(out + across));
            let nearest = clamp(shoulder, from, to) - shoulder;
            let farthest = (from - shoulder).abs().max((to - shoulder).abs());
            [nearest * nearest + v * v, farthest * farthest + v * v]
        };
        let step = 2.0 * end / f64::from(LATITUDES);
        let comes = [self.shoulder, -self.shoulder].into_iter().any(|shoulder| {
            let mut best = [(f64::INFINITY, 0.0), (f64::NEG_INFINITY, 0.0)];
            for latitude in (0..=LATITUDES).map(|i| f64::from(i) * step - end) {
                let [nearest, farthest] = distances(shoulder, latitude);
                best[0] = if nearest < best[0].0 { (nearest, latitude) } else { best[0] };
                best[1] = if farthest > best[1].0 { (farthest, latitude) } else { best[1] };
                if best[0].0 <= most * most && best[1].0 >= least.max(0.0) * least {
                    return true;
                }
            }
            let narrow = |at: f64, which: usize, sign: f64| {
                let (mut low, mut high) = ((at - step).max(-end), (at + step).min(end));
                for _ in 0..40 {
                    let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                    if sign * distances(shoulder, a)[which] < sign * distances(shoulder, b)[which] { high = b } else { low = a }
                }
                distances(shoulder, f64::midpoint(low, high))[which]
            };
            narrow(best[0].1, 0, 1.0).sqrt() <= most && narrow(best[1].1, 1, -1.0).sqrt() >= least
        });
        if comes { Unreachable::Orientation } else { Unreachable::Position }
    }
}

#[inline]
fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// The angle of this sine and cosine, which are scaled to an angle's.
#[inline]
fn fixed(sine: f64, cosine: f64) -> (f64, [f64; 2]) {
    let scale = 1.0 / length(sine, cosine);
    (atan2(sine, cosine), [sine * scale, cosine * scale])
}

/// An angle that nothing determines, with its sine and cosine.
#[cold]
fn free(angle: f64) -> (f64, [f64; 2]) {
    let (sine, cosine) = libm::sincos(angle);
    (angle, [sine, cosine])
}
