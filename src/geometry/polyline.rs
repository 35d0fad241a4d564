//! Polylines: paths as their corners.

use std::f64::consts::TAU;

use crate::math;

use super::Disc;

/// The length of a polyline.
pub fn length(path: &[[f64; 2]]) -> f64 {
    path.windows(2)
        .map(|w| ((w[1][0] - w[0][0]) * (w[1][0] - w[0][0]) + (w[1][1] - w[0][1]) * (w[1][1] - w[0][1])).sqrt())
        .fold(0.0, |sum, length| sum + length)
}

/// The length of a polyline in space.
pub fn length_in_space(path: &[[f64; 3]]) -> f64 {
    path.windows(2)
        .map(|w| (0..3).fold(0.0, |sum, i| sum + (w[1][i] - w[0][i]) * (w[1][i] - w[0][i])).sqrt())
        .fold(0.0, |sum, length| sum + length)
}

/// The total turning angle of a polyline, in radians: 0 for a straight line. Segments of no length are skipped.
pub fn turning(path: &[[f64; 2]]) -> f64 {
    // From 0, so that nothing is not −0.
    angles(path).fold(0.0, |sum, angle| sum + angle)
}

/// The number of corners at which a polyline turns; by less than a millionth of a radian is straight on.
pub fn turns(path: &[[f64; 2]]) -> usize {
    angles(path).filter(|&angle| angle > 1e-6).count()
}

/// How much a polyline turns at each corner, in radians, either way.
fn angles(path: &[[f64; 2]]) -> impl Iterator<Item = f64> + '_ {
    let steps = path.windows(2).map(|w| [w[1][0] - w[0][0], w[1][1] - w[0][1]]).filter(|d| *d != [0.0, 0.0]);
    let mut last: Option<[f64; 2]> = None;
    steps.filter_map(move |step| {
        let before = last.replace(step)?;
        let (cross, dot) = (before[0] * step[1] - before[1] * step[0], before[0] * step[0] + before[1] * step[1]);
        Some(math::atan2(cross, dot).abs())
    })
}

/// Appends corners along the disc's rim from angle `from` over `sweep` (radians, positive counter-clockwise): the first and the
/// last on the rim, the others just outside, so that the edges touch the rim and never cut it. A corner for every two degrees.
pub fn arc_outline(disc: &Disc, from: f64, sweep: f64, path: &mut Vec<[f64; 2]>) {
    let pieces = (sweep.abs() / TAU * 180.0).ceil().max(1.0);
    let step = sweep / pieces;
    let at = |angle: f64, radius: f64| [disc.center[0] + radius * math::cos(angle), disc.center[1] + radius * math::sin(angle)];
    path.push(at(from, disc.radius));
    for i in 0..pieces as usize {
        path.push(at(from + (i as f64 + 0.5) * step, disc.radius / math::cos(step / 2.0)));
    }
    path.push(at(from + sweep, disc.radius));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turning_adds_up_the_corners_whichever_way_they_go() {
        use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
        assert_eq!(turning(&[[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]]), 0.0);
        let zigzag = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 2.0], [2.0, 3.0]];
        assert!((turning(&zigzag) - FRAC_PI_2 - FRAC_PI_4).abs() < 1e-15);
        assert_eq!((turns(&zigzag), turns(&zigzag[..2])), (2, 0));
    }

    #[test]
    fn an_outline_never_cuts_its_disc_and_is_hardly_longer_than_the_arc() {
        let disc = Disc { center: [1.0, -2.0], radius: 3.0 };
        let mut path = Vec::new();
        arc_outline(&disc, 0.3, -2.0, &mut path);
        let deepest = path.windows(2).map(|w| disc.clearance_of_segment(w[0], w[1])).fold(f64::INFINITY, f64::min);
        assert!(deepest > -1e-12, "{deepest:e}");
        assert!(length(&path) >= 6.0 && length(&path) < 6.001, "{}", length(&path));
        assert_eq!(length(&[[0.0, 0.0], [3.0, 4.0], [3.0, 5.0]]), 6.0);
    }
}
