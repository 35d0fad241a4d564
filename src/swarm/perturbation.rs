//! Hen and chick: what moves a particle that stagnates, [WCPSO](crate#papers) §2.2.
//!
//! A particle stagnates when its cost rose in `patience` consecutive iterations. The first time the hen equation (9)
//! moves it, and after the hen, as long as nothing has improved, the chick equation (12), each after another `patience`
//! iterations of rising cost. Any improvement makes it an ordinary particle again.
//!
//! What the text leaves open is a parameter: [`Sign`], [`Timing`], [`Keep`], [`Partner`].

use crate::{
    kernel::{State, rng::Stream},
    math,
};

/// The parameters of a perturbation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Perturbation {
    /// How many consecutive iterations of rising cost make a particle stagnate; 3 in the paper.
    pub patience: u8,
    /// F_L in (12); 2 in the paper.
    pub f_l: f64,
    /// The sign in (11).
    pub sign: Sign,
    /// When a stagnating particle jumps.
    pub timing: Timing,
    /// Which jumps of the hen count.
    pub keep: Keep,
    /// What the hen takes from the other particle.
    pub partner: Partner,
}

/// The sign of the exponent in (11).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// exp(f_i − f_t), as printed: the worse particle i itself is, the more it is drawn to the other.
    Printed,
    /// exp(f_t − f_i), as in chicken swarm optimisation, where the equation comes from.
    Source,
}

/// When a stagnating particle jumps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Timing {
    /// In the next iteration, instead of flying.
    Instead,
    /// In the same iteration, after flying.
    After,
}

/// Which jumps of the hen count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Keep {
    /// All of them.
    Always,
    /// Those that lower the cost; the particle stays where it was otherwise.
    Better,
}

/// What the hen takes from the other particle t.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Partner {
    /// Its position x_t, as printed.
    Position,
    /// Its personal best p_t.
    Best,
}

/// What moved a particle in an iteration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, State)]
#[repr(u8)]
pub enum Event {
    /// The velocity, (6) and (7).
    #[default]
    Move,
    /// The hen equation, (9).
    Hen,
    /// The chick equation, (12).
    Chick,
}

/// How long a particle has been getting worse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, State)]
pub struct Patience {
    /// Consecutive iterations in which its cost rose.
    pub worse: u8,
    /// The hen has moved it and nothing has improved since.
    pub after_hen: bool,
}

impl Patience {
    /// Takes note of an iteration's change of cost.
    #[inline]
    pub fn note(&mut self, before: f64, after: f64) {
        if after > before {
            self.worse = self.worse.saturating_add(1);
        } else {
            self.worse = 0;
            self.after_hen &= after >= before;
        }
    }

    /// What is to move the particle next.
    #[inline]
    pub fn next(&mut self, patience: u8) -> Event {
        if self.worse < patience {
            return Event::Move;
        }
        self.worse = 0;
        if std::mem::replace(&mut self.after_hen, true) { Event::Chick } else { Event::Hen }
    }
}

/// s1 = exp((f_i − f_g) / (|f_i| + ε)), [WCPSO](crate#papers) (10); ε is the smallest positive normal number.
pub fn s1(f_i: f64, f_g: f64) -> f64 {
    math::exp((f_i - f_g) / (f_i.abs() + f64::MIN_POSITIVE))
}

/// s2 = exp(f_i − f_t), [WCPSO](crate#papers) (11), or with the sign of its source. Reading: as printed it overflows, so the
/// exponent is capped at 1, the largest that (10) can reach.
pub fn s2(sign: Sign, f_i: f64, f_t: f64) -> f64 {
    let exponent = match sign {
        Sign::Printed => f_i - f_t,
        Sign::Source => f_t - f_i,
    };
    math::exp(exponent.min(1.0))
}

/// One coordinate of the hen equation, x + s1 r (p_g − x) + s2 r' (x_t − x), [WCPSO](crate#papers) (9).
#[inline]
pub fn hen(x: f64, g: f64, x_t: f64, [s1, s2]: [f64; 2], [r, r_]: [f64; 2]) -> f64 {
    x + s1 * r * (g - x) + s2 * r_ * (x_t - x)
}

