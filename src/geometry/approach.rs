//! Two points moving at constant velocity: when they are closest to each other, and when they first come too near. Exact:
//! nothing is missed between two moments, however fast they are.

/// The time of the closest approach of two points within `seconds` from now, and their distance then. `apart` is the position
/// of the one relative to the other, `closing` its change per second. Of several such moments the first.
pub fn closest_approach(apart: [f64; 2], closing: [f64; 2], seconds: f64) -> (f64, f64) {
    let squared = closing[0] * closing[0] + closing[1] * closing[1];
    let towards = -(apart[0] * closing[0] + apart[1] * closing[1]);
    let time = if towards <= 0.0 { 0.0 } else { (towards / squared).min(seconds) };
    let [x, y] = [apart[0] + time * closing[0], apart[1] + time * closing[1]];
    (time, (x * x + y * y).sqrt())
}

/// The time at which two points first are nearer to each other than `reach`, within `seconds` from now; `None` if they never
/// are. Arguments as in [`closest_approach`]. Points that only touch that distance do not come nearer.
pub fn first_within(apart: [f64; 2], closing: [f64; 2], seconds: f64, reach: f64) -> Option<f64> {
    let beyond = apart[0] * apart[0] + apart[1] * apart[1] - reach * reach;
    if beyond < 0.0 {
        return (reach > 0.0).then_some(0.0);
    }
    let towards = -(apart[0] * closing[0] + apart[1] * closing[1]);
    if towards <= 0.0 || reach <= 0.0 {
        return None;
    }
    // The smaller root of |closing|² t² − 2 towards t + beyond = 0, without cancellation.
    let squared = closing[0] * closing[0] + closing[1] * closing[1];
    let root = towards * towards - squared * beyond;
    if root <= 0.0 {
        return None;
    }
    Some(beyond / (towards + root.sqrt())).filter(|&time| time < seconds)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    #[test]
    fn the_closest_approach_is_where_the_motion_is_square_to_the_line_between() {
        // From (6, 8) by (−1, −0.5) a second: (6 + 4) / 1.25 = 8 s, at (−2, 4).
        assert_eq!(closest_approach([6.0, 8.0], [-1.0, -0.5], 100.0), (8.0, 20.0_f64.sqrt()));
        assert_eq!(closest_approach([6.0, 8.0], [-1.0, -0.5], 2.0), (2.0, (16.0_f64 + 49.0).sqrt()), "not so soon");
        assert_eq!(closest_approach([3.0, 4.0], [1.0, 0.0], 9.0), (0.0, 5.0), "going apart");
        assert_eq!(closest_approach([3.0, 4.0], [0.0, 0.0], 9.0), (0.0, 5.0), "side by side");
        assert_eq!(closest_approach([10.0, 0.0], [-4.0, 0.0], 9.0), (2.5, 0.0), "head on");
    }

    #[test]
    fn the_first_contact_is_the_smaller_root() {
        assert_eq!(first_within([10.0, 0.0], [-4.0, 0.0], 9.0, 2.0), Some(2.0), "head on");
        assert_eq!(first_within([10.0, 0.0], [-4.0, 0.0], 1.9, 2.0), None, "not so soon");
        // 3 beside the line of motion, 5 apart at contact: 4 before the nearest point.
        assert_eq!(first_within([14.0, 3.0], [-2.0, 0.0], 9.0, 5.0), Some(5.0));
        assert_eq!(first_within([14.0, 5.0], [-2.0, 0.0], 9.0, 5.0), None, "touching is no coming nearer");
        assert_eq!(first_within([3.0, 0.0], [1.0, 0.0], 9.0, 5.0), Some(0.0), "too near already");
        assert_eq!(first_within([5.0, 0.0], [1.0, 0.0], 9.0, 5.0), None, "touching and going apart");
        assert_eq!(first_within([5.0, 0.0], [-1.0, 0.0], 9.0, 5.0), Some(0.0), "touching and coming nearer");
        assert_eq!(first_within([0.0, 0.0], [-1.0, 0.0], 9.0, 0.0), None, "no point is nearer than 0");
    }

    /// At any speed: the first contact is on the rim, nothing before it is inside, and where there is none the closest
    /// approach is outside.
    #[test]
    fn nothing_is_missed_however_fast_it_is() {
        let mut rng = Stream::new(6, 0);
        let mut met = 0;
        for _ in 0..20_000 {
            let fast = crate::math::pow(10.0, rng.between(-3.0, 6.0));
            let apart = [rng.between(-100.0, 100.0), rng.between(-100.0, 100.0)];
            let aim = [rng.between(-20.0, 20.0), rng.between(-20.0, 20.0)];
            let closing = [0, 1].map(|axis| (aim[axis] - apart[axis]) / 100.0 * fast);
            let (seconds, reach) = (rng.between(0.0, 10.0), rng.between(0.1, 20.0));
            let at = |t: f64| [apart[0] + t * closing[0], apart[1] + t * closing[1]];
            let distance = |t: f64| (at(t)[0] * at(t)[0] + at(t)[1] * at(t)[1]).sqrt();
            let (nearest, least) = closest_approach(apart, closing, seconds);
            match first_within(apart, closing, seconds, reach) {
                Some(time) => {
                    met += 1;
                    assert!(least < reach && time <= nearest);
                    let slack = 1e-9 * (1.0 + fast * time);
                    assert!(time == 0.0 || (distance(time) - reach).abs() < slack, "{} {reach}", distance(time));
                    assert!(time == 0.0 || (1..10).all(|k| distance(time * f64::from(k) / 10.0) >= reach - slack));
                }
                None => assert!(least >= reach * (1.0 - 1e-12), "{least} {reach}"),
            }
        }
        assert!((4000..18_000).contains(&met), "{met}");
    }
}
