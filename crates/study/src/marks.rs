//! The marks of a published figure: value, ranking, basis and source.

use std::fmt;

use serde::{Serialize, Serializer};

/// How near our number is to the printed one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ValueMark {
    /// The same, rounded as it is printed.
    SameDigits,
    /// A test does not tell them apart.
    NoSignificantDifference,
    /// Less than a factor of ten apart.
    SamePowerOfTen,
    /// All else.
    Differs,
}

impl ValueMark {
    /// All, the nearest first.
    pub const ALL: [Self; 4] = [Self::SameDigits, Self::NoSignificantDifference, Self::SamePowerOfTen, Self::Differs];
}

/// Whether a table's rows have the same order here.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum RankingMark {
    /// Every pair as printed.
    Same,
    /// Some pairs as printed.
    Partly,
    /// Every pair that differs does so the other way.
    Reversed,
    /// No pair differs.
    Undecided,
}

impl RankingMark {
    /// All.
    pub const ALL: [Self; 4] = [Self::Same, Self::Partly, Self::Reversed, Self::Undecided];
}

/// What our number rests on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Basis {
    /// The paper prints everything.
    Printed,
    /// The paper leaves this open.
    Reconstruction(&'static str),
    /// A reading that was chosen by these figures: so many choices for so many of them.
    Fitted {
        /// How many values were chosen.
        choices: u64,
        /// By how many figures.
        figures: u64,
    },
    /// A time.
    Machine,
}

impl Basis {
    /// The reason, in words.
    pub fn reason(&self) -> String {
        match self {
            Self::Printed => "the paper prints all that it rests on".to_owned(),
            Self::Reconstruction(open) => (*open).to_owned(),
            Self::Fitted { choices, figures } => format!("{choices} values were chosen by {figures} printed figures"),
            Self::Machine => "a time depends on the machine".to_owned(),
        }
    }
}

/// Whether a figure can be what the paper says it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// It can.
    Consistent,
    /// It can, but of something else than the paper says.
    Doubtful,
    /// It cannot, as it is printed.
    Impossible,
}

impl Source {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Consistent => "consistent",
            Self::Doubtful => "doubtful",
            Self::Impossible => "impossible as printed",
        }
    }
}

macro_rules! in_words {
    ($type:ty, $($variant:pat => $word:literal),+ $(,)?) => {
        impl $type {
            /// In words.
            pub fn name(self) -> &'static str {
                match self {
                    $($variant => $word,)+
                }
            }
        }

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }

        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }
    };
}

in_words!(ValueMark,
    Self::SameDigits => "same digits",
    Self::NoSignificantDifference => "no significant difference",
    Self::SamePowerOfTen => "same power of ten",
    Self::Differs => "differs",
);
in_words!(RankingMark,
    Self::Same => "same",
    Self::Partly => "partly",
    Self::Reversed => "reversed",
    Self::Undecided => "undecided",
);
in_words!(Basis,
    Self::Printed => "printed",
    Self::Reconstruction(_) => "our reconstruction",
    Self::Fitted { .. } => "fitted",
    Self::Machine => "machine-dependent",
);

/// A mark and the numbers it rests on.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Marked<M> {
    /// The mark.
    pub mark: M,
    /// The numbers.
    pub because: String,
}

impl<M> Marked<M> {
    pub(super) fn new(mark: M, because: impl Into<String>) -> Self {
        Self { mark, because: because.into() }
    }
}

/// All marks of a figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Marks {
    /// `None`: the paper prints no figure, or nothing computed compares with it.
    pub value: Option<Marked<ValueMark>>,
    /// `None`: nothing to rank it with.
    pub ranking: Option<Marked<RankingMark>>,
    /// What the computed figure rests on.
    pub basis: Marked<Basis>,
    /// `None`: nothing to check.
    pub source: Option<Marked<Source>>,
}