/// One coordinate of the chick equation, x + F_L (p_g − x), [WCPSO](crate#papers) (12).
#[inline]
pub fn chick(x: f64, g: f64, f_l: f64) -> f64 {
    x + f_l * (g - x)
}

/// A random particle other than `i`; `None` if there is none.
pub fn other(i: usize, size: usize, rng: &mut Stream) -> Option<usize> {
    let others = size.checked_sub(1).filter(|&n| n > 0)?;
    let t = rng.below(others);
    Some(if t >= i { t + 1 } else { t })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn s1_and_s2_agree_with_10_and_11() {
        assert!((s1(4.0, 2.0) - 0.5f64.exp_by_hand()).abs() < 1e-15);
        assert_eq!(s1(0.0, 0.0), 1.0, "ε keeps 0/0 away");
        assert!((s1(5.0, 0.0) - std::f64::consts::E).abs() < 1e-15, "at most e for a best of 0");
        assert!((s2(Sign::Printed, 1.5, 1.0) - 0.5f64.exp_by_hand()).abs() < 1e-15);
        assert!((s2(Sign::Source, 1.0, 1.5) - 0.5f64.exp_by_hand()).abs() < 1e-15);
        assert!((s2(Sign::Printed, 1000.0, 1.0) - std::f64::consts::E).abs() < 1e-15, "capped");
        assert_eq!(s2(Sign::Printed, -1e6, 1e6), 0.0);
        assert_eq!(s2(Sign::Source, 1e6, -1e6), 0.0);
    }

    trait ByHand {
        fn exp_by_hand(self) -> f64;
    }

    impl ByHand for f64 {
        /// The series, to the last digit for small arguments.
        fn exp_by_hand(self) -> f64 {
            (1..25).rev().fold(1.0, |sum, n| 1.0 + sum * self / f64::from(n))
        }
    }

    #[test]
    fn hen_and_chick_agree_with_9_and_12() {
        // 1 + 2 · 0.5 · (4 − 1) + 0.25 · 0.8 · (−4 − 1) = 1 + 3 − 1
        assert!((hen(1.0, 4.0, -4.0, [2.0, 0.25], [0.5, 0.8]) - 3.0).abs() < 1e-15);
        assert_eq!(chick(1.0, 4.0, 2.0), 7.0, "F_L = 2 mirrors at the best");
        assert_eq!(chick(1.0, 4.0, 1.0), 4.0);
    }

    #[test]
    fn first_the_hen_then_chicks_until_something_improves() {
        let mut patience = Patience::default();
        let rise = |times: u8, patience: &mut Patience| {
            (0..times).for_each(|_| patience.note(1.0, 2.0));
            patience.next(3)
        };
        assert_eq!(rise(2, &mut patience), Event::Move);
        assert_eq!(rise(1, &mut patience), Event::Hen);
        assert_eq!(rise(2, &mut patience), Event::Move);
        assert_eq!(rise(1, &mut patience), Event::Chick);
        assert_eq!(rise(3, &mut patience), Event::Chick);
        patience.note(2.0, 2.0);
        assert_eq!(rise(3, &mut patience), Event::Chick, "standing still is no improvement");
        patience.note(2.0, 1.0);
        assert_eq!(rise(3, &mut patience), Event::Hen, "an improvement makes it ordinary again");
        patience.note(1.0, 2.0);
        patience.note(1.0, 2.0);
        patience.note(2.0, 2.0);
        assert_eq!(rise(2, &mut patience), Event::Move, "only consecutive rises count");
    }

    #[test]
    fn the_other_particle_is_another_and_any() {
        let mut rng = Stream::new(1, 0);
        let mut seen = [0; 4];
        (0..400).for_each(|_| seen[other(2, 4, &mut rng).unwrap()] += 1);
        assert!(seen[2] == 0 && [0, 1, 3].iter().all(|&t| seen[t] > 80), "{seen:?}");
        assert_eq!(other(0, 1, &mut rng), None);
    }
}
