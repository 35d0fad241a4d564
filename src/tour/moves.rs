//! Changes of a tour, and what each costs before it is made. Rows have their head at 0 and their tail at m + 1; the stops
//! that may be moved are at 1 to m.

use super::problem::{Problem, Stop, Tour};
use crate::{kernel::rng::Stream, math};

/// What reversing the stops at `i` to `j` adds to the length: a 2-opt move. 1 ≤ i ≤ j ≤ m.
#[inline]
pub fn reversal(problem: &Problem, row: &[Stop], i: usize, j: usize) -> f64 {
    let (a, b, c, d) = (row[i - 1], row[i], row[j], row[j + 1]);
    problem.d(a, c) + problem.d(b, d) - problem.d(a, b) - problem.d(c, d)
}

/// Reverses the stops at `i` to `j`.
pub fn reverse(row: &mut [Stop], i: usize, j: usize) {
    row[i..=j].reverse();
}

/// What moving the stop at `i` to just behind the one at `j` adds to the length. 1 ≤ i ≤ m, 0 ≤ j ≤ m, i ≠ j.
#[inline]
pub fn insertion(problem: &Problem, row: &[Stop], i: usize, j: usize) -> f64 {
    if j + 1 == i {
        return 0.0; // it is there already
    }
    let (a, stop, b) = (row[i - 1], row[i], row[i + 1]);
    let (c, d) = (row[j], row[j + 1]);
    let taken = problem.d(a, b) - problem.d(a, stop) - problem.d(stop, b);
    taken + problem.d(c, stop) + problem.d(stop, d) - problem.d(c, d)
}

/// Exchanges the first `k` stops and the others: three reversals, in little code.
#[inline(never)]
pub fn turn(row: &mut [Stop], k: usize) {
    row[..k].reverse();
    row[k..].reverse();
    row.reverse();
}

/// Moves the stop at `i` to just behind the one at `j`.
pub fn insert(row: &mut [Stop], i: usize, j: usize) {
    if i < j { turn(&mut row[i..=j], 1) } else { turn(&mut row[j + 1..=i], i - j - 1) }
}

/// What exchanging the stretches `i` to `j` and `j` + 1 to `k` adds to the length: a double bridge (Martin et al. 1991),
/// three edges replaced and nothing reversed. 1 ≤ i ≤ j < k ≤ m.
#[inline]
pub fn double_bridge(problem: &Problem, row: &[Stop], [i, j, k]: [usize; 3]) -> f64 {
    let (a, b, c, d, e, f) = (row[i - 1], row[i], row[j], row[j + 1], row[k], row[k + 1]);
    let taken = problem.d(a, b) + problem.d(c, d) + problem.d(e, f);
    problem.d(a, d) + problem.d(e, b) + problem.d(c, f) - taken
}

/// Exchanges the stretches `i` to `j` and `j` + 1 to `k`.
pub fn bridge(row: &mut [Stop], [i, j, k]: [usize; 3]) {
    turn(&mut row[i..=k], j + 1 - i);
}

/// Two places among the `m` that may be moved, the smaller one first; they may be the same. `m` must not be 0.
pub fn two_places(m: usize, rng: &mut Stream) -> (usize, usize) {
    let (a, b) = (1 + rng.below(m), 1 + rng.below(m));
    (a.min(b), a.max(b))
}

/// The same, never one place twice. `m` must be 2 at least.
pub fn two_apart(m: usize, rng: &mut Stream) -> (usize, usize) {
    let (a, b) = (1 + rng.below(m), 1 + rng.below(m - 1));
    let b = if b >= a { b + 1 } else { b };
    (a.min(b), a.max(b))
}

/// Two stretches next to each other, for [`bridge`]. `m` must be 2 at least.
pub fn two_stretches(m: usize, rng: &mut Stream) -> [usize; 3] {
    // Three different gaps among the m + 1 before, between and behind the stops.
    let (first, second) = two_apart(m + 1, rng);
    let third = 1 + rng.below(m - 1);
    let third = if third >= first { third + 1 } else { third };
    let third = if third >= second { third + 1 } else { third };
    let mut gaps = [first, second, third];
    math::sort_indices(&mut gaps);
    [gaps[0], gaps[1] - 1, gaps[2] - 1]
}

/// The same, never where the stop is already. `m` must be 2 at least.
pub fn stop_elsewhere(m: usize, rng: &mut Stream) -> (usize, usize) {
    let i = 1 + rng.below(m);
    let j = rng.below(m - 1);
    (i, if j + 1 >= i { j + 2 } else { j })
}

/// The stops that may be moved, with their places.
pub fn placed(row: &[Stop]) -> impl Iterator<Item = (usize, Stop)> + '_ {
    (1..).zip(row[1..row.len() - 1].iter().copied())
}

