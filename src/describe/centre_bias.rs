//! The planners' centre bias: `centre_bias.csv` is the file `centre-bias.csv` that `forage bench centre-bias` writes.

use serde::Serialize;

const MEASURED: &str = include_str!("centre_bias.csv");

/// A ratio with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Ratio {
    /// The ratio.
    pub value: f64,
    /// Where its interval begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

/// How many times larger a planner's gap is on test functions that were changed, with equal evaluations.
///
/// ```
/// use forage::describe::CentreBias;
///
/// let pso = CentreBias::of("pso").unwrap();
/// assert!(pso.shifted.from < pso.shifted.value && pso.shifted.value < pso.shifted.to);
/// assert_eq!(CentreBias::of("a-star"), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct CentreBias {
    /// On functions whose minimum is shifted away from the centre of the search box.
    pub shifted: Ratio,
    /// On functions whose axes are rotated.
    pub rotated: Ratio,
    /// That of random search on the shifted functions, for comparison.
    pub random_search: Ratio,
}

impl CentreBias {
    /// That of a planner with its defaults; `None` for planners that were not measured.
    pub fn of(planner: &str) -> Option<Self> {
        let [shifted, rotated] = measured(planner)?;
        Some(Self { shifted, rotated, random_search: measured("random-search")?[0] })
    }
}

/// A planner's two ratios.
fn measured(planner: &str) -> Option<[Ratio; 2]> {
    let line = MEASURED.lines().find_map(|line| line.strip_prefix(planner)?.strip_prefix(','))?;
    let mut numbers = line.split(',').map(str::parse);
    let mut ratio = || Some(Ratio { value: numbers.next()?.ok()?, from: numbers.next()?.ok()?, to: numbers.next()?.ok()? });
    Some([ratio()?, ratio()?])
}
