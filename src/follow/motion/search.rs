//! The way through layers of postures that is smoothest on the whole, among those whose moves are allowed.
//!
//! Dynamic programming backwards, as if every move were allowed, says what the rest of the way costs at least from each posture.
//! With that as its estimate, a best-first search goes forwards and tests a move only when its turn comes: where nothing is
//! in the way it tests hardly more moves than the way has.

use std::{cmp::Reverse, collections::BinaryHeap};

use crate::arm::{Posture, squared};

/// Postures at a point of the path, any of which will do.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layer {
    /// Which point of the path.
    pub(super) station: usize,
    /// How far along the path it is.
    pub(super) along: f64,
    pub(super) postures: Vec<Posture>,
}

/// What the search knows of a move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Move {
    Allowed,
    /// Only if there is no other way.
    Reluctant,
    Impossible,
}

/// What a reluctant move costs: more than any way.
const RELUCTANT: f64 = 1e9;

/// What a move between neighbouring layers costs: joints that turn far on little way cost the more.
fn cost(a: &Posture, b: &Posture, way: f64) -> f64 {
    squared(a, b) / way
}

/// How far it is from each layer to the next; never 0.
fn ways(layers: &[Layer]) -> Vec<f64> {
    layers.windows(2).map(|pair| (pair[1].along - pair[0].along).max(1e-6)).collect()
}

/// What the rest of the way costs at least, from each posture of each layer.
fn rests(layers: &[Layer], ways: &[f64]) -> Vec<Vec<f64>> {
    let mut rests: Vec<Vec<f64>> = layers.iter().map(|layer| vec![0.0; layer.postures.len()]).collect();
    for k in (0..ways.len()).rev() {
        // In the order of what is left from there, so that most need not be looked at.
        let mut next: Vec<_> = rests[k + 1].iter().copied().zip(0_usize..).collect();
        crate::math::sort(&mut next);
        let (here, there) = (&layers[k].postures, &layers[k + 1].postures);
        for (rest, posture) in rests[k].iter_mut().zip(here) {
            *rest = f64::INFINITY;
            for &(left, j) in &next {
                if left >= *rest {
                    break;
                }
                let whole = left + cost(posture, &there[j], ways[k]);
                *rest = if whole < *rest { whole } else { *rest };
            }
        }
    }
    rests
}

/// A move that waits to be tested: ordered by what the whole way would cost, then by how little is left.
type Waiting = Reverse<(u64, usize, usize, usize, bool)>;

/// The posture of each layer on the cheapest way, as indices. `greed` ≥ 1: how much the rest of the way counts; above 1 the
/// way is found sooner and costs at most that much more. `None` if there is no way, or none within `most` tests of moves.
pub(super) fn cheapest(
    layers: &[Layer],
    greed: f64,
    most: usize,
    mut test: impl FnMut(usize, &Posture, &Posture) -> Move,
) -> Option<Vec<usize>> {
    let ways = ways(layers);
    let rests = rests(layers, &ways);
    let last = layers.len().checked_sub(1)?;
    // What the way to a posture costs, and from where it comes.
    let mut reached: Vec<Vec<Option<usize>>> = layers.iter().map(|layer| vec![None; layer.postures.len()]).collect();
    let mut costs: Vec<Vec<f64>> = layers.iter().map(|layer| vec![f64::INFINITY; layer.postures.len()]).collect();
    let mut open = BinaryHeap::<Waiting>::new();
    // Costs are not negative, and such numbers are ordered as their bits are.
    let wait = |open: &mut BinaryHeap<Waiting>, so_far: f64, k: usize, i: usize, from: usize, tested: bool| {
        let whole = so_far + greed * rests[k][i];
        if whole.is_finite() {
            open.push(Reverse((whole.to_bits(), last - k, i, from, tested)));
        }
    };
    for i in 0..layers[0].postures.len() {
        wait(&mut open, 0.0, 0, i, 0, true);
    }
    let mut tests = 0;
    while let Some(Reverse((_, left, i, from, tested))) = open.pop() {
        let k = last - left;
        if reached[k][i].is_some() {
            continue;
        }
        let posture = &layers[k].postures[i];
        let mut so_far = 0.0;
        if k > 0 {
            let before = &layers[k - 1].postures[from];
            so_far = costs[k - 1][from] + cost(before, posture, ways[k - 1]) + if tested { RELUCTANT } else { 0.0 };
            if !tested {
                tests += 1;
                if tests > most {
                    return None;
                }
                match test(k - 1, before, posture) {
                    Move::Allowed => {}
                    Move::Impossible => continue,
                    Move::Reluctant => {
                        wait(&mut open, so_far + RELUCTANT, k, i, from, true);
                        continue;
                    }
                }
            }
        }
        (reached[k][i], costs[k][i]) = (Some(from), so_far);
        if left == 0 {
            return Some(back(&reached, i));
        }
        for (j, next) in layers[k + 1].postures.iter().enumerate() {
            if reached[k + 1][j].is_none() {
                wait(&mut open, so_far + cost(posture, next, ways[k]), k + 1, j, i, false);
            }
        }
    }
    None
}