/// Partially matched crossover (Goldberg and Lingle 1985): `child`, a copy of one parent, takes over the other's stops at
/// `i` to `j`; what stood there goes where they came from. `places` is scratch space, a place for each stop.
pub fn pmx(child: &mut [Stop], other: &[Stop], (i, j): (usize, usize), places: &mut [u32]) {
    for (place, stop) in placed(child) {
        places[stop as usize] = place as u32;
    }
    for k in i..=j {
        let (wanted, there) = (other[k], child[k]);
        let from = places[wanted as usize] as usize;
        child.swap(k, from);
        places[there as usize] = from as u32;
        places[wanted as usize] = k as u32;
    }
}

/// Order crossover (Davis 1985): `child`, a copy of one parent, keeps its stops at `i` to `j`; the others follow behind
/// them, round the end, in the order in which the other parent has them from there on. `kept` is scratch space, a place
/// for each stop.
pub fn ox(child: &mut [Stop], other: &[Stop], (i, j): (usize, usize), kept: &mut [u32]) {
    let m = child.len() - 2;
    for (place, stop) in placed(child) {
        kept[stop as usize] = u32::from(i <= place && place <= j);
    }
    let next = |place: usize| if place == m { 1 } else { place + 1 };
    let (mut to, mut from) = (next(j), next(j));
    for _ in 0..m {
        let stop = other[from];
        if kept[stop as usize] == 0 {
            child[to] = stop;
            to = next(to);
        }
        from = next(from);
    }
}

/// At how many places two rows differ; of tours that are the same backwards, in the direction that is nearer,
/// [ANTBAT](crate#papers) (12).
pub fn hamming(problem: &Problem, a: &[Stop], b: &[Stop]) -> usize {
    nearer(problem, a, b).0
}

/// The same, and whether that is the other direction of `b`.
pub fn nearer(problem: &Problem, a: &[Stop], b: &[Stop]) -> (usize, bool) {
    let m = a.len() - 2;
    let (a, b) = (&a[1..=m], &b[1..=m]);
    let forward = a.iter().zip(b).filter(|(a, b)| a != b).count();
    if !problem.two_way() {
        return (forward, false);
    }
    let backward = a.iter().zip(b.iter().rev()).filter(|(a, b)| a != b).count();
    (forward.min(backward), backward < forward)
}

/// Puts the stops that may be moved into random order.
pub fn shuffle(row: &mut [Stop], rng: &mut Stream) {
    let last = row.len() - 1;
    rng.shuffle(row.get_mut(1..last).unwrap_or_default());
}

/// A tour in random order.
pub fn random_tour(problem: &Problem, rng: &mut Stream) -> Tour {
    let mut tour = Tour::first(problem);
    shuffle(&mut tour.row, rng);
    tour.settle(problem);
    tour
}

