//! Which runs a printed mean and standard deviation can be of.

use forage::math;

use super::super::compared::Printed;

/// Numbers of runs of which a mean and a standard deviation can be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sample {
    /// How many runs.
    pub runs: u64,
    /// How many of them ended in each of the local minima.
    pub stuck: Vec<u64>,
}

/// The most runs that are tried.
pub(super) const MOST_RUNS: u64 = 60;
/// What all runs together may be above the optimum that are not stuck.
const REST: f64 = 0.01;

/// All samples of 3 to `MOST_RUNS` runs that have this mean and this standard deviation (with n − 1), if some of them ended at
/// these values and the others at the optimum, which is 0: none below, and all together at most `REST` above.
pub fn samples(mean: Printed, std: Printed, minima: &[f64]) -> Vec<Sample> {
    let mut found = Vec::new();
    for runs in 3..=MOST_RUNS {
        let n = runs as f64;
        let sum = n * mean.value;
        let squares = (n - 1.0) * std.value * std.value + n * mean.value * mean.value;
        // What the digits that are not printed can change.
        let sum_error = 0.5 * n * mean.unit;
        let squares_error = (n - 1.0) * std.value * std.unit + n * mean.value * mean.unit;
        let mut stuck = vec![0; minima.len()];
        loop {
            let at = |of: fn(f64) -> f64| -> f64 { stuck.iter().zip(minima).map(|(&k, &value)| k as f64 * of(value)).sum() };
            let (rest, rest_squares) = (sum - at(|value| value), squares - at(|value| value * value));
            let others = runs.saturating_sub(stuck.iter().sum()) as f64;
            // What is left of the sum adds least to the squares if the runs at the optimum share it, most if all of it belongs to the
            // worst run.
            let above = rest.max(0.0);
            let worst = stuck.iter().zip(minima).filter(|(k, _)| **k > 0).map(|(_, value)| *value).fold(0.0, f64::max);
            let least = if others > 0.0 { above * above / others } else { 0.0 };
            let most = above * above + 2.0 * worst * above;
            let fits =
                (-sum_error..=REST + sum_error).contains(&rest) && (least - squares_error..=most + squares_error).contains(&rest_squares);
            if fits {
                found.push(Sample { runs, stuck: stuck.clone() });
            }
            if !advance(&mut stuck, runs, sum + sum_error, minima) {
                break;
            }
        }
    }
    found
}

/// The next numbers of stuck runs whose sum does not exceed what there is; false after the last.
fn advance(stuck: &mut [u64], runs: u64, sum: f64, minima: &[f64]) -> bool {
    for k in 0..stuck.len() {
        stuck[k] += 1;
        let total: f64 = stuck.iter().zip(minima).map(|(&n, value)| n as f64 * value).sum();
        if total <= sum && stuck.iter().sum::<u64>() <= runs {
            return true;
        }
        stuck[k] = 0;
    }
    false
}

/// The values of Ackley's function (a = 20, b = 0.2, c = 2π) in its local minima with 1, 2, … of `dimension` coordinates near 1 and
/// the others at 0.
pub fn ackley_minima(dimension: u32, most: u32) -> Vec<f64> {
    let d = f64::from(dimension);
    let value = |k: f64, t: f64| {
        let tau = std::f64::consts::TAU;
        -20.0 * math::exp(-0.2 * (k * t * t / d).sqrt()) - math::exp((k * math::cos(tau * t) + d - k) / d) + 20.0 + std::f64::consts::E
    };
    let minimum = |k: u32| {
        // Ternary search: there is one minimum between two tops of the cosine.
        let k = f64::from(k);
        let [mut low, mut high] = [0.6, 1.2];
        for _ in 0..200 {
            let third = (high - low) / 3.0;
            if value(k, low + third) < value(k, high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        value(k, f64::midpoint(low, high))
    };
    (1..=most).map(minimum).collect()
}

/// The least number of runs, none of them below 0, whose standard deviation (with n − 1) is so many times their mean: the ratio is at
/// most √n.
pub fn least_runs(mean: Printed, std: Printed) -> u64 {
    let ratio = (std.value - 0.5 * std.unit) / (mean.value + 0.5 * mean.unit);
    (ratio * ratio).ceil() as u64
}

/// By how much the second figure is less than the first, in per cent of the first.
pub(super) fn fall([from, to]: [f64; 2]) -> f64 {
    100.0 * (from - to) / from
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Printed {
        Printed::read(text).unwrap()
    }

    #[test]
    fn ackleys_lowest_local_minima() {
        let expected = [1.155_149, 1.646_224, 2.013_315];
        for (found, expected) in ackley_minima(10, 3).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
        }
    }

    #[test]
    fn the_samples_of_a_known_list_are_found() {
        // Nine runs: one at 2, two at 1, the others at 0.
        let list: [f64; 9] = [2.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mean = list.iter().sum::<f64>() / 9.0;
        let std = (list.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / 8.0).sqrt();
        let found = samples(read(&format!("{mean:.7}")), read(&format!("{std:.7}")), &[1.0, 2.0]);
        assert!(found.contains(&Sample { runs: 9, stuck: vec![2, 1] }), "{found:?}");
        assert!(samples(read("0.5"), read("0.1"), &[1.0, 2.0]).is_empty(), "of numbers from 0 and 1 to 2 none have so small a deviation");
    }

    #[test]
    fn so_many_times_the_mean_needs_so_many_runs() {
        // One result of n, the others 0: the standard deviation is √n times the mean.
        let list = |n: u64| [1.0 / n as f64, (1.0 / n as f64).sqrt()];
        for n in [4, 8, 50] {
            let [mean, std] = list(n).map(|x| read(&format!("{x:.9}")));
            assert_eq!(least_runs(mean, std), n);
            assert_eq!(least_runs(mean, read(&format!("{:.9}", std.value * 1.01))), n + 1 + u64::from(n == 50));
        }
    }
}
