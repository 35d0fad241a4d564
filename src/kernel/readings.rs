//! The numbers of an iteration.

/// The declaration of a reading, so that its name is written once: a planner's `Reading`.
pub trait ReadingName {
    /// The name in traces, formulas and other programs.
    fn name(self) -> &'static str;
}

/// Named numbers of an iteration. Re-used from call to call.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Readings(Vec<(&'static str, f64)>);

impl Readings {
    /// Removes all numbers.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Adds a number that the planner's entry lists.
    #[inline]
    pub fn push(&mut self, reading: impl ReadingName, value: f64) {
        self.add(reading.name(), value);
    }

    fn add(&mut self, name: &'static str, value: f64) {
        self.0.push((name, value));
    }

    /// The names and numbers, always in the same order for the same run.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&'static str, f64)> + '_ {
        self.0.iter().copied()
    }

    /// The number of a reading, if there is one.
    pub fn of(&self, reading: impl ReadingName) -> Option<f64> {
        self.get(reading.name())
    }

    /// The number of this name, if there is one.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| *n == name).map(|(_, value)| *value)
    }
}
