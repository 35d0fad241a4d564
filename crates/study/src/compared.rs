//! Published figures and the computed ones.

use forage::{
    kernel::{Error, Message},
    statistics::Summary,
};

use super::{
    figure::Figure,
    marks::{Basis, Marked, Source},
};

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
        let wrong = || Error::refused("figure", text, Message::verbatim("a number"));
        let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let places = digits.split_once('.').map_or(0, |(_, places)| places.len() as i32);
        let exponent: i32 = exponent.parse().map_err(|_| wrong())?;
        let value: f64 = text.parse().map_err(|_| wrong())?;
        // A 0 where others are 1e-158 is not a rounded one.
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

/// What was found here.
#[derive(Debug, Clone, PartialEq)]
pub enum Computed {
    /// Runs that have a result, and their values.
    Runs(Summary, Vec<f64>),
    /// A number that was fitted to so many points, and its 95 % interval.
    Fitted {
        /// The number.
        value: f64,
        /// The interval.
        interval: [f64; 2],
        /// How many points.
        points: u64,
    },
    /// A number without randomness.
    Exact(f64),
    /// Nothing: no run has a result, or it is no property of the runs.
    Nothing,
}

impl Computed {
    /// Of these numbers.
    pub fn runs(numbers: impl IntoIterator<Item = f64>) -> Self {
        let values: Vec<f64> = numbers.into_iter().collect();
        Summary::of(values.iter().copied()).map_or(Self::Nothing, |summary| Self::Runs(summary, values))
    }

    /// The number that represents it.
    pub fn mean(&self) -> Option<f64> {
        match self {
            Self::Runs(summary, _) => Some(summary.mean),
            Self::Fitted { value, .. } | Self::Exact(value) => Some(*value),
            Self::Nothing => None,
        }
    }

    /// The values of the runs, if there are any.
    pub fn values(&self) -> Option<&[f64]> {
        match self {
            Self::Runs(_, values) => Some(values),
            _ => None,
        }
    }

    /// Of how many runs.
    pub fn count(&self) -> Option<u64> {
        match self {
            Self::Runs(summary, _) => Some(summary.count as u64),
            Self::Exact(_) => Some(1),
            Self::Fitted { .. } | Self::Nothing => None,
        }
    }

    /// Smallest, standard deviation and median, where there are runs.
    pub fn spread(&self) -> [Option<f64>; 3] {
        match self {
            Self::Runs(summary, _) => [Some(summary.min), summary.std, Some(summary.median)],
            _ => [None; 3],
        }
    }
}

/// A published figure and the computed one.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedFigure {
    /// Where it is in the paper: `Table 2`.
    pub table: String,
    /// The rows that the paper compares with one another: `f1, 2 variables`. Empty: all of the table.
    pub group: String,
    /// Whose it is: `f1, 2 variables: wcpso`.
    pub row: String,
    /// Of what: `length`, and its unit.
    pub measure: String,
    /// Whether lower values are better. Not so for coefficients and tuned parameters.
    pub lower_is_better: bool,
    /// What is printed.
    pub published: Published,
    /// What was found here.
    pub computed: Computed,
    /// What the computed figure rests on.
    pub basis: Basis,
    /// What arithmetic says of the printed figure; `None`: nothing to check.
    pub source: Option<Marked<Source>>,
    /// The command that repeats one of the runs; the others differ in the seed.
    pub command: String,
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
