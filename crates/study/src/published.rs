//! The figures of [WCPSO](forage#papers), of [LTQPSO](forage#papers), as far as the scan can be read, of
//! [ANTBAT](forage#papers) and of [WOLF-ANT](forage#papers).

pub mod wcpso;

use forage::{
    kernel::Error,
    scene::{GridScene, Scene},
};

use super::figure::Figure;

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

/// What [ANTBAT](forage#papers) prints of a way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Way {
    /// In cells.
    pub length: Figure,
    /// How many.
    pub turns: Figure,
    /// Of all turns, in radians.
    pub turning: Figure,
    /// In which iteration it was found.
    pub converged: Figure,
}

const fn way(length: f64, turns: f64, turning: f64, converged: f64) -> Way {
    Way {
        length: Figure::new(length, 2),
        turns: Figure::new(turns, 0),
        turning: Figure::new(turning, 2),
        converged: Figure::new(converged, 0),
    }
}

/// [ANTBAT](forage#papers) §3.1, (1.5, 26.5) → (28.5, 1.5): the traditional ants, those of its reference 14, the improved ones.
pub const ANTBAT: [Way; 3] = [way(45.53, 14.0, 13.38, 56.0), way(43.70, 12.0, 11.02, 52.0), way(42.06, 9.0, 7.07, 48.0)];

/// What [ANTBAT](forage#papers) Table 2 prints of a planner's runs: the tours' lengths in cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tours {
    /// The name in the table.
    pub name: &'static str,
    /// The shortest.
    pub best: Figure,
    /// The longest.
    pub worst: Figure,
    /// The mean.
    pub mean: Figure,
    /// The variance.
    pub variance: Figure,
}

impl Tours {
    /// How many runs a planner has.
    pub const RUNS: u64 = 30;

    const fn new(name: &'static str, [best, worst, mean, variance]: [f64; 4]) -> Self {
        let [best, worst, mean, variance] = [Figure::new(best, 2), Figure::new(worst, 2), Figure::new(mean, 2), Figure::new(variance, 2)];
        Self { name, best, worst, mean, variance }
    }

    /// The largest variance (with n − 1) that so many numbers with the printed best, worst and mean can have, however the
    /// three were rounded: n / (n − 1) · (worst − mean) (mean − best), reached when there are no numbers in between
    /// (Bhatia and Davis).
    pub fn largest_variance(&self) -> f64 {
        let half = |figure: Figure| 0.5 / (0..figure.digits).fold(1.0, |power, _| power * 10.0);
        let (best, worst) = (self.best.value - half(self.best), self.worst.value + half(self.worst));
        let mean = f64::midpoint(best, worst).clamp(self.mean.value - half(self.mean), self.mean.value + half(self.mean));
        Self::RUNS as f64 / (Self::RUNS - 1) as f64 * (worst - mean) * (mean - best)
    }
}

/// [ANTBAT](forage#papers) Table 2, 12 stops: bats, those of its reference 25, genetic algorithm, swarm, annealing.
pub const ANTBAT_TOURS: [Tours; 5] = [
    Tours::new("bat", [122.02, 123.98, 122.74, 0.95]),
    Tours::new("[25]", [122.88, 125.94, 123.46, 1.83]),
    Tours::new("GA", [123.04, 127.27, 124.27, 2.59]),
    Tours::new("PSO", [123.67, 129.18, 124.55, 3.43]),
    Tours::new("SA", [125.94, 131.02, 128.32, 5.46]),
];

/// [WOLF-ANT](forage#papers) Table 2, pixels and seconds: A*, the traditional ants, the improved ones.
pub const WOLF_ANT: [[Figure; 2]; 3] = [drive(602.842, 40.1421), drive(579.412, 38.9706), drive(562.8427, 38.1421)];

/// The improved ants' path, which [WOLF-ANT](forage#papers) §6 prints cell by cell: the centres of the cells that the scene
/// stores.
///
/// # Errors
/// A scene that is no grid.
pub fn wolf_ant_path(scene: &Scene) -> Result<Vec<[f64; 2]>, Error> {
    let cells = scene.get::<GridScene>()?.cells();
    let stored = scene.header().published.as_ref().and_then(|published| published.get("path_cells")?.as_array());
    let numbers = stored.into_iter().flatten().filter_map(|cell| usize::try_from(cell.as_u64()?).ok());
    Ok(numbers.filter(|cell| *cell < cells.len()).map(|cell| cells.centre(cell)).collect())
}

