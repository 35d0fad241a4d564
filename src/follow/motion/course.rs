//! The tip's path as a row of points: its ends, its corners, and more in between.

/// A point of the path that the arm takes a posture at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station {
    pub(super) at: [f64; 3],
    /// How far along the path.
    pub(super) along: f64,
}

/// The most points that are put between corners.
const MOST: f64 = 20_000.0;

/// The path's ends and corners, and points between them at most `spacing` apart (or a 20,000th of the path, if that is more).
pub(super) fn stations(path: &[[f64; 3]], spacing: f64) -> Vec<Station> {
    let spacing = spacing.max(crate::geometry::length_in_space(path) / MOST);
    let mut stations: Vec<_> = path.first().map(|&at| Station { at, along: 0.0 }).into_iter().collect();
    for leg in path.windows(2) {
        let (from, to) = (leg[0], leg[1]);
        let (length, begun) = (distance(from, to), stations.last().map_or(0.0, |last| last.along));
        // A corner that stands twice is one.
        if length == 0.0 {
            continue;
        }
        let pieces = (length / spacing - 1e-9).ceil().max(1.0);
        for i in 1..pieces as usize {
            let share = i as f64 / pieces;
            stations.push(Station { at: between(from, to, share), along: begun + share * length });
        }
        stations.push(Station { at: to, along: begun + length });
    }
    stations
}

/// The stations at which a way is looked for first: both ends, and in between as many as fit, about `apart` from each other.
pub(super) fn keys(stations: &[Station], apart: f64) -> Vec<usize> {
    let Some(last) = stations.last() else {
        return Vec::new();
    };
    let pieces = (last.along / apart).ceil().max(1.0);
    let mut keys = vec![0];
    for (i, station) in stations.iter().enumerate() {
        let next = keys.len() as f64 * last.along / pieces;
        if i > 0 && (station.along >= next - 1e-9 || i + 1 == stations.len()) {
            keys.push(i);
        }
    }
    keys
}

pub(super) fn between<const N: usize>(from: [f64; N], to: [f64; N], share: f64) -> [f64; N] {
    std::array::from_fn(|i| from[i] + share * (to[i] - from[i]))
}

pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [x, y, z] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    (x * x + y * y + z * z).sqrt()
}

/// The distance of a point from a straight piece of the path.
pub(super) fn aside(point: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let minus = |u: [f64; 3], v: [f64; 3]| [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
    let (way, there) = (minus(to, from), minus(point, from));
    let long = dot(way, way);
    let share = if long > 0.0 { crate::math::clamp(dot(there, way) / long, 0.0, 1.0) } else { 0.0 };
    distance(point, between(from, to, share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_has_its_corners_and_no_gap_wider_than_the_spacing() {
        let path = [[0.0; 3], [0.0, 0.0, 0.25], [0.0, 0.0, 0.25], [0.3, 0.0, 0.25], [0.3, 0.001, 0.25]];
        let found = stations(&path, 0.1);
        let along: Vec<_> = found.iter().map(|station| (station.along * 1e6).round() / 1e6).collect();
        assert_eq!(along, [0.0, 0.083_333, 0.166_667, 0.25, 0.35, 0.45, 0.55, 0.551]);
        assert!(path.iter().all(|corner| found.iter().any(|station| station.at == *corner)));
        assert!(found.windows(2).all(|w| (distance(w[0].at, w[1].at) - (w[1].along - w[0].along)).abs() < 1e-12));
        assert_eq!(keys(&found, 0.2), [0, 3, 5, 7]);
        assert_eq!((stations(&[], 0.1).len(), stations(&path[..1], 0.1).len(), keys(&[], 0.1).len()), (0, 1, 0));
        assert!(stations(&[[0.0; 3], [1000.0, 0.0, 0.0]], 1e-4).len() <= 20_001);
    }

    #[test]
    fn a_point_beside_a_piece_and_beyond_its_end() {
        assert!((aside([0.5, 3.0, 4.0], [0.0; 3], [1.0, 0.0, 0.0]) - 5.0).abs() < 1e-15);
        assert!((aside([4.0, 3.0, 0.0], [0.0; 3], [0.0; 3]) - 5.0).abs() < 1e-15);
        assert!((aside([4.0, 4.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0]) - 5.0).abs() < 1e-15);
    }
}
