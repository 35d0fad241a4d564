//! Published figures beside ours, and the verdict on each by one stated rule.

use std::fmt;

use serde::{Serialize, Serializer, ser::SerializeMap};
use statrs::distribution::{ContinuousCDF, StudentsT};

use forage::{error::Error, statistics::Summary};

use super::figure::Figure;

/// The rule of the verdicts, in words.
pub const RULE: &str = "A published figure is *reproduced* if our mean is the same to the digits that are printed. It is also \
reproduced if it lies between our best and our worst run, to the digits that are printed, and, where the paper prints a standard deviation \
and a number of runs, Welch’s t-test finds no difference of the two means at 5 %; where ours is fitted, if it lies in our 95 % interval. Otherwise ours is *better* or *worse*: all figures are the better the smaller they are. All that only counts where the paper \
prints what the figure rests on (coefficients, the layout of obstacles, how it measures). Where it leaves that open, the same digits are still \
*reproduced*, and everything else is *not determined*, whether it is compatible or not; so is what it prints no figure of. The reason is given.";

/// A number as a paper prints it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Printed {
    /// The number.
    pub value: f64,
    /// What one more in the last printed digit would add.
    pub unit: f64,
}

impl Printed {
    /// From the text of the paper, with as many digits: `6.277601`, `3.367003e-11`.
    ///
    /// # Errors
    /// A text that is no number.
    pub fn read(text: &str) -> Result<Self, Error> {
        let wrong = || Error::refused("figure", text, "a number");
        let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let places = digits.split_once('.').map_or(0, |(_, places)| places.len() as i32);
        let exponent: i32 = exponent.parse().map_err(|_| wrong())?;
        let value: f64 = text.parse().map_err(|_| wrong())?;
        // A 0 beside 1e-158 is no rounded one.
        let unit = if value == 0.0 { 0.0 } else { format!("1e{}", exponent - places).parse().map_err(|_| wrong())? };
        Ok(Self { value, unit })
    }

    /// Whether a number is the same to the digits that are printed.
    pub fn is_like(&self, number: f64) -> bool {
        // The half itself, and what reading decimals costs.
        (number - self.value).abs() <= self.unit * (0.5 + 1e-9)
    }
}

impl From<Figure> for Printed {
    fn from(figure: Figure) -> Self {
        // A power of ten below 1 is read, not multiplied together.
        let unit = format!("1e-{}", figure.digits).parse().unwrap_or(1.0);
        Self { value: figure.value, unit }
    }
}

/// What a paper prints of a result.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Published {
    /// The best run.
    pub best: Option<Printed>,
    /// The mean, or the one figure that is printed.
    pub mean: Option<Printed>,
    /// The standard deviation.
    pub std: Option<f64>,
    /// How many runs; `None`: not said.
    pub runs: Option<u64>,
}

impl Published {
    /// The one figure that is printed.
    pub fn figure(figure: impl Into<Printed>) -> Self {
        Self { mean: Some(figure.into()), ..Self::default() }
    }
}

/// What stands beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ours {
    /// Runs that came to a result.
    Runs(Summary),
    /// A number that was fitted to so many points, and its 95 % interval.
    Fitted {
        /// The number.
        value: f64,
        /// The interval.
        interval: [f64; 2],
        /// How many points.
        points: u64,
    },
    /// A number without chance.
    Exact(f64),
    /// Nothing: no run came to a result, or it is no property of the runs.
    Nothing,
}

impl Ours {
    /// Of these numbers.
    pub fn runs(numbers: impl IntoIterator<Item = f64>) -> Self {
        Summary::of(numbers).map_or(Self::Nothing, Self::Runs)
    }

    /// The number that stands for it.
    pub fn mean(&self) -> Option<f64> {
        match self {
            Self::Runs(summary) => Some(summary.mean),
            Self::Fitted { value, .. } | Self::Exact(value) => Some(*value),
            Self::Nothing => None,
        }
    }

    /// Of how many runs.
    pub fn count(&self) -> Option<u64> {
        match self {
            Self::Runs(summary) => Some(summary.count as u64),
            Self::Exact(_) => Some(1),
            Self::Fitted { .. } | Self::Nothing => None,
        }
    }

    /// Smallest, standard deviation and median, where there are runs.
    pub fn spread(&self) -> [Option<f64>; 3] {
        match self {
            Self::Runs(summary) => [Some(summary.min), summary.std, Some(summary.median)],
            _ => [None; 3],
        }
    }
}

/// What [`RULE`] says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Judgement {
    /// The same, or not to be told apart.
    Reproduced,
    /// Ours is smaller.
    Better,
    /// Ours is larger.
    Worse,
    /// The paper leaves open what decides.
    Undetermined,
}

