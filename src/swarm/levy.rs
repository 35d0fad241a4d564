//! Steps of Lévy flights, by Mantegna's algorithm (1994).

use std::f64::consts::PI;

use crate::{kernel::rng::Stream, math};

/// Mantegna's algorithm: numbers s = u / |v|^(1/λ) whose tails fall like a Lévy distribution's, |s|^(−1−λ).
#[derive(Debug, Clone, Copy)]
pub(super) struct Levy {
    /// 1/λ.
    root: f64,
    /// The standard deviation σ of u; that of v is 1.
    pub(super) sigma: f64,
}

/// What is drawn for one step of a Lévy flight.
#[derive(Debug, Clone, Copy)]
pub(super) struct Draw {
    pub(super) u: f64,
    pub(super) v: f64,
    pub(super) s: f64,
}

impl Levy {
    /// σ = (Γ(1 + λ) sin(πλ/2) / (Γ((1 + λ)/2) λ 2^((λ−1)/2)))^(1/λ).
    pub(super) fn new(lambda: f64) -> Self {
        let above = math::gamma(1.0 + lambda) * math::sin(PI * lambda / 2.0);
        let below = math::gamma(f64::midpoint(1.0, lambda)) * lambda * math::pow(2.0, (lambda - 1.0) / 2.0);
        Self { root: 1.0 / lambda, sigma: math::pow(above / below, 1.0 / lambda) }
    }

    #[inline]
    pub(super) fn draw(self, rng: &mut Stream) -> Draw {
        let (u, v) = (self.sigma * rng.normal(), rng.normal());
        Draw { u, v, s: self.step(u, v) }
    }

    #[inline]
    pub(super) fn step(self, u: f64, v: f64) -> f64 {
        // A v of 0 would lead beyond all numbers.
        u / math::pow(v.abs().max(1e-30), self.root)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(value: f64, expected: f64) {
        assert!((value - expected).abs() < 1e-14 * (1.0 + expected.abs()), "{value} is not {expected}");
    }

    /// By hand: Γ(2.5) = 1.329340388179137, sin 135° = 0.7071067811865476, Γ(1.25) = 0.9064024770554771 and 2^0.25 =
    /// 1.189207115002721, so σ = (0.9399856029866254 / 1.6168504121556964)^(2/3). For λ = 1 all factors are 1.
    #[test]
    fn the_deviation_of_u_is_mantegna_s() {
        close(Levy::new(1.5).sigma, 0.696_574_502_557_696_7);
        close(Levy::new(1.0).sigma, 1.0);
    }

    /// By hand: 1.5^(2/3) = 1.3103706971044482, and 0.25^(2/3) = 0.3968502629920499.
    #[test]
    fn a_levy_step_is_u_over_a_root_of_v() {
        let levy = Levy::new(1.5);
        close(levy.step(2.0, -1.5), 2.0 / 1.310_370_697_104_448_2);
        close(levy.step(-0.5, 0.25), -0.5 / 0.396_850_262_992_049_9);
        close(Levy::new(1.0).step(3.0, -4.0), 0.75);
        assert!(levy.step(1.0, 0.0).is_finite() && Levy::new(0.3).step(1.0, 0.0).is_finite());
    }

    /// Four times as far is 4^1.5 = 8 times as rare.
    #[test]
    fn long_steps_become_rare_by_the_exponent() {
        let (levy, mut rng) = (Levy::new(1.5), Stream::new(1, 0));
        let (mut far, mut farther) = (0, 0);
        for _ in 0..400_000 {
            let s = levy.draw(&mut rng).s.abs();
            far += u32::from(s > 10.0);
            farther += u32::from(s > 40.0);
        }
        let ratio = f64::from(far) / f64::from(farther);
        assert!(farther > 300 && (7.0..9.2).contains(&ratio), "{far} / {farther} = {ratio}");
    }
}
