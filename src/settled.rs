//! When a group that searches side by side has settled.

use crate::{
    describe::{Group, Reading},
    kernel::State,
};

/// How near to the best the mean must be.
const WITHIN: f64 = 0.01;

/// From which iteration on the mean of a group has stayed within 1 % of the best of the same iteration.
///
/// The iteration in which the final best was found says when one member was lucky. This says when the group agrees, on
/// whatever it agrees: the mean tells how good that is.
#[derive(Debug, Clone, Copy, Default, State)]
pub(crate) struct Settled(Option<u64>);

impl Settled {
    /// Takes note of an iteration; a mean that is NaN (nobody arrived) is not near.
    pub fn note(&mut self, iteration: u64, mean: f64, best: f64) {
        if mean <= best * (1.0 + WITHIN) {
            self.0.get_or_insert(iteration);
        } else {
            self.0 = None;
        }
    }

    /// The iteration; NaN while it is not settled.
    pub fn iteration(self) -> f64 {
        self.0.map_or(f64::NAN, |iteration| iteration as f64)
    }
}

/// What a group tells of it.
pub const SETTLED: Reading = Reading::new(
    "settled",
    "t_s",
    "Settled",
    Group::Count,
    "The iteration since which the mean has stayed within 1 % of the best of the same iteration: since then all agree, on something good or not.",
);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_has_settled_since_the_mean_was_last_far() {
        let mut settled = Settled::default();
        let settled: Vec<f64> = [(1.2, 1.0), (1.01, 1.0), (1.0, 1.0), (f64::NAN, 1.0), (1.02, 1.0), (1.005, 1.0), (1.0, 1.0)]
            .into_iter()
            .enumerate()
            .map(|(k, (mean, best))| {
                settled.note(k as u64, mean, best);
                settled.iteration()
            })
            .collect();
        assert_eq!(settled.iter().map(|t| t.is_nan()).collect::<Vec<_>>(), [true, false, false, true, true, false, false]);
        assert_eq!((settled[2], settled[6]), (1.0, 5.0));
    }
}
