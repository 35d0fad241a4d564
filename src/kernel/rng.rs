//! Seeded streams of random numbers, the only source of randomness.
//!
//! A run's seed keys ChaCha8, which seeds independent streams; each stream is a xoshiro256++ generator.
//! (ChaCha itself in the inner loop would cost as much as the rest of a swarm's step; `benches/swarms.rs` shows both.)

use chacha20::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

use crate::{
    kernel::{Digest, Error, Message, State},
    math,
};

/// A stream of random numbers that belongs to one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Stream(Xoshiro256PlusPlus);

impl Stream {
    /// The stream numbered `index` of the run with this `seed`.
    pub fn new(seed: u64, index: u64) -> Self {
        let mut dealer = ChaCha8Rng::seed_from_u64(seed);
        dealer.set_stream(index);
        Self(Xoshiro256PlusPlus::from_rng(&mut dealer))
    }

    /// A uniform number in `[0, 1)`, with 53 random bits.
    #[inline]
    pub fn unit(&mut self) -> f64 {
        self.0.random()
    }

    /// A uniform number in `[low, high)`.
    #[inline]
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A uniform number in `(0, 1]`, so that its logarithm exists.
    #[inline]
    pub fn positive_unit(&mut self) -> f64 {
        1.0 - self.unit()
    }

    /// A number from the standard normal distribution, by Box and Muller's transform.
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (self.positive_unit(), self.unit());
        (-2.0 * math::ln(u)).sqrt() * math::cos_turns(v)
    }

    /// A uniform whole number in `0..n`. `n` must not be 0.
    #[inline]
    pub fn below(&mut self, n: usize) -> usize {
        self.0.random_range(0..n)
    }

    /// Puts the items into random order; all orders are equally probable (Fisher and Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

/// What it will draw next, which is as much as its state has.
impl State for Stream {
    fn digest(&self, out: &mut Digest) {
        let mut ahead = self.0.clone();
        out.stream(std::array::from_fn(|_| ahead.random()));
    }
    fn heap_size(&self) -> usize {
        0
    }
}

/// A fresh seed from the system, for "new seed" only: the number is shown and can be typed in again.
///
/// # Errors
/// When the system gives no randomness.
pub fn fresh_seed() -> Result<u64, Error> {
    getrandom::u32().map(u64::from).map_err(|problem| Error::malformed("seed", Message::verbatim(problem.to_string())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_repeat_and_differ_by_seed_and_index() {
        let draw = |seed, index| {
            let mut stream = Stream::new(seed, index);
            [stream.unit(), stream.unit(), stream.between(-2.0, 3.0)]
        };
        assert_eq!(draw(7, 0), draw(7, 0));
        assert_ne!(draw(7, 0), draw(8, 0));
        assert_ne!(draw(7, 0), draw(7, 1));
    }
}
