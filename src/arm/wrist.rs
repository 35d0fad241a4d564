//! The last three joints: how they turn the tool, [ARM-RRT](crate#papers) §2.1 with its singular case.

use std::f64::consts::PI;

use crate::math::atan2;

use super::{Arm, Posture};

/// The largest |sin θ5| of a singular wrist: θ4 and θ6 then turn about one axis, to within 1e-10 rad.
pub const SINGULAR: f64 = 1e-10;

/// The signs of α4 and α5.
pub(super) struct Wrist {
    sign4: f64,
    sign5: f64,
}

/// What the wrist must do: R = Rz(θ4) Rx(α4) Rz(θ5) Rx(α5) Rz(θ6), its columns.
pub(super) type Turn = [[f64; 3]; 3];

/// Angles of the last three joints.
pub(super) enum Turned {
    /// Two ways, one with sin θ5 above 0 and one with it below.
    Twice([[f64; 3]; 2]),
    /// sin θ5 = 0: θ5, and the sum θ6 + sign θ4 that alone is determined.
    Singular {
        /// 0 or π.
        theta5: f64,
        /// 1 if θ4 and θ6 turn the same way round, else −1.
        sign: f64,
        /// θ6 + sign θ4.
        sum: f64,
    },
}

impl Wrist {
    pub(super) fn of(arm: &Arm) -> Self {
        Self { sign4: arm.joints[4].alpha.signum(), sign5: arm.joints[5].alpha.signum() }
    }

    /// The third column of R is (s5 sin θ5 cos θ4, s5 sin θ5 sin θ4, −s4 s5 cos θ5), s4 and s5 the signs of α4 and α5. θ6
    /// follows from the rows that θ4 turns back: it is as accurate where sin θ5 is small.
    pub(super) fn turns(&self, r: &Turn) -> Turned {
        let Self { sign4, sign5 } = *self;
        let [r13, r23, r33] = r[2];
        let sine = (r13 * r13 + r23 * r23).sqrt();
        let cosine = -sign4 * sign5 * r33;
        let theta6 = |sin4: f64, cos4: f64| {
            let back = |column: [f64; 3]| -sign4 * sign5 * (cos4 * column[1] - sin4 * column[0]);
            atan2(back(r[0]), back(r[1]))
        };
        if sine <= SINGULAR {
            return Turned::Singular {
                theta5: if cosine < 0.0 { PI } else { 0.0 },
                sign: if r33 < 0.0 { -1.0 } else { 1.0 },
                sum: theta6(0.0, 1.0),
            };
        }
        Turned::Twice([1.0, -1.0].map(|sign| {
            let (y, x) = (sign * sign5 * r23, sign * sign5 * r13);
            [atan2(y, x), atan2(sign * sine, cosine), theta6(y / sine, x / sine)]
        }))
    }
}

/// θ4 and θ6 of a singular wrist, nearest to where they are: θ6 + sign θ4 is kept, [ARM-RRT](crate#papers) §2.1, and both turn
/// by as much as they can share. `None` if no turn keeps them within their ranges.
pub(super) fn share(sum: f64, sign: f64, near: &Posture, ranges: [[f64; 2]; 2]) -> Option<[f64; 2]> {
    let [[min4, max4], [min6, max6]] = ranges;
    let missing = sum - (near[5] + sign * near[3]);
    let nearest = (-missing / (2.0 * PI)).round();
    let mut best: Option<(f64, [f64; 2])> = None;
    for turns in -2..=2 {
        // Half of what is missing falls to each; then both turn by t, θ6 the other way round.
        let half = 0.5 * missing + (nearest + f64::from(turns)) * PI;
        let (theta4, theta6) = (near[3] + sign * half, near[5] + half);
        let (mut low, mut high) = (min4 - theta4, max4 - theta4);
        let (a, b) = (sign * (theta6 - max6), sign * (theta6 - min6));
        (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
        if low > high {
            continue;
        }
        let t = crate::math::clamp(0.0, low, high);
        let away = half * half + t * t;
        if best.is_none_or(|(least, _)| away < least) {
            best = Some((away, [theta4 + t, theta6 - sign * t]));
        }
    }
    best.map(|(_, angles)| angles)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    /// θ4 in 20,000 steps through its range, and every θ6 that keeps the sum, whatever full turns are between them.
    #[test]
    fn a_singular_wrist_turns_least_among_all_angles() {
        let mut random = Stream::new(5, 0);
        let mut counts = [0; 2];
        for round in 0..200 {
            let sign = if round % 2 == 0 { 1.0 } else { -1.0 };
            let ranges = [0, 1].map(|_| {
                let low = random.between(-6.0, 2.0);
                [low, low + random.between(0.2, 8.0)]
            });
            let near: Posture = std::array::from_fn(|_| random.between(-6.0, 6.0));
            let sum = random.between(-9.0, 9.0);
            let [[min4, max4], [min6, max6]] = ranges;
            let away = |theta4: f64, theta6: f64| {
                let [a, b] = [theta4 - near[3], theta6 - near[5]];
                (a * a + b * b).sqrt()
            };
            let mut least = f64::INFINITY;
            for k in 0..=20_000 {
                let theta4 = min4 + (max4 - min4) * f64::from(k) / 20_000.0;
                for turns in -6..=6 {
                    let theta6 = sum - sign * theta4 + 2.0 * PI * f64::from(turns);
                    if (min6..=max6).contains(&theta6) {
                        least = least.min(away(theta4, theta6));
                    }
                }
            }
            let found = share(sum, sign, &near, ranges);
            counts[usize::from(found.is_some())] += 1;
            let Some([theta4, theta6]) = found else {
                assert!(least.is_infinite(), "round {round}: {least}");
                continue;
            };
            let within = |theta: f64, min: f64, max: f64| theta > min - 1e-12 && theta < max + 1e-12;
            assert!(within(theta4, min4, max4) && within(theta6, min6, max6), "round {round}");
            let turns = (theta6 + sign * theta4 - sum) / (2.0 * PI);
            assert!((turns - turns.round()).abs() < 1e-12, "round {round}");
            assert!(away(theta4, theta6) < least + 1e-3 && away(theta4, theta6) > least - 1e-3, "round {round}: {least}");
        }
        assert!(counts.iter().all(|&count| count > 10), "{counts:?}: both answers are tested");
    }
}
