//! What the entries of the quantum swarms share.

use crate::{
    describe::{Formula, Group, Reading, Suggestion},
    math,
    params::{Fixed, Param, Parameters},
    scene::{DISCS, FUNCTION, GRID},
    swarm::paths::{Angles, ENCODING, Encoding, INITIAL, SEGMENTS},
};

pub(super) const POPULATION: Param<u64> = Param::integer(
    "population",
    "N",
    "Population",
    [1, 100_000, 60],
    "How many particles. Published: 20 on functions (fig. 1), 30 on the 10 m grid; (10) and (11) suggest a number.",
)
.defaults_on(&[(FUNCTION, Fixed::Number(20.0)), (DISCS, Fixed::Number(150.0)), (GRID, Fixed::Number(30.0))])
.slider(2.0, 2000.0, true);
pub(super) const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "k_{\\max}",
    "Iterations",
    [1, 1_000_000_000, 500],
    "After how many iterations it stops; α falls over them. Published: 100 on functions (fig. 1), 50 on the 10 m grid; (10) and (11) suggest a number.",
)
.defaults_on(&[(FUNCTION, Fixed::Number(100.0)), (GRID, Fixed::Number(50.0))])
.slider(10.0, 5000.0, true);
pub(super) const ALPHA_START: Param<f64> = Param::number(
    "alpha_start",
    "\\alpha_0",
    "Width at the start",
    [0.0, 3.0, 1.0],
    "The contraction–expansion coefficient α falls from here: the wider, the farther the leaps.",
);
pub(super) const ALPHA_END: Param<f64> =
    Param::number("alpha_end", "\\alpha_{\\max}", "Width at the end", [0.0, 3.0, 0.5], "The coefficient α falls to here.");
pub(super) const C1: Param<f64> = Param::number(
    "c1",
    "c_1",
    "Cognitive coefficient",
    [0.001, 5.0, 2.0],
    "Beside c2 the larger, the nearer the attractor to the particle’s own best, (22).",
);
pub(super) const C2: Param<f64> = Param::number(
    "c2",
    "c_2",
    "Social coefficient",
    [0.001, 5.0, 2.1],
    "Beside c1 the larger, the nearer the attractor to the swarm’s best, (22).",
);

pub(super) const ALPHA: Reading =
    Reading::new("alpha", "\\alpha", "Contraction–expansion", Group::Schedule, "α in the step that led here.");
pub(super) const IP: Reading = Reading::new(
    "ip",
    "\\overline{ip}",
    "Evolution speed",
    Group::Schedule,
    "The mean of F(G) / F(P) over the particles, (5): near 1 when all have found as much as the best.",
);
pub(super) const GS: Reading = Reading::new(
    "gs",
    "\\overline{gs}",
    "Dispersion",
    Group::Schedule,
    "The mean of σ(P) / σ(X) over the coordinates, (6): how scattered the personal bests are compared with the positions.",
);
pub(super) const SELECTED: Reading =
    Reading::new("selected", "n_r", "Replaced", Group::Count, "Particles whose position natural selection replaced in this iteration.");

pub(super) const WIDTH: Formula = Formula::new(
    "alpha",
    "[LTQPSO] §2.2, α from 1.0 to 0.5",
    "Contraction–expansion",
    "\\alpha(k) = \\alpha_0 + (\\alpha_{\\max} - \\alpha_0) \\frac{k}{k_{\\max}}",
    "\\alpha(@k@) = @alpha_start@ + (@alpha_end@ - @alpha_start@) \\cdot \\frac{@k@}{@iterations@} = @alpha@",
);
pub(super) const PHI: Formula = Formula::of_item(
    "phi",
    "[LTQPSO] (22)",
    "Share of the own best",
    "\\varphi = \\frac{c_1 r_1}{c_1 r_1 + c_2 r_2}",
    "\\varphi = \\frac{@c1@ \\cdot @r1@}{@c1@ \\cdot @r1@ + @c2@ \\cdot @r2@} = @phi@",
);
pub(super) const MEAN: Formula = Formula::of_item("mean", "[LTQPSO] (3, 8)", "Mean best", "m_j = \\frac{1}{N} \\sum_i P_{ij}", "m = @m@");

/// What (10) and (11) recommend for D segments; the fits cover 5 ≤ D ≤ 20.
pub(super) fn suggest(settings: &Parameters) -> Option<Suggestion> {
    let d = settings[SEGMENTS];
    if settings[ENCODING] != Encoding::Polar || !(5..=20).contains(&d) {
        return None;
    }
    let power = |factor: f64, exponent: f64| (factor * math::pow(d as f64, exponent)).round() as u64;
    Some(match settings[INITIAL] {
        Angles::Normal => Suggestion { population: power(0.3161, 1.8376), iterations: power(0.1525, 2.3358), source: "[LTQPSO] (11)" },
        Angles::Uniform => Suggestion { population: power(0.4321, 1.7292), iterations: power(0.2855, 2.2180), source: "[LTQPSO] (10)" },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::Value;

    /// By hand: 8^1.7292 = 36.455…, 8^2.218 = 100.70…; 16^1.8376 = 163.19…, 16^2.3358 = 649.5….
    #[test]
    fn sizes_are_suggested_by_10_and_11() {
        let of = |pairs: &[(&'static str, Value)]| {
            suggest(&Parameters::new(super::super::ltqpso::ENTRY.parameters, GRID, &pairs.iter().cloned().collect()).unwrap())
        };
        let uniform = of(&[]).unwrap();
        assert_eq!((uniform.population, uniform.iterations), (16, 29));
        let normal = of(&[("segments", 16.0.into()), ("initial", "normal".into())]).unwrap();
        assert_eq!((normal.population, normal.iterations), (52, 99));
        assert_eq!(of(&[("segments", 21.0.into())]), None, "outside what the fit covers");
        assert_eq!(of(&[("encoding", "waypoints".into())]), None);
    }
}
