//! A straight segment and its distance to a point.

/// The parameter of the point on the segment `a`–`b` closest to `c`: 0 at `a`, 1 at `b`. A segment of no length gives 0.
#[inline]
pub fn closest_parameter(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let along = (c[0] - a[0]) * dx + (c[1] - a[1]) * dy;
    let squared = dx * dx + dy * dy;
    if squared > 0.0 { (along / squared).clamp(0.0, 1.0) } else { 0.0 }
}

/// The squared distance of the point `c` from the segment `a`–`b`, exact up to rounding: no sampling.
#[inline]
pub fn distance_squared(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let t = closest_parameter(a, b, c);
    let (x, y) = (a[0] + t * (b[0] - a[0]) - c[0], a[1] + t * (b[1] - a[1]) - c[1]);
    x * x + y * y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_is_to_the_foot_or_the_nearer_end() {
        let (a, b) = ([0.0, 0.0], [4.0, 0.0]);
        assert_eq!(distance_squared(a, b, [1.0, 3.0]), 9.0);
        assert_eq!(distance_squared(a, b, [-3.0, 4.0]), 25.0);
        assert_eq!(distance_squared(a, b, [7.0, 4.0]), 25.0);
        assert_eq!(distance_squared(a, a, [3.0, 4.0]), 25.0, "a segment of no length is a point");
    }
}
