//! Removal of redundant nodes from paths, [ANTBAT](crate#papers) §1.3.

/// The path without its redundant nodes. A node is removed if the segment between its neighbours is `free`, from the first node
/// to the last, and again until none is removed. The ends stay. A path that is free stays free, and never becomes longer.
pub fn shortcut(path: &[[f64; 2]], free: impl Fn([f64; 2], [f64; 2]) -> bool) -> Vec<[f64; 2]> {
    let mut path = path.to_vec();
    while pass(&mut path, &free) {}
    path
}

/// Goes over the path once; says whether a node went. (Compiled once for all who ask.)
fn pass(path: &mut Vec<[f64; 2]>, free: &dyn Fn([f64; 2], [f64; 2]) -> bool) -> bool {
    let before = path.len();
    let mut kept = 1;
    for i in 1..before.saturating_sub(1) {
        if !free(path[kept - 1], path[i + 1]) {
            path[kept] = path[i];
            kept += 1;
        }
    }
    if before > 1 {
        path[kept] = path[before - 1];
        path.truncate(kept + 1);
    }
    path.len() < before
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wall from (2, 0) up to (2, 3).
    fn free(a: [f64; 2], b: [f64; 2]) -> bool {
        let crosses = (a[0] - 2.0) * (b[0] - 2.0) < 0.0;
        let at = a[1] + (2.0 - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
        !crosses || at >= 3.0
    }

    #[test]
    fn only_the_nodes_that_keep_neighbours_out_of_sight_stay() {
        let path = [[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [0.0, 3.0], [1.0, 3.0], [2.0, 3.0], [3.0, 2.0], [4.0, 1.0], [4.0, 0.0]];
        assert_eq!(shortcut(&path, free), [[0.0, 0.0], [2.0, 3.0], [4.0, 0.0]]);
        assert_eq!(shortcut(&path, |_, _| true), [[0.0, 0.0], [4.0, 0.0]]);
        assert_eq!(shortcut(&path, |_, _| false), path);
    }

    #[test]
    fn what_a_node_hid_may_be_seen_when_another_has_gone() {
        // Only neighbours at an odd distance of ranks see each other: the first pass takes some, the second the rest.
        let path: Vec<_> = (0..6).map(|i| [f64::from(i), f64::from(i % 2)]).collect();
        let near = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).abs() <= 2.0 || (a[1], b[1]) == (0.0, 0.0);
        let once = {
            let mut once = path.clone();
            pass(&mut once, &near);
            once
        };
        let all = shortcut(&path, near);
        assert!(once.len() < path.len() && all.len() < once.len(), "{once:?} {all:?}");
        assert_eq!((all[0], all[all.len() - 1]), (path[0], path[5]));
        assert!(all.windows(3).all(|w| !near(w[0], w[2])), "nothing is left to go");
    }

    #[test]
    fn a_path_of_two_nodes_or_fewer_stays() {
        for n in 0..3 {
            let path = vec![[1.0, 2.0]; n];
            assert_eq!(shortcut(&path, |_, _| true), path);
        }
    }
}
