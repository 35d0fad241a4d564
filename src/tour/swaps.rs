//! Swap sequences: the difference of two orders, and what is added to an order (Wang et al. 2003; Clerc 2004).
//!
//! A swap exchanges the stops at two places. A list of swaps, carried out one after another, leads from one order to
//! another; it is what a velocity is to a position.

use super::{moves, problem::Stop};
use crate::kernel::rng::Stream;

/// The two places whose stops are exchanged.
pub type Swap = [u32; 2];

/// Carries out the swaps in their order: `row` ⊕ swaps.
pub fn apply(row: &mut [Stop], swaps: &[Swap]) {
    for &[i, j] in swaps {
        row.swap(i as usize, j as usize);
    }
}

/// Turns `row` into `to` (read `backwards`, if so) and adds the swaps that do it: `to` ⊖ `row`, the basic swap sequence.
/// From the first place to the last, the stop that belongs there is fetched; so there is never more than one swap for
/// each place but the last. `places` is scratch space, a place for each stop.
pub fn difference(row: &mut [Stop], to: &[Stop], backwards: bool, places: &mut [u32], swaps: &mut Vec<Swap>) {
    let m = row.len() - 2;
    for (place, stop) in moves::placed(row) {
        places[stop as usize] = place as u32;
    }
    for k in 1..=m {
        let wanted = if backwards { to[m + 1 - k] } else { to[k] };
        let there = row[k];
        if wanted != there {
            let from = places[wanted as usize];
            swaps.push([k as u32, from]);
            row.swap(k, from as usize);
            places[there as usize] = from;
        }
    }
}

/// A number times swaps: each of those from `first` on stays with the probability `share`.
pub fn thin(swaps: &mut Vec<Swap>, first: usize, share: f64, rng: &mut Stream) {
    let mut kept = first;
    for k in first..swaps.len() {
        if rng.unit() < share {
            swaps[kept] = swaps[k];
            kept += 1;
        }
    }
    swaps.truncate(kept);
}

/// The swaps that do to a reversed row of `m` stops what these do to the row.
pub fn mirror(swaps: &mut [Swap], m: usize) {
    for swap in swaps {
        *swap = swap.map(|place| m as u32 + 1 - place);
    }
}

#[cfg(test)]
mod tests {
    use super::{super::moves::shuffle, *};

    /// The example of Wang et al.: A = (1 2 3 4 5), B = (2 3 1 5 4), A ⊖ B = SO(1, 3), SO(2, 3), SO(4, 5).
    #[test]
    fn a_difference_against_the_example_that_it_was_published_with() {
        let a = [0, 1, 2, 3, 4, 5, 0];
        let b = [0, 2, 3, 1, 5, 4, 0];
        let mut swaps = Vec::new();
        difference(&mut b.clone(), &a, false, &mut [0; 6], &mut swaps);
        assert_eq!(swaps, [[1, 3], [2, 3], [4, 5]]);
        let mut row = b;
        apply(&mut row, &swaps);
        assert_eq!(row, a);
    }

    #[test]
    fn swaps_against_hand_worked_examples() {
        // 1 2 3 4 5: the ends, then the middle with what is now the first.
        let mut row = [0, 1, 2, 3, 4, 5, 0];
        apply(&mut row, &[[1, 5], [3, 1]]);
        assert_eq!(row, [0, 3, 2, 5, 4, 1, 0]);
        // The same in a mirror.
        let mut swaps = [[1, 5], [3, 1]];
        mirror(&mut swaps, 5);
        assert_eq!(swaps, [[5, 1], [3, 5]]);
        let mut turned = [0, 5, 4, 3, 2, 1, 0];
        apply(&mut turned, &swaps);
        assert_eq!(turned, [0, 1, 4, 5, 2, 3, 0]);
        // 5 4 3 2 1, read backwards, is there already.
        let mut swaps = Vec::new();
        difference(&mut [0, 1, 2, 3, 4, 5, 0], &[0, 5, 4, 3, 2, 1, 0], true, &mut [0; 6], &mut swaps);
        assert!(swaps.is_empty());
    }

    #[test]
    fn a_difference_leads_from_any_order_to_any_other_and_a_part_of_it_keeps_a_permutation() {
        let mut rng = Stream::new(3, 0);
        for case in 0..2000 {
            let m = rng.below(20);
            let mut from: Vec<Stop> = (0..m as Stop + 2).collect();
            shuffle(&mut from, &mut rng);
            let mut to = from.clone();
            shuffle(&mut to, &mut rng);
            let (mut swaps, mut there, backwards) = (Vec::new(), from.clone(), case % 2 == 0);
            difference(&mut there, &to, backwards, &mut vec![0; m + 2], &mut swaps);
            let mut expected = to.clone();
            if backwards {
                expected[1..=m].reverse();
            }
            assert_eq!(there, expected);
            assert!(swaps.len() < m.max(1));
            let mut again = from.clone();
            apply(&mut again, &swaps);
            assert_eq!(again, expected);
            let half = swaps.len() / 2;
            thin(&mut swaps, half, 0.5, &mut rng);
            let mut part = from.clone();
            apply(&mut part, &swaps);
            assert_eq!((part[0], part[m + 1]), (0, m as Stop + 1));
            part.sort_unstable();
            assert!(part.iter().enumerate().all(|(k, &stop)| stop as usize == k));
        }
    }

    #[test]
    fn a_coefficient_of_none_or_all_keeps_none_or_all() {
        let mut rng = Stream::new(3, 0);
        let swaps = vec![[1, 2], [3, 4], [5, 6]];
        for (share, left) in [(0.0, 1), (1.0, 3), (2.0, 3)] {
            let mut some = swaps.clone();
            thin(&mut some, 1, share, &mut rng);
            assert_eq!(some.len(), left);
        }
    }
}
