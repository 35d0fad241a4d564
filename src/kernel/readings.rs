//! The numbers of an iteration.

/// Named numbers of an iteration. Re-used from call to call.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Readings(Vec<(&'static str, f64)>);

impl Readings {
    /// Empties it.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Adds a number under a name that the planner's entry lists.
    pub fn push(&mut self, name: &'static str, value: f64) {
        self.0.push((name, value));
    }

    /// The names and numbers, always in the same order for the same run.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&'static str, f64)> + '_ {
        self.0.iter().copied()
    }

    /// The number of this name.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| *n == name).map(|(_, value)| *value)
    }
}
