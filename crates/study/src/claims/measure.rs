//! The numbers of a run that claims are about.

/// A number of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// In the run's row: a column, a reading or a number of its motion.
    pub key: &'static str,
    /// In words.
    pub name: &'static str,
    /// Digits that are shown, from the first that is not 0.
    pub digits: usize,
    /// Whether differences of less than half a per cent are trivial: so of lengths and costs.
    pub trivial: bool,
    /// Whether a run without a feasible result has none.
    pub of_feasible: bool,
    /// What is smaller is rounding and counts as 0.
    pub floor: f64,
}

impl Measure {
    /// A number that only a feasible result has.
    pub const fn new(key: &'static str, name: &'static str, digits: usize) -> Self {
        Self { key, name, digits, trivial: false, of_feasible: true, floor: 0.0 }
    }

    pub(super) const fn or_trivial(self) -> Self {
        Self { trivial: true, ..self }
    }

    pub(super) const fn of_any_run(self) -> Self {
        Self { of_feasible: false, ..self }
    }
}

/// The value of a function.
pub const VALUE: Measure = Measure::new("value", "value", 4);

/// The value of a shipped function. What is left of Ackley's below 1e-14 is rounding: numbers of the order of 1 are added and subtracted.
pub(super) fn value_on(scene: &str) -> Measure {
    Measure { floor: if scene.starts_with("ackley") { 1e-14 } else { 0.0 }, ..VALUE }
}

/// The length of a path or a tour.
pub const LENGTH: Measure = Measure::new("value", "length", 6).or_trivial();
/// How far it is from the exact optimum.
pub const GAP: Measure = Measure::new("gap", "gap to the exact optimum", 3);
/// What it cost.
pub const EVALUATIONS: Measure = Measure::new("evaluations", "evaluations", 4);