fn back(reached: &[Vec<Option<usize>>], end: usize) -> Vec<usize> {
    let mut way = vec![end];
    for layer in reached.get(1..).unwrap_or_default().iter().rev() {
        let here = way[way.len() - 1];
        way.push(layer[here].unwrap_or(0));
    }
    way.reverse();
    way
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    fn layer(k: usize, firsts: &[f64]) -> Layer {
        Layer { station: k, along: k as f64, postures: firsts.iter().map(|&q| [q, 0.0, 0.0, 0.0, 0.0, 0.0]).collect() }
    }

    fn price(layers: &[Layer], way: &[usize]) -> f64 {
        let apart = |k: usize, w: &[usize]| layers[k].postures[w[0]][0] - layers[k + 1].postures[w[1]][0];
        way.windows(2).enumerate().map(|(k, w)| apart(k, w) * apart(k, w)).sum()
    }

    /// 0 → 1 → 2 costs 2; without the move 0 → 1 it is 0 → 3 → 2 with 10, against 5 → 3 → 2 with 5.
    #[test]
    fn the_cheapest_way_is_taken_and_forbidden_moves_are_gone_round() {
        let layers = [layer(0, &[0.0, 5.0]), layer(1, &[1.0, 3.0]), layer(2, &[2.0])];
        assert_eq!(cheapest(&layers, 1.0, 99, |_, _, _| Move::Allowed), Some(vec![0, 0, 0]));
        let without = |verdict: Move| {
            move |k: usize, from: &Posture, to: &Posture| if (k, from[0], to[0]) == (0, 0.0, 1.0) { verdict } else { Move::Allowed }
        };
        assert_eq!(cheapest(&layers, 1.0, 99, without(Move::Impossible)), Some(vec![1, 1, 0]));
        assert_eq!(cheapest(&layers, 1.0, 99, without(Move::Reluctant)), Some(vec![1, 1, 0]), "there is another way");
        assert_eq!(cheapest(&layers, 1.0, 99, |_, _, _| Move::Reluctant), Some(vec![0, 0, 0]), "there is none");
        assert_eq!(cheapest(&layers, 1.0, 99, |_, _, _| Move::Impossible), None);
        assert_eq!(cheapest(&layers, 1.0, 1, without(Move::Impossible)), None, "not within one test");
        assert_eq!(cheapest(&[], 1.0, 99, |_, _, _| Move::Allowed), None);
        assert_eq!(cheapest(&[layer(0, &[]), layer(1, &[1.0])], 1.0, 99, |_, _, _| Move::Allowed), None);
        assert_eq!(cheapest(&layers[2..], 1.0, 99, |_, _, _| Move::Allowed), Some(vec![0]));
    }

    /// Against all ways, tried out one by one; moves are forbidden at random.
    #[test]
    fn no_other_way_is_cheaper() {
        let mut random = Stream::new(5, 0);
        for _ in 0..200 {
            let layers: Vec<_> = (0..5).map(|k| layer(k, &std::array::from_fn::<f64, 4, _>(|_| random.between(-1.0, 1.0)))).collect();
            let forbidden: Vec<[f64; 2]> = (0..20)
                .map(|_| [random.below(4), random.below(4), random.below(4)])
                .map(|[k, i, j]| [layers[k].postures[i][0], layers[k + 1].postures[j][0]])
                .collect();
            let allowed = |from: &Posture, to: &Posture| !forbidden.contains(&[from[0], to[0]]);
            let all = (0..1024_usize).map(|code| (0..5).map(|k| code >> (2 * k) & 3).collect::<Vec<_>>());
            let best = all
                .filter(|way| way.windows(2).enumerate().all(|(k, w)| allowed(&layers[k].postures[w[0]], &layers[k + 1].postures[w[1]])))
                .map(|way| price(&layers, &way))
                .fold(f64::INFINITY, f64::min);
            let found =
                |greed| cheapest(&layers, greed, 1000, |_, from, to| if allowed(from, to) { Move::Allowed } else { Move::Impossible });
            assert_eq!(found(1.0).is_some(), best.is_finite());
            if let (Some(way), Some(hasty)) = (found(1.0), found(4.0)) {
                assert!((price(&layers, &way) - best).abs() < 1e-9 && price(&layers, &hasty) <= 4.0 * best + 1e-9);
            }
        }
    }
}
