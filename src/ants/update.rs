//! What each ant of an iteration lays on its way.

use super::walk::{Ant, End, Walks};

/// Δτ: how much pheromone an ant that arrived lays on each step of its path, once all have walked.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Update {
    /// Δτ = Q / L.
    Traditional,
    /// [ANTBAT](crate#papers) (5): a reward for less than the median, a punishment for more.
    Reward {
        /// φ1.
        phi1: f64,
        /// φ2.
        phi2: f64,
    },
    /// [WOLF-ANT](crate#papers) (10)–(12): the iteration's best way gets twice as much, its worst way nothing.
    Wolf,
    /// An own one. It may be negative; what is no finite number is 0.
    Own(fn(&Arrival) -> f64),
}

/// An ant that arrived, and what its path compares with. Lengths are in the scene's unit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Arrival {
    /// Q: the setting `q`.
    pub q: f64,
    /// L: the length of its path.
    pub length: f64,
    /// The shortest length so far.
    pub global: f64,
    /// The shortest, the median and the longest length of its iteration.
    pub iteration: [f64; 3],
}

/// Puts Δτ^k into every ant that arrived. `global` is the shortest length so far; `scratch` is only here to be re-used.
pub(super) fn lay(update: Update, q: f64, global: f64, walks: &mut Walks, scratch: &mut Vec<f64>) {
    match update {
        Update::Traditional => each(walks, |ant| q / ant.length),
        Update::Reward { phi1, phi2 } => {
            let median = median(arrived(walks, scratch));
            each(walks, |ant| q / ant.length + phi1 * (median - ant.length) / median + phi2 * (global - ant.length) / global);
        }
        // Each of the δ ants on the best way lays Q / L_best once more, which makes δ Q / L_best; the worst likewise.
        Update::Wolf => {
            let Some((best, worst)) = extremes(walks) else {
                return;
            };
            let [best, worst] = [best, worst].map(|i| walks.ants[i].way);
            each(walks, |ant| {
                let share = q / ant.length;
                share + if ant.way == best { share } else { 0.0 } - if ant.way == worst { share } else { 0.0 }
            });
        }
        Update::Own(own) => {
            let lengths = arrived(walks, scratch);
            let median = median(lengths);
            let Some((&shortest, &longest)) = lengths.first().zip(lengths.last()) else {
                return;
            };
            each(walks, |ant| {
                let laid = own(&Arrival { q, length: ant.length, global, iteration: [shortest, median, longest] });
                if laid.is_finite() { laid } else { 0.0 }
            });
        }
    }
}

/// The lengths of all that arrived.
fn arrived<'a>(walks: &Walks, lengths: &'a mut Vec<f64>) -> &'a mut [f64] {
    lengths.clear();
    lengths.extend(walks.arrived().map(|ant| ant.length));
    lengths
}

fn each(walks: &mut Walks, laid: impl Fn(&Ant) -> f64) {
    for ant in walks.ants.iter_mut().filter(|ant| ant.end == End::Arrived) {
        ant.laid = laid(ant);
    }
}

/// The first ants with the shortest and with the longest way.
fn extremes(walks: &Walks) -> Option<(usize, usize)> {
    let all = || walks.ants.iter().enumerate().filter(|(_, ant)| ant.end == End::Arrived);
    let (mut best, _) = all().next()?;
    let mut worst = best;
    for (i, ant) in all() {
        if ant.length < walks.ants[best].length {
            best = i;
        }
        if ant.length > walks.ants[worst].length {
            worst = i;
        }
    }
    Some((best, worst))
}

/// The middle one; of an even number the mean of the two in the middle.
pub(super) fn median(values: &mut [f64]) -> f64 {
    crate::math::sort_numbers(values);
    match (values.len() / 2, values.len() % 2) {
        (0, 0) => f64::NAN,
        (middle, 1) => values[middle],
        (middle, _) => f64::midpoint(values[middle - 1], values[middle]),
    }
}
