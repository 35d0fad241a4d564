//! The shortest tour, by Held and Karp's dynamic programme over sets of stops. Independent of the planners that search tours,
//! since they are measured against it.

use crate::{exact::Distances, kernel::TourEnds};

/// The largest number of stops of a tour whose optimum is computed.
pub const MAX_EXACT_STOPS: usize = 15;

/// The visiting order of a shortest tour, and its length; `None` for more than [`MAX_EXACT_STOPS`] stops or fewer than two.
pub fn shortest_tour(distances: &Distances, ends: TourEnds) -> Option<(Vec<usize>, f64)> {
    let n = distances.len();
    if !(2..=MAX_EXACT_STOPS).contains(&n) {
        return None;
    }
    let d = |i: usize, j: usize| distances.counted(i, j);
    // best[set · n + last]: the shortest way that begins as it must, calls at the stops of the set and ends at `last`.
    let mut best = vec![f64::INFINITY; n << n];
    for first in 0..n {
        if first == 0 || ends == TourEnds::Open {
            best[(1 << first) * n + first] = 0.0;
        }
    }
    for set in 1_usize..1 << n {
        for last in (0..n).filter(|last| set >> last & 1 != 0) {
            let so_far = best[set * n + last];
            for next in (0..n).filter(|next| set >> next & 1 == 0 && so_far.is_finite()) {
                let entry = &mut best[(set | 1 << next) * n + next];
                *entry = entry.min(so_far + d(last, next));
            }
        }
    }
    let all = (1 << n) - 1;
    let back = |last: usize| if ends.closes() { d(last, 0) } else { 0.0 };
    let may_end = |last: &usize| ends != TourEnds::FirstToLast || *last == n - 1;
    let mut last = (0..n).filter(may_end).min_by(|&a, &b| (best[all * n + a] + back(a)).total_cmp(&(best[all * n + b] + back(b))))?;
    let (mut set, mut order) = (all, vec![last]);
    while order.len() < n {
        let before = set & !(1 << last);
        let from = |stop: usize| best[before * n + stop] + d(stop, last);
        last = (0..n).filter(|stop| before >> stop & 1 != 0).min_by(|&a, &b| from(a).total_cmp(&from(b)))?;
        (set, order) = (before, {
            order.push(last);
            order
        });
    }
    order.reverse();
    if !distances.has_fixed(&order, ends.closes()) {
        return None;
    }
    let length = distances.length(&order, ends.closes());
    Some((order, length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    /// Every order there is, one after another.
    fn by_trying(distances: &Distances, ends: TourEnds) -> f64 {
        fn go(order: &mut Vec<usize>, k: usize, distances: &Distances, ends: TourEnds, best: &mut f64) {
            if k == order.len() {
                if ends.allows(order, order.len()) {
                    *best = best.min(distances.length(order, ends.closes()));
                }
                return;
            }
            for i in k..order.len() {
                order.swap(k, i);
                go(order, k + 1, distances, ends, best);
                order.swap(k, i);
            }
        }
        let mut best = f64::INFINITY;
        go(&mut (0..distances.len()).collect(), 0, distances, ends, &mut best);
        best
    }

    #[test]
    fn it_is_as_short_as_the_shortest_of_all_orders() {
        let mut rng = Stream::new(5, 0);
        for n in 2..=8 {
            let distances = Distances::of(n, |_, _| rng.between(1.0, 9.0));
            for ends in TourEnds::ALL {
                let (order, length) = shortest_tour(&distances, ends).unwrap();
                assert!(ends.allows(&order, n));
                assert!((length - by_trying(&distances, ends)).abs() < 1e-12, "{n} stops, {ends:?}");
            }
        }
    }

    #[test]
    fn the_published_scene_has_the_stored_tour() {
        use crate::kernel::ReferenceOptimum;
        let scene = crate::shipped("ant-bat-30").unwrap();
        let cells = scene.exact_tour(ReferenceOptimum::Cells, TourEnds::Closed).unwrap();
        let stored = scene.header().exact.as_ref().unwrap();
        let length = |path: &[&str]| path.iter().fold(stored, |value, name| &value[*name]).as_f64().unwrap();
        assert!((cells.length - length(&["tour", "grid_no_cut", "length"])).abs() < 1e-9);
        assert!((crate::geometry::length(&cells.path) - cells.length).abs() < 1e-9);
    }
}
