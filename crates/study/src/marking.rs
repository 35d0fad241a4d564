//! Marks published figures, each by one stated rule.

use serde::{Serialize, Serializer, ser::Error as _};
use statrs::distribution::{ContinuousCDF, StudentsT};

use forage::statistics::{Group, compare};

use super::{
    compared::{ComparedFigure, Computed, Printed},
    inference::mean_of,
    marks::{Marked, Marks, RankingMark, ValueMark},
    table::p_is,
};

/// The rules, in words.
pub const RULES: &str = "Each published figure has up to four marks.\n\n\
- **value**: *same digits*: the computed mean, rounded to the printed digits, is the printed figure. *no significant difference*: a test at 5 % finds no difference. \
The test is Welch’s t-test where the paper prints a standard deviation and a number of runs and our runs lie within a factor of ten. Otherwise the printed figure must \
lie between the 2.5 % and the 97.5 % quantile of the mean of as many runs as the paper has (of one run if it does not say), drawn 2,000 times from our runs with replacement; quantiles are the \
same on a logarithmic scale, so this holds for values that span powers of ten. A fitted coefficient must lie in our 95 % interval. *same power of ten*: less than a factor of ten lies between the two. *differs*: more.\n\
- **ranking**, of the rows that a table compares: each pair whose printed figures differ is tested with our runs (Wilcoxon’s rank-sum test, Holm’s correction, 5 %). *same*: all pairs differ significantly as printed. \
*reversed*: some pairs differ significantly, all of them the other way. *partly*: everything between. *undecided*: no pair differs significantly.\n\
- **basis**: *printed*: the paper prints all that the figure rests on. *our reconstruction*: it does not, and we had to choose; the reason is given. *fitted*: a reading was chosen because this table then comes out, with so many choices for so many figures. \
*machine-dependent*: a time.\n\
- **source**: *consistent*: the figure can be what the paper says. *doubtful*: it can only be of something else than the paper says. *impossible as printed*. The arithmetic is given (`forage study forensics`). No mark: nothing to check.";

/// The level of all tests.
pub const LEVEL: f64 = 0.05;
/// Runs that differ by more are not compared by a test on their means.
const POWER_OF_TEN: f64 = 10.0;

/// The mark of a figure's value.
pub fn value(figure: &ComparedFigure) -> Option<Marked<ValueMark>> {
    let (printed, mean) = (figure.published.mean?, figure.computed.mean()?);
    if printed.is_like(mean) {
        return Some(Marked::new(ValueMark::SameDigits, "the same to the digits that are printed"));
    }
    let (alike, because) = test(figure, printed, mean);
    let mark = match () {
        () if alike => ValueMark::NoSignificantDifference,
        () if is_near(printed.value, mean) => ValueMark::SamePowerOfTen,
        () => ValueMark::Differs,
    };
    Some(Marked::new(mark, because))
}

/// Whether less than a factor of ten lies between two numbers.
fn is_near(a: f64, b: f64) -> bool {
    a == b || a * b > 0.0 && (a / b).abs() < POWER_OF_TEN && (b / a).abs() < POWER_OF_TEN
}

/// Whether a test does not tell a printed figure from the computed runs, and its result.
fn test(figure: &ComparedFigure, printed: Printed, mean: f64) -> (bool, String) {
    let (std, runs) = (figure.published.std, figure.published.runs);
    match &figure.computed {
        Computed::Runs(computed, values) => {
            if let Some((std, runs)) = std.zip(runs).filter(|_| is_near(computed.min, computed.max)) {
                let p = welch([printed.value, std, runs as f64], [mean, computed.std.unwrap_or(0.0), computed.count as f64]);
                return (p >= LEVEL, format!("Welch’s t-test of the means: {}", p_is(p)));
            }
            let runs = runs.unwrap_or(1);
            let [low, high] = mean_of(values, runs as usize, 0);
            let within = printed.value + 0.5 * printed.unit >= low && printed.value - 0.5 * printed.unit <= high;
            let of = if runs == 1 { "of our runs".to_owned() } else { format!("of the means of {runs} of our runs") };
            (within, format!("95 % {of} lie between {low:.6e} and {high:.6e}"))
        }
        Computed::Fitted { interval: [low, high], points, .. } => {
            let within = (*low..=*high).contains(&printed.value);
            (within, format!("our fit to {points} points has the 95 % interval {low:.4} to {high:.4}"))
        }
        _ => (false, "both are single numbers".to_owned()),
    }
}

