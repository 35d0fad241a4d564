//! Smoothing of polylines, [LTQPSO](crate#papers) §4 (9).

/// The number of pieces into which each segment is cut first. A filter that averages neighbours can only round a corner that
/// has neighbours near it.
pub const PIECES: usize = 8;

/// The path with each segment cut into `pieces` equal ones. A segment that is `free` stays whole if one of its pieces would not
/// be free: on a line that touches an obstacle exactly, a point may be rounded into the obstacle.
pub fn subdivided(path: &[[f64; 2]], pieces: usize, free: impl Fn([f64; 2], [f64; 2]) -> bool) -> Vec<[f64; 2]> {
    let mut cut: Vec<_> = path.first().copied().into_iter().collect();
    for w in path.windows(2) {
        let from = cut.len();
        cut.extend((1..pieces).map(|i| i as f64 / pieces as f64).map(|t| [0, 1].map(|axis| w[0][axis] + t * (w[1][axis] - w[0][axis]))));
        cut.push(w[1]);
        if !cut[from - 1..].windows(2).all(|piece| free(piece[0], piece[1])) && free(w[0], w[1]) {
            cut.truncate(from);
            cut.push(w[1]);
        }
    }
    cut
}

/// Applies the Shuman filter `passes` times: s_i = (1 − S) f_i + S/2 (f_{i−1} + f_{i+1}) with 0 ≤ S ≤ 1. The ends stay.
///
/// `keep` puts a smoothed point back where it may be. A point moves only if both segments that meet there are `free`
/// afterwards. So a path that is free stays free, and one that is not is never made worse where it was free.
pub fn shuman(
    path: &mut [[f64; 2]],
    strength: f64,
    passes: u64,
    keep: impl Fn([f64; 2]) -> [f64; 2],
    free: impl Fn([f64; 2], [f64; 2]) -> bool,
) {
    let mut before = path.to_vec();
    for _ in 0..passes {
        before.copy_from_slice(path);
        for i in 1..path.len().saturating_sub(1) {
            let smoothed =
                [0, 1].map(|axis| (1.0 - strength) * before[i][axis] + strength / 2.0 * (before[i - 1][axis] + before[i + 1][axis]));
            let smoothed = keep(smoothed);
            // The neighbour behind has moved or stayed already, the one ahead has not.
            if free(path[i - 1], smoothed) && free(smoothed, path[i + 1]) {
                path[i] = smoothed;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_filter_averages_neighbours_and_keeps_the_ends() {
        let mut path = [[0.0, 0.0], [1.0, 4.0], [2.0, 0.0], [7.0, 0.0]];
        shuman(&mut path, 0.5, 1, |p| p, |_, _| true);
        // (1 − ½) · 4 + ¼ · (0 + 0); x: ½ · 2 + ¼ · (1 + 7).
        assert_eq!(path, [[0.0, 0.0], [1.0, 2.0], [3.0, 1.0], [7.0, 0.0]]);
        shuman(&mut path, 1.0, 1, |p| p, |_, _| true);
        assert_eq!(path, [[0.0, 0.0], [1.5, 0.5], [4.0, 1.0], [7.0, 0.0]]);
        shuman(&mut path, 0.0, 5, |p| p, |_, _| true);
        assert_eq!(path, [[0.0, 0.0], [1.5, 0.5], [4.0, 1.0], [7.0, 0.0]]);
    }

    #[test]
    fn a_point_that_would_make_a_segment_cross_stays() {
        let start = [[0.0, 0.0], [1.0, 4.0], [2.0, 0.0]];
        // Whatever dips below y = 3 between x = 0.9 and x = 1.1 is not free.
        let free = |a: [f64; 2], b: [f64; 2]| [a, b].iter().all(|p| !(0.9..1.1).contains(&p[0]) || p[1] >= 3.0);
        let mut path = start;
        shuman(&mut path, 1.0, 9, |p| p, free);
        assert_eq!(path, start);
        shuman(&mut path, 0.25, 9, |p| p, free);
        assert_eq!(path, [[0.0, 0.0], [1.0, 3.0], [2.0, 0.0]], "one pass, then it would go too low");
    }

    #[test]
    fn segments_are_cut_into_equal_pieces() {
        let path = [[0.0, 0.0], [4.0, 8.0], [4.0, 9.0]];
        let cut = [[0.0, 0.0], [2.0, 4.0], [4.0, 8.0], [4.0, 8.5], [4.0, 9.0]];
        assert_eq!(subdivided(&path, 2, |_, _| true), cut);
        assert_eq!(subdivided(&path, 2, |_, _| false), cut, "what is not free anyway is cut all the same");
        assert_eq!(subdivided(&path, 2, |_, b| b != [2.0, 4.0]), [[0.0, 0.0], [4.0, 8.0], [4.0, 8.5], [4.0, 9.0]]);
    }
}
