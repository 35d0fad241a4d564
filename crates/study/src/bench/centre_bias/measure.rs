//! How much larger a planner's gap is on one form of a function than on another.

use std::collections::BTreeMap;

use forage::{
    kernel::rng::Stream,
    math,
    statistics::{RESAMPLES, bootstrap},
};

use super::{form::Form, row::Row};

/// A ratio of gaps with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ratio {
    pub value: f64,
    pub interval: Option<[f64; 2]>,
}

/// The logarithms of the ratios between a form and the centred one, by instance, in a group for each function.
fn differences(rows: &[&Row], form: Form) -> Vec<Vec<f64>> {
    let levels = |form: Form| -> BTreeMap<(&str, u64), f64> {
        rows.iter().filter(|row| row.form == form).map(|row| ((row.function.as_str(), row.instance), row.level)).collect()
    };
    let centred = levels(Form::Centred);
    let mut groups: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for (key, level) in levels(form) {
        if let Some(centred) = centred.get(&key) {
            groups.entry(key.0).or_default().push(level - centred);
        }
    }
    groups.into_values().collect()
}

/// The geometric mean of all ratios, each function counting as much.
fn mean(groups: &[Vec<f64>]) -> f64 {
    let means = groups.iter().map(|group| group.iter().sum::<f64>() / group.len() as f64);
    math::pow(10.0, means.sum::<f64>() / groups.len() as f64)
}

/// The geometric mean of these runs' gap on a form divided by that on the centred form.
pub(super) fn ratio(rows: &[&Row], form: Form) -> Option<Ratio> {
    let groups = differences(rows, form);
    if groups.is_empty() {
        return None;
    }
    let interval = bootstrap(&groups, RESAMPLES, &mut Stream::new(1, 0), mean);
    Some(Ratio { value: mean(&groups), interval })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(function: &str, form: Form, instance: u64, level: f64) -> Row {
        Row {
            planner: "p".into(),
            params: String::new(),
            function: function.into(),
            dimension: 2,
            form,
            instance,
            budget: 100,
            evaluations: 100,
            gap: 1.0,
            level,
        }
    }

    #[test]
    fn the_ratio_is_the_geometric_mean_of_pairs() {
        let rows = [
            row("a", Form::Centred, 1, 0.0),
            row("a", Form::Shifted, 1, 1.0),
            row("a", Form::Centred, 2, -1.0),
            row("a", Form::Shifted, 2, 2.0),
            row("b", Form::Centred, 1, 0.0),
            row("b", Form::Shifted, 1, 0.0),
        ];
        let rows: Vec<&Row> = rows.iter().collect();
        // Of a: 10 and 1000, 100 on average; of b: 1. Each function counts as much.
        let found = ratio(&rows, Form::Shifted).unwrap();
        assert!((found.value - 10.0).abs() < 1e-9, "{found:?}");
        // The samples of a are (1, 1), (1, 3), (3, 1) and (3, 3).
        let [low, high] = found.interval.unwrap();
        assert!((low - math::pow(10.0, 0.5)).abs() < 1e-9 && (high - math::pow(10.0, 1.5)).abs() < 1e-9);
        assert_eq!(ratio(&rows, Form::Rotated), None);
    }
}