/// The shortest of some tours, the first of equals.
pub fn shortest<'a>(mut tours: impl Iterator<Item = &'a Tour>) -> Option<&'a Tour> {
    let first = tours.next()?;
    Some(tours.fold(first, |best, tour| if tour.length < best.length { tour } else { best }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{exact::Distances, kernel::TourEnds};

    fn problem(n: usize, round: TourEnds, rng: &mut Stream) -> Problem {
        Problem::new(&Distances::of(n, |_, _| rng.between(1.0, 9.0)), round)
    }

    /// Goldberg and Lingle's own example: 9 8 4 | 5 6 7 | 1 3 2 10 and 8 7 1 | 2 3 10 | 9 5 4 6.
    #[test]
    fn pmx_against_the_example_that_it_was_published_with() {
        let a = [0, 9, 8, 4, 5, 6, 7, 1, 3, 2, 10, 0];
        let b = [0, 8, 7, 1, 2, 3, 10, 9, 5, 4, 6, 0];
        let mut child = a;
        pmx(&mut child, &b, (4, 6), &mut [0; 11]);
        assert_eq!(child, [0, 9, 8, 4, 2, 3, 10, 1, 6, 5, 7, 0]);
        let mut child = b;
        pmx(&mut child, &a, (4, 6), &mut [0; 11]);
        assert_eq!(child, [0, 8, 10, 1, 5, 6, 7, 9, 2, 4, 3, 0]);
    }

    /// Michalewicz's example (1992): 1 2 3 | 4 5 6 7 | 8 9 and 4 5 2 | 1 8 7 6 | 9 3.
    #[test]
    fn order_crossover_against_an_example_from_a_book() {
        let a = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0];
        let b = [0, 4, 5, 2, 1, 8, 7, 6, 9, 3, 0];
        let mut child = a;
        ox(&mut child, &b, (4, 7), &mut [0; 10]);
        assert_eq!(child, [0, 2, 1, 8, 4, 5, 6, 7, 9, 3, 0]);
        let mut child = b;
        ox(&mut child, &a, (4, 7), &mut [0; 10]);
        assert_eq!(child, [0, 3, 4, 5, 1, 8, 7, 6, 9, 2, 0]);
        let mut child = b;
        ox(&mut child, &a, (1, 9), &mut [0; 10]);
        assert_eq!(child, b, "a stretch of all leaves nothing to take over");
    }

    #[test]
    fn a_double_bridge_against_a_hand_worked_example() {
        let mut row = [0, 1, 2, 3, 4, 5, 6, 7, 0];
        bridge(&mut row, [2, 3, 6]); // 1 | 2 3 | 4 5 6 | 7
        assert_eq!(row, [0, 1, 4, 5, 6, 2, 3, 7, 0]);
    }

    #[test]
    fn insertion_reversal_and_distance_against_hand_worked_examples() {
        let mut row = [0, 1, 2, 3, 4, 5, 0];
        insert(&mut row, 2, 4); // the stop 2 behind the stop 4
        assert_eq!(row, [0, 1, 3, 4, 2, 5, 0]);
        insert(&mut row, 4, 0); // the stop 2 to the front
        assert_eq!(row, [0, 2, 1, 3, 4, 5, 0]);
        reverse(&mut row, 2, 4);
        assert_eq!(row, [0, 2, 4, 3, 1, 5, 0]);
        let mut rng = Stream::new(1, 0);
        let closed = problem(6, TourEnds::Closed, &mut rng);
        assert_eq!(hamming(&closed, &row, &[0, 1, 2, 3, 4, 5, 0]), 3, "3 and 5 stand where they stood");
        assert_eq!(hamming(&closed, &row, &[0, 5, 1, 3, 2, 4, 0]), 2, "backwards it is nearer");
        let open = problem(7, TourEnds::FromFirst, &mut rng);
        assert_eq!(hamming(&open, &row, &[0, 5, 1, 3, 2, 4, 7]), 4);
    }

    #[test]
    fn every_change_keeps_a_permutation_and_costs_what_adding_up_anew_says() {
        let mut rng = Stream::new(7, 0);
        for case in 0..2000 {
            let n = 4 + rng.below(12);
            let problem = problem(n, TourEnds::ALL[case % 4], &mut rng);
            let mut tour = Tour::first(&problem);
            let m = tour.len();
            shuffle(&mut tour.row, &mut rng);
            let mut other = tour.row.clone();
            shuffle(&mut other, &mut rng);
            let before = problem.length(&tour.row);
            let (i, j) = two_places(m, &mut rng);
            let mut row = tour.row.clone();
            let added = reversal(&problem, &row, i, j);
            reverse(&mut row, i, j);
            assert!((problem.length(&row) - before - added).abs() < 1e-12);
            check(&problem, &row);
            let (i, j) = stop_elsewhere(m, &mut rng);
            let mut row = tour.row.clone();
            let added = insertion(&problem, &row, i, j);
            insert(&mut row, i, j);
            assert!((problem.length(&row) - before - added).abs() < 1e-12);
            check(&problem, &row);
            let mut row = tour.row.clone();
            let cut = two_places(m, &mut rng);
            pmx(&mut row, &other, cut, &mut vec![0; n]);
            check(&problem, &row);
            assert_eq!(row[cut.0..=cut.1], other[cut.0..=cut.1]);
            let mut row = tour.row.clone();
            ox(&mut row, &other, cut, &mut vec![0; n]);
            check(&problem, &row);
            assert_eq!(row[cut.0..=cut.1], tour.row[cut.0..=cut.1]);
            if m > 1 {
                let stretches = two_stretches(m, &mut rng);
                let mut row = tour.row.clone();
                let added = double_bridge(&problem, &row, stretches);
                bridge(&mut row, stretches);
                assert!((problem.length(&row) - before - added).abs() < 1e-12);
                check(&problem, &row);
                let (i, j) = two_apart(m, &mut rng);
                assert!(1 <= i && i < j && j <= m);
                let (i, j) = stop_elsewhere(m, &mut rng);
                assert!(1 <= i && i <= m && j <= m && i != j && i != j + 1);
            }
        }
    }

    fn check(problem: &Problem, row: &[Stop]) {
        let tour = Tour { row: row.to_vec(), length: 0.0 };
        assert!(problem.round.allows(&tour.order(problem), problem.n));
        assert_eq!((row[0], row[row.len() - 1]), (problem.head(), problem.tail()));
    }
}