/// The marks of the rankings: for each figure that of the group to which it belongs, `None` where there is nothing to rank.
pub fn rankings(figures: &[ComparedFigure]) -> Vec<Option<Marked<RankingMark>>> {
    let key = |figure: &ComparedFigure| (figure.table.clone(), figure.group.clone(), figure.measure.clone());
    let of_group = |figure: &ComparedFigure| {
        let group: Vec<_> = figures.iter().filter(|other| key(other) == key(figure)).collect();
        ranking(&group)
    };
    figures.iter().map(of_group).collect()
}

/// The mark of the ranking of figures that a paper compares.
fn ranking(figures: &[&ComparedFigure]) -> Option<Marked<RankingMark>> {
    let rows: Vec<(&Printed, &[f64])> =
        figures.iter().filter_map(|figure| Some((figure.published.mean.as_ref()?, figure.computed.values()?))).collect();
    let groups: Vec<Group> = rows.iter().map(|(_, values)| Group::new("", values.iter().map(|&v| Some(v)).collect())).collect();
    let pairs: Vec<_> = compare(&groups).pairs.into_iter().filter(|pair| rows[pair.first].0.value != rows[pair.second].0.value).collect();
    if pairs.is_empty() {
        return None;
    }
    let significant = || pairs.iter().filter(|pair| pair.corrected.is_some_and(|p| p < LEVEL) && pair.better != 0.5);
    let as_printed = significant().filter(|pair| (pair.better > 0.5) == (rows[pair.first].0.value < rows[pair.second].0.value)).count();
    let [different, all] = [significant().count(), pairs.len()];
    let mark = match as_printed {
        0 if different == 0 => RankingMark::Undecided,
        0 => RankingMark::Reversed,
        n if n == all => RankingMark::Same,
        _ => RankingMark::Partly,
    };
    let because = format!("of {all} pairs {as_printed} differ significantly as printed, {} the other way", different - as_printed);
    Some(Marked::new(mark, because))
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

impl ComparedFigure {
    /// The marks that need no other figure.
    pub fn marks(&self, ranking: Option<Marked<RankingMark>>) -> Marks {
        let basis = Marked { mark: self.basis, because: self.basis.reason() };
        Marks { value: value(self), ranking, basis, source: self.source.clone() }
    }
}

/// Figures with their marks.
pub(super) fn marked(figures: &[ComparedFigure]) -> Vec<(&ComparedFigure, Marks)> {
    figures.iter().zip(rankings(figures)).map(|(figure, ranking)| (figure, figure.marks(ranking))).collect()
}

/// A figure as an object, with its marks.
#[derive(Serialize)]
struct FigureRow<'a> {
    table: &'a str,
    row: &'a str,
    measure: &'a str,
    lower_is_better: bool,
    published_best: Option<f64>,
    published_mean: Option<f64>,
    published_std: Option<f64>,
    published_runs: Option<u64>,
    best: Option<f64>,
    mean: Option<f64>,
    std: Option<f64>,
    median: Option<f64>,
    runs: Option<u64>,
    #[serde(flatten)]
    marks: Marks,
    command: &'a str,
}