/// Turns of each of the three.
pub const WOLF_ANT_TURNS: Figure = Figure::new(10.0, 0);

const fn drive(length: f64, seconds: f64) -> [Figure; 2] {
    [Figure::new(length, 4), Figure::new(seconds, 4)]
}

/// The optimum that the tuning of [WOLF-ANT](forage#papers) §5.2 found.
pub const TUNED: [(&str, f64); 5] = [("alpha", 1.0), ("beta", 7.0), ("rho", 0.367), ("q", 333.0), ("epsilon", 2.0)];

#[cfg(test)]
mod tests {
    use super::{super::figure::Steps, *};
    use forage::{Overrides, Value, shipped, standard, statistics::Summary};

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

    /// Which printed lengths some path from cell to cell between those cells can have.
    #[test]
    fn lengths_that_no_path_has() {
        let by = |name| Steps::of(&shipped(name).unwrap()).unwrap();
        assert_eq!(by("ant-bat-30"), Steps { side: 1.0, apart: [27, 25] });
        assert_eq!(by("wolf-ant-20"), Steps { side: 20.0, apart: [17, 17] });
        assert_eq!(ANTBAT.map(|way| way.length.is_length(&by("ant-bat-30"))), [false, true, false]);
        assert_eq!(WOLF_ANT.map(|[length, _]| length.is_length(&by("wolf-ant-20"))), [false, false, true]);
        // The last digit of two: these are lengths.
        assert!(Figure::new(602.8427, 4).is_length(&by("wolf-ant-20")) && Figure::new(579.4113, 4).is_length(&by("wolf-ant-20")));
    }

    /// Two of the printed variances are larger than thirty numbers between best and worst with that mean can have.
    #[test]
    fn variances_that_no_thirty_runs_have() {
        let variance = |numbers: &[f64]| Summary::of(numbers.iter().copied()).unwrap().std.map(|std| std * std).unwrap();
        let possible = |row: &Tours| row.variance.like(row.largest_variance()) >= row.variance.value;
        assert_eq!(ANTBAT_TOURS.each_ref().map(possible), [false, false, true, true, true]);
        // Thirty numbers at the two ends and one that makes the mean right come near the bound and do not pass it.
        for row in &ANTBAT_TOURS {
            let (best, worst, mean) = (row.best.value, row.worst.value, row.mean.value);
            let high = (30.0 * (mean - best) / (worst - best)).floor() as usize;
            let rest = 30.0 * mean - high as f64 * worst - (29 - high) as f64 * best;
            let numbers: Vec<_> = [vec![worst; high], vec![best; 29 - high], vec![rest]].concat();
            let ratio = variance(&numbers) / row.largest_variance();
            assert!((0.8..=1.0).contains(&ratio), "{}: {ratio}", row.name);
        }
    }

    #[test]
    fn the_scenes_and_the_catalogue_carry_the_same_figures() {
        let file = |name| shipped(name).unwrap().header().published.clone().unwrap();
        let (antbat, wolf) = (file("ant-bat-30"), file("wolf-ant-20"));
        for (k, (way, name)) in ANTBAT.iter().zip(["traditional", "[14]", "improved"]).enumerate() {
            assert_eq!((antbat["pair"][name].as_f64(), antbat["turns"][k].as_f64()), (Some(way.length.value), Some(way.turns.value)));
        }
        for row in ANTBAT_TOURS {
            assert_eq!(antbat["tour"][row.name].as_f64(), Some(row.best.value), "{}", row.name);
        }
        for (published, name) in WOLF_ANT.iter().zip(["A*", "traditional ants", "improved ants"]) {
            assert_eq!(published.map(|figure| Some(figure.value)), [0, 1].map(|k| wolf[name][k].as_f64()), "{name}");
        }
        assert_eq!(wolf["turns"].as_f64(), Some(WOLF_ANT_TURNS.value));
        let paper = super::super::colonies::published("aco-wolf", &shipped("wolf-ant-20").unwrap(), &Overrides::new()).unwrap();
        let used = paper.check(standard()).unwrap().1;
        for (name, value) in TUNED {
            assert!(used.all().contains(&(name, Value::from(value))), "{name}");
        }
    }
}
