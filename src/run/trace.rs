//! The readings of past iterations, thinned as history grows.

use std::{fmt::Display, io};

use crate::kernel::{Readings, digits::Digits};

/// What is said of a planner whose readings change their names within a run.
pub(crate) const OTHER_READINGS: &str = "a run tells the same names all along";

/// Readings of iterations 0, s, 2s, … where the stride s doubles whenever [`Trace::CAPACITY`] rows are full.
#[derive(Debug, Clone)]
pub struct Trace {
    columns: Vec<&'static str>,
    iterations: Vec<u64>,
    values: Vec<f64>,
    stride: u64,
    capacity: usize,
}

impl Default for Trace {
    fn default() -> Self {
        Self::with_capacity(Self::CAPACITY)
    }
}

impl Trace {
    /// The most rows that are kept.
    pub const CAPACITY: usize = 8192;

    /// A trace that keeps at most `capacity` rows (at least 2).
    pub fn with_capacity(capacity: usize) -> Self {
        Self { columns: Vec::new(), iterations: Vec::new(), values: Vec::new(), stride: 1, capacity: capacity.max(2) }
    }

    /// Whether a row for this iteration would be kept: it is due and not there yet.
    pub fn wants(&self, iteration: u64) -> bool {
        iteration.is_multiple_of(self.stride) && self.iterations.last().is_none_or(|&last| iteration > last)
    }

    /// Keeps a row.
    pub fn push(&mut self, iteration: u64, readings: &Readings) {
        if self.columns.is_empty() {
            self.columns = readings.iter().map(|(name, _)| name).collect();
        }
        if self.iterations.len() == self.capacity {
            self.thin();
            if !self.wants(iteration) {
                return;
            }
        }
        debug_assert!(readings.iter().map(|(name, _)| name).eq(self.columns.iter().copied()), "{OTHER_READINGS}");
        self.iterations.push(iteration);
        self.values.extend(readings.iter().map(|(_, value)| value));
    }

    fn thin(&mut self) {
        self.stride *= 2;
        let (width, stride) = (self.columns.len(), self.stride);
        let kept: Vec<usize> = (0..self.iterations.len()).filter(|&row| self.iterations[row].is_multiple_of(stride)).collect();
        self.values = kept.iter().flat_map(|&row| &self.values[row * width..(row + 1) * width]).copied().collect();
        self.iterations = kept.iter().map(|&row| self.iterations[row]).collect();
    }

    /// Names of the readings.
    pub fn columns(&self) -> &[&'static str] {
        &self.columns
    }

    /// The kept iterations after `after` (all of them for `None`), and their readings, row by row.
    pub fn since(&self, after: Option<u64>) -> (&[u64], &[f64]) {
        let row = after.map_or(0, |after| self.iterations.partition_point(|&k| k <= after));
        (&self.iterations[row..], &self.values[row * self.columns.len()..])
    }

    /// Writes the rows as CSV: `iteration` and the readings' names, then a line for each kept iteration.
    ///
    /// # Errors
    /// Whatever the writer reports.
    pub fn write_csv(&self, mut out: impl io::Write) -> io::Result<()> {
        csv_heading(&mut out, self.columns.iter().copied())?;
        let (iterations, values) = self.since(None);
        for (&k, row) in iterations.iter().zip(values.chunks_exact(self.columns.len().max(1))) {
            csv_row(&mut out, k, row.iter().copied())?;
        }
        out.flush()
    }
}

/// Writes a CSV heading: `iteration` and the readings' names.
///
/// # Errors
/// Whatever the writer reports.
pub fn csv_heading<'a>(out: &mut impl io::Write, names: impl Iterator<Item = &'a str>) -> io::Result<()> {
    write!(out, "iteration,")?;
    csv_line(out, names)
}

/// Writes a CSV line: the iteration and its readings.
///
/// # Errors
/// Whatever the writer reports.
pub fn csv_row(out: &mut impl io::Write, iteration: u64, values: impl Iterator<Item = f64>) -> io::Result<()> {
    write!(out, "{iteration},")?;
    csv_line(out, values.map(Digits))
}

/// Writes numbers or names with commas between them. Names are identifiers: nothing ever needs quotes.
///
/// # Errors
/// Whatever the writer reports.
pub fn csv_line<T: Display>(out: &mut impl io::Write, values: impl Iterator<Item = T>) -> io::Result<()> {
    for (i, value) in values.enumerate() {
        write!(out, "{}{value}", if i == 0 { "" } else { "," })?;
    }
    writeln!(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::describe::{Group, Reading};

    const BEST: Reading = Reading::new("best", "", "", Group::Cost, "");
    const MEAN: Reading = Reading::new("mean", "", "", Group::Cost, "");

    fn readings(value: f64) -> Readings {
        let mut readings = Readings::default();
        readings.push(BEST, value);
        readings.push(MEAN, 2.0 * value);
        readings
    }

    #[test]
    fn thinning_keeps_whole_rows_and_the_first() {
        let mut trace = Trace::with_capacity(4);
        for k in 0..=20 {
            if trace.wants(k) {
                trace.push(k, &readings(k as f64));
            }
        }
        let (iterations, values) = trace.since(None);
        assert_eq!(iterations, [0, 8, 16]);
        assert_eq!(values, [0.0, 0.0, 8.0, 16.0, 16.0, 32.0]);
        assert_eq!(trace.since(Some(8)).0, [16]);
    }

    #[test]
    fn csv_has_a_line_for_each_row() {
        let mut trace = Trace::default();
        trace.push(0, &readings(0.5));
        trace.push(1, &readings(0.25));
        let mut text = Vec::new();
        trace.write_csv(&mut text).unwrap();
        assert_eq!(String::from_utf8(text).unwrap(), "iteration,best,mean\n0,0.5,1\n1,0.25,0.5\n");
    }
}