/// Writes figures as JSON, each with its marks.
///
/// # Errors
/// What the serializer refuses.
pub(super) fn serialize_figures<S: Serializer>(figures: &[ComparedFigure], serializer: S) -> Result<S::Ok, S::Error> {
    let row = |(figure, marks): (&'_ ComparedFigure, Marks)| {
        let [best, std, median] = figure.computed.spread();
        serde_json::to_value(FigureRow {
            table: &figure.table,
            row: &figure.row,
            measure: &figure.measure,
            lower_is_better: figure.lower_is_better,
            published_best: figure.published.best.map(|printed| printed.value),
            published_mean: figure.published.mean.map(|printed| printed.value),
            published_std: figure.published.std,
            published_runs: figure.published.runs,
            best,
            mean: figure.computed.mean(),
            std,
            median,
            runs: figure.computed.count(),
            marks,
            command: &figure.command,
        })
        .map_err(S::Error::custom)
    };
    let rows: Vec<_> = marked(figures).into_iter().map(row).collect::<Result<_, _>>()?;
    rows.serialize(serializer)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{compared::Published, marks::Basis};

    fn figure(group: &str, published: Published, computed: Computed) -> ComparedFigure {
        let text = String::new;
        let (group, basis) = (group.to_owned(), Basis::Printed);
        ComparedFigure {
            table: text(),
            group,
            row: text(),
            measure: text(),
            lower_is_better: true,
            published,
            computed,
            basis,
            source: None,
            command: text(),
        }
    }

    fn printed(text: &str) -> Published {
        Published::figure(Printed::read(text).unwrap())
    }

    fn mark(published: Published, computed: Computed) -> Option<ValueMark> {
        value(&figure("", published, computed)).map(|marked| marked.mark)
    }

    #[test]
    fn a_value_has_the_nearest_mark_that_holds() {
        let computed = || Computed::runs([10.0, 11.0, 12.0]);
        assert_eq!(mark(printed("11.0"), computed()), Some(ValueMark::SameDigits));
        assert_eq!(mark(printed("11.9"), computed()), Some(ValueMark::NoSignificantDifference));
        assert_eq!(mark(printed("12.1"), computed()), Some(ValueMark::SamePowerOfTen));
        assert_eq!(mark(printed("109"), computed()), Some(ValueMark::SamePowerOfTen));
        assert_eq!(mark(printed("111"), computed()), Some(ValueMark::Differs));
        assert_eq!(mark(printed("1.0"), computed()), Some(ValueMark::Differs));
        assert_eq!(mark(printed("0"), computed()), Some(ValueMark::Differs));
        assert_eq!(mark(printed("0"), Computed::Exact(0.0)), Some(ValueMark::SameDigits));
        assert_eq!(mark(Published::default(), computed()), None);
        assert_eq!(mark(printed("1.0"), Computed::Nothing), None);
        let fitted = || Computed::Fitted { value: 1.7, interval: [1.6, 1.8], points: 16 };
        assert_eq!(mark(printed("1.7512"), fitted()), Some(ValueMark::NoSignificantDifference));
        assert_eq!(mark(printed("1.9000"), fitted()), Some(ValueMark::SamePowerOfTen));
    }

    /// Hundreds of powers of ten apart, and yet no difference to Welch's test, which sees one outlier.
    #[test]
    fn numbers_that_span_powers_of_ten_are_not_compared_by_their_means() {
        let published = Published { std: Some(8.2e-156), runs: Some(50), ..printed("5.177476e-156") };
        assert!(welch([5.2e-156, 8.2e-156, 50.0], [2.5e-91, 5e-91, 4.0]) > LEVEL);
        assert_eq!(mark(published, Computed::runs([1e-99, 1e-98, 1e-97, 1e-90])), Some(ValueMark::Differs));
        // A mean of 50 runs of which the largest is drawn about as often as not.
        let published = Published { std: Some(1e-8), runs: Some(50), ..printed("2.1e-9") };
        assert_eq!(
            mark(published, Computed::runs((0..50).map(|k| if k == 0 { 1e-7 } else { 1e-12 }))),
            Some(ValueMark::NoSignificantDifference)
        );
        // So many runs tell means apart that lie within the range.
        let sharp = Published { std: Some(0.01), runs: Some(50), ..printed("1.05") };
        assert_eq!(mark(sharp, Computed::runs([1.0, 2.0].repeat(20))), Some(ValueMark::SamePowerOfTen));
    }

    #[test]
    fn rankings_count_the_pairs_that_differ() {
        let runs = |from: f64| Computed::runs((0..20).map(|k| from + f64::from(k) / 100.0));
        let rank = |printed_as: [&str; 3], computed: [f64; 3]| {
            let figures: Vec<_> = printed_as.into_iter().zip(computed).map(|(text, from)| figure("g", printed(text), runs(from))).collect();
            rankings(&figures)[0].as_ref().map(|marked| marked.mark)
        };
        assert_eq!(rank(["1", "2", "3"], [1.0, 2.0, 3.0]), Some(RankingMark::Same));
        assert_eq!(rank(["1", "2", "3"], [3.0, 2.0, 1.0]), Some(RankingMark::Reversed));
        assert_eq!(rank(["1", "2", "3"], [2.0, 1.0, 3.0]), Some(RankingMark::Partly));
        assert_eq!(rank(["1", "2", "3"], [1.0, 1.0, 1.0]), Some(RankingMark::Undecided));
        // Equal printed figures are no pair.
        assert_eq!(rank(["1", "1", "1"], [1.0, 2.0, 3.0]), None);
        let others = [figure("a", printed("1"), runs(1.0)), figure("b", printed("2"), runs(2.0))];
        assert_eq!(rankings(&others), [None, None]);
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