impl Judgement {
    /// All, in the order in which they are counted.
    pub const ALL: [Self; 4] = [Self::Reproduced, Self::Better, Self::Worse, Self::Undetermined];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Better => "better",
            Self::Worse => "worse",
            Self::Undetermined => "not determined",
        }
    }
}

impl fmt::Display for Judgement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Serialize for Judgement {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// A published figure beside ours.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside {
    /// Where it stands in the paper: `Table 2`.
    pub table: String,
    /// Whose it is: `f1, 2 variables: wcpso`.
    pub row: String,
    /// Of what: `length`, and its unit.
    pub measure: String,
    /// What is printed.
    pub published: Published,
    /// What was found here.
    pub ours: Ours,
    /// What the figure depends on and the paper does not print.
    pub open: Option<&'static str>,
    /// The command line that repeats one of the runs; the others differ in the seed.
    pub command: String,
}

impl Beside {
    /// The verdict by [`RULE`], and why.
    pub fn judge(&self) -> (Judgement, String) {
        let Some(published) = self.published.mean else {
            return (Judgement::Undetermined, self.open.unwrap_or("the paper prints no figure").to_owned());
        };
        let Some(mean) = self.ours.mean() else {
            return (Judgement::Undetermined, self.open.unwrap_or("no run came to a result").to_owned());
        };
        if published.is_like(mean) {
            return (Judgement::Reproduced, "the same to the digits that are printed".to_owned());
        }
        let (alike, because) = self.test(published, mean);
        match self.open {
            Some(open) => (Judgement::Undetermined, format!("{because}: {}; {open}", if alike { "compatible" } else { "they differ" })),
            None if alike => (Judgement::Reproduced, because),
            None if mean < published.value => (Judgement::Better, because),
            None => (Judgement::Worse, because),
        }
    }

    /// Whether nothing tells the two apart, and what it rests on.
    fn test(&self, published: Printed, mean: f64) -> (bool, String) {
        match (&self.ours, self.published.std, self.published.runs) {
            (Ours::Runs(ours), std, runs) => {
                // Of numbers that differ by powers of ten the test alone sees only the largest.
                let within = (ours.min..=ours.max).contains(&published.value) || published.is_like(ours.min) || published.is_like(ours.max);
                let place = format!("it lies {} our best and worst run", if within { "between" } else { "outside of" });
                let Some((std, runs)) = std.zip(runs).filter(|_| within) else { return (within, place) };
                let p = welch([published.value, std, runs as f64], [mean, ours.std.unwrap_or(0.0), ours.count as f64]);
                (p >= 0.05, format!("{place}; Welch’s t-test of the means: p {}", probability(p)))
            }
            (Ours::Fitted { interval: [low, high], points, .. }, ..) => {
                let within = (*low..=*high).contains(&published.value);
                let place = if within { "in" } else { "outside of" };
                (within, format!("it lies {place} the 95 % interval of our fit to {points} points, {low:.4} to {high:.4}"))
            }
            _ => (false, "both are single numbers".to_owned()),
        }
    }
}

/// The two-sided p-value of Welch's t-test, of means, standard deviations and numbers of runs.
pub fn welch(a: [f64; 3], b: [f64; 3]) -> f64 {
    // In units of the largest number, or the squares of the smallest results would underflow.
    let scale = [a, b].iter().flat_map(|[mean, std, _]| [mean.abs(), *std]).fold(0.0, f64::max);
    if a[0] == b[0] || scale == 0.0 {
        return 1.0;
    }
    let [a, b] = [a, b].map(|[mean, std, runs]| [mean / scale, std / scale, runs]);
    let [ea, eb] = [a, b].map(|[_, std, runs]| std * std / runs);
    let error = ea + eb;
    if error == 0.0 {
        return 0.0;
    }
    let freedom = error * error / (ea * ea / (a[2] - 1.0) + eb * eb / (b[2] - 1.0));
    let t = (a[0] - b[0]).abs() / error.sqrt();
    StudentsT::new(0.0, 1.0, freedom).map_or(1.0, |distribution| 2.0 * distribution.sf(t))
}

fn probability(p: f64) -> String {
    if p < 1e-4 { "< 0.0001".to_owned() } else { format!("= {p:.4}") }
}

impl Serialize for Beside {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let number = |printed: Option<Printed>| printed.map(|printed| printed.value);
        let [best, std, median] = self.ours.spread();
        let (judgement, because) = self.judge();
        let mut out = serializer.serialize_map(None)?;
        for (name, text) in [("table", &self.table), ("row", &self.row), ("measure", &self.measure)] {
            out.serialize_entry(name, text)?;
        }
        let printed = [("published_best", number(self.published.best)), ("published_mean", number(self.published.mean))];
        let ours = [("best", best), ("mean", self.ours.mean()), ("std", std), ("median", median)];
        for (name, number) in printed.into_iter().chain([("published_std", self.published.std)]).chain(ours) {
            out.serialize_entry(name, &number)?;
        }
        out.serialize_entry("published_runs", &self.published.runs)?;
        out.serialize_entry("runs", &self.ours.count())?;
        out.serialize_entry("verdict", &judgement)?;
        out.serialize_entry("because", &because)?;
        out.serialize_entry("command", &self.command)?;
        out.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(published: Published, ours: Ours, open: Option<&'static str>) -> Judgement {
        let text = String::new;
        Beside { table: text(), row: text(), measure: text(), published, ours, open, command: text() }.judge().0
    }

