//! Answers and marks: what the runs say of a claim.

use serde::Serialize;

use forage::Overrides;

/// What the runs say of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Answer {
    /// Significant as claimed, and large enough.
    AsClaimed,
    /// Significant the other way.
    Contrary,
    /// A length or cost that differs by less than half a per cent.
    Trivial,
    /// All else.
    Undecided,
}

impl Answer {
    /// All.
    pub const ALL: [Self; 4] = [Self::AsClaimed, Self::Contrary, Self::Trivial, Self::Undecided];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::AsClaimed => "as claimed",
            Self::Contrary => "contrary",
            Self::Trivial => "trivial",
            Self::Undecided => "undecided",
        }
    }
}

/// The mark of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mark {
    /// Every part is as claimed.
    Upheld,
    /// Every part is contrary or trivial; of a claim about all cases one contrary part is enough.
    Refuted,
    /// All else.
    Undecided,
}

impl Mark {
    /// All.
    pub const ALL: [Self; 3] = [Self::Upheld, Self::Refuted, Self::Undecided];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Upheld => "upheld",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
        }
    }

    pub(super) fn of(answers: &[Answer], universal: bool) -> Self {
        let all = |of: &dyn Fn(&Answer) -> bool| !answers.is_empty() && answers.iter().all(of);
        match () {
            () if universal && answers.contains(&Answer::Contrary) => Self::Refuted,
            () if all(&|answer| *answer == Answer::AsClaimed) => Self::Upheld,
            () if all(&|answer| matches!(answer, Answer::Contrary | Answer::Trivial)) => Self::Refuted,
            () => Self::Undecided,
        }
    }
}

/// A planner of a part, as a report shows it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShownArm {
    /// The planner's name.
    pub planner: &'static str,
    /// The parameters that are not its defaults.
    pub parameters: Overrides,
    /// The same of the arm’s motion.
    #[serde(skip_serializing_if = "Overrides::is_empty")]
    pub motion: Overrides,
    /// The command that repeats its first run.
    pub command: String,
}

/// A part and what its runs say.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answered {
    /// What was asked.
    pub question: String,
    /// Where.
    pub on: String,
    /// The scene, if it is one that ships.
    pub scene: Option<&'static str>,
    /// The planners.
    pub arms: Vec<ShownArm>,
    /// The first and the last seed.
    pub seeds: [u64; 2],
    /// Runs of each planner; maps, if each map is a pair.
    pub n: usize,
    /// The numbers that were compared.
    pub numbers: String,
    /// The test.
    pub test: &'static str,
    /// Its result.
    pub p: Option<f64>,
    /// The same, corrected for the claim's other parts (Holm).
    pub corrected: Option<f64>,
    /// The size of the effect.
    pub effect: String,
    /// What follows.
    pub answer: Answer,
}

/// A claim and its mark.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Judged {
    /// See [`Claim::id`](super::Claim::id).
    pub id: &'static str,
    /// See [`Claim::quotation`](super::Claim::quotation).
    pub quotation: &'static str,
    /// See [`Claim::says`](super::Claim::says).
    pub says: &'static str,
    /// See [`Claim::place`](super::Claim::place).
    pub place: &'static str,
    /// See [`Claim::universal`](super::Claim::universal).
    pub universal: bool,
    /// See [`Claim::tables`](super::Claim::tables).
    pub tables: &'static [&'static str],
    /// See [`Claim::reading`](super::Claim::reading).
    pub reading: &'static str,
    /// What follows from the parts.
    pub mark: Mark,
    /// The parts, counted.
    pub because: String,
    /// The parts.
    pub parts: Vec<Answered>,
}
