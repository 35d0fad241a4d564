//! The figures of [LTQPSO], as far as the scan can be read.

/// A line of Table 1 or 2: ln N or ln M = b0 + b1 ln D.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regression {
    /// b0 and b1.
    pub b: [f64; 2],
    /// Their intervals as printed.
    pub interval: [[f64; 2]; 2],
    /// R² as printed; `None` where it cannot be read.
    pub r2: Option<f64>,
    /// The F statistic.
    pub f: f64,
}

impl Regression {
    /// How many points the paper fits: D = 5 … 20.
    pub const POINTS: f64 = 16.0;

    /// R² as printed, or where that cannot be read as it follows from F: F / (F + n − 2).
    pub fn r2(&self) -> f64 {
        self.r2.unwrap_or(self.f / (self.f + Self::POINTS - 2.0))
    }
}

const fn regression(b: [f64; 2], interval: [[f64; 2]; 2], r2: Option<f64>, f: f64) -> Regression {
    Regression { b, interval, r2, f }
}

/// N min, N max, M min and M max of Table 1, uniform start. The interval of M min's b1 does not hold its b1: so printed.
pub const TABLE_1: [Regression; 4] = [
    regression([-1.4499, 1.8720], [[-1.70, -1.19], [1.76, 1.97]], None, 1493.90),
    regression([-0.8392, 1.7291], [[-1.08, -0.59], [1.62, 1.82]], None, 1366.30),
    regression([-0.5832, 2.0079], [[-0.92, -0.24], [2.06, 2.50]], None, 1002.60),
    regression([-1.2537, 2.2080], [[-1.57, -0.93], [2.08, 2.33]], None, 1374.80),
];

/// The same of Table 2, start N(30°, 45°).
pub const TABLE_2: [Regression; 4] = [
    regression([-1.7085, 1.9905], [[-2.08, -1.32], [1.83, 2.14]], Some(0.9823), 776.26),
    regression([-1.1492, 1.8375], [[-1.44, -0.85], [1.72, 1.95]], None, 1129.40),
    regression([-1.3845, 2.1799], [[-2.02, -0.74], [1.92, 2.43]], Some(0.9592), 329.31),
    regression([-1.8788, 2.3354], [[-2.40, -1.35], [2.12, 2.54]], Some(0.9757), 561.43),
];

/// Mean, standard deviation and seconds of `qpso` and `ltqpso` in a table of results.
pub type Results = [[f64; 3]; 2];

/// Table 3: uniform start, D = 8, 50 runs.
pub const TABLE_3: Results = [[16.4604, 3.2653, 4.2507], [15.7631, 1.0213, 2.5283]];

/// Table 4: start N(45°, 30°), D = 16, 50 runs.
pub const TABLE_4: Results = [[16.0554, 5.6474, 2.8812], [15.8156, 1.1982, 1.6082]];

#[cfg(test)]
mod tests {
    use super::*;

    /// Where R² can be read it is what F and 16 points give, so the paper fits one point a D.
    #[test]
    fn a_legible_r2_agrees_with_f() {
        let legible: Vec<_> = TABLE_1.into_iter().chain(TABLE_2).filter(|line| line.r2.is_some()).collect();
        assert_eq!(legible.len(), 3);
        for line in legible {
            assert!((line.r2() - Regression { r2: None, ..line }.r2()).abs() < 1e-4, "{line:?}");
        }
    }

    /// The printed interval about M min's exponent in Table 1 is not about it; all others are, to their two digits.
    #[test]
    fn one_interval_is_misprinted() {
        let off = |line: &Regression, k: usize| (f64::midpoint(line.interval[k][0], line.interval[k][1]) - line.b[k]).abs() > 0.02;
        let lines: Vec<_> = TABLE_1.iter().chain(&TABLE_2).flat_map(|line| [off(line, 0), off(line, 1)]).collect();
        assert_eq!(lines.iter().filter(|&&off| off).count(), 1);
        assert!(lines[5]);
    }
}