    fn printed(text: &str) -> Published {
        Published::figure(Printed::read(text).unwrap())
    }

    #[test]
    fn figures_are_read_with_the_digits_that_are_printed() {
        let small = Printed::read("3.367003e-11").unwrap();
        assert!(small.is_like(3.367_003_4e-11) && !small.is_like(3.367_004e-11));
        let whole = Printed::read("10").unwrap();
        assert!(whole.is_like(10.4) && !whole.is_like(10.6));
        assert!(Printed::from(Figure::new(602.842, 3)).is_like(602.842_4) && !Printed::from(Figure::new(602.842, 3)).is_like(602.8427));
        let zero = Printed::read("0").unwrap();
        assert!(zero.is_like(0.0) && !zero.is_like(1e-21));
        assert!(Printed::read("none").is_err());
    }

    #[test]
    fn a_single_figure_is_reproduced_between_our_best_and_worst_run() {
        let ours = Ours::runs([10.0, 11.0, 12.0]);
        assert_eq!(figure(printed("11.9"), ours, None), Judgement::Reproduced);
        assert_eq!(figure(printed("12.1"), ours, None), Judgement::Better);
        assert_eq!(figure(printed("9.9"), ours, None), Judgement::Worse);
        assert_eq!(figure(printed("9.9"), ours, Some("the layout is not printed")), Judgement::Undetermined);
        // What is open decides, unless the digits are the same.
        assert_eq!(figure(printed("11.9"), ours, Some("the layout is not printed")), Judgement::Undetermined);
        assert_eq!(figure(printed("11.0"), ours, Some("the layout is not printed")), Judgement::Reproduced);
    }

    /// Hundreds of powers of ten apart, and yet no difference to Welch's test, which sees one outlier.
    #[test]
    fn numbers_of_other_powers_of_ten_are_not_reproduced() {
        let printed = Published { std: Some(8.2e-156), runs: Some(50), ..printed("5.177476e-156") };
        let ours = Ours::runs([1e-99, 1e-98, 1e-97, 1e-90]);
        assert!(welch([5.2e-156, 8.2e-156, 50.0], [2.5e-91, 5e-91, 4.0]) > 0.05);
        assert_eq!(figure(printed, ours, None), Judgement::Worse);
        let near = Published { std: Some(0.5), runs: Some(50), ..self::printed("1.50") };
        assert_eq!(figure(near, Ours::runs([1.0, 1.4, 1.6, 2.1]), None), Judgement::Reproduced);
        // Within the range, but so many runs tell the means apart.
        let sharp = Published { std: Some(0.01), runs: Some(50), ..self::printed("1.05") };
        assert_eq!(figure(sharp, Ours::runs([1.0, 2.0].repeat(20)), None), Judgement::Worse);
    }

    #[test]
    fn what_is_not_printed_or_not_found_is_not_determined() {
        assert_eq!(figure(Published::default(), Ours::runs([1.0, 2.0]), None), Judgement::Undetermined);
        assert_eq!(figure(printed("1.0"), Ours::Nothing, None), Judgement::Undetermined);
    }

    #[test]
    fn what_is_fitted_is_reproduced_in_its_interval() {
        let ours = Ours::Fitted { value: 1.7, interval: [1.6, 1.8], points: 16 };
        assert_eq!(figure(printed("1.7512"), ours, None), Judgement::Reproduced);
        assert_eq!(figure(printed("1.9000"), ours, None), Judgement::Better);
    }

    /// python3 -c 'from scipy.stats import ttest_ind_from_stats as t; print(t(16.4604, 3.2653, 50, 15.7, 0.5, 30, equal_var=False).pvalue)', and
    /// the same with all means and deviations 1e-150 times as large.
    #[test]
    fn welchs_test_agrees_with_scipy_however_small_the_numbers() {
        let expected = 0.112_188_431_240_270_8;
        for scale in [1.0, 1e-150] {
            let p = welch([16.4604 * scale, 3.2653 * scale, 50.0], [15.7 * scale, 0.5 * scale, 30.0]);
            assert!((p - expected).abs() < 1e-9, "{p}");
        }
        assert_eq!(welch([1.0, 0.0, 5.0], [1.0, 0.0, 9.0]), 1.0);
        assert_eq!(welch([1.0, 0.0, 5.0], [2.0, 0.0, 9.0]), 0.0);
    }
}
