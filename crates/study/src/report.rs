//! What a reproduction has to say: tables, verdicts, what was chosen where the paper is silent, and how to repeat it.

use std::{fmt::Write, fs, path::PathBuf};

use forage::statistics::{LAST, Summary, comparable, rank_sum};
use serde::Serialize;

use super::{
    Failure, Options, Study, at,
    compared::ComparedFigure,
    document,
    escape::{path_text, serialize_paths},
    forensics,
    inference::brown_forsythe,
    marks::{LEVEL, probability},
    table::Table,
};

/// Whether something that was published is found here too.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Verdict {
    /// What is claimed.
    pub claim: String,
    /// Whether the runs bear it out; `None` if they cannot say.
    pub holds: Option<bool>,
    /// The numbers it rests on.
    pub because: String,
}

impl Verdict {
    /// That the first numbers are smaller than the second ones: Wilcoxon's rank-sum test, two-sided, at 5 %. A run without a
    /// number counts as the largest.
    pub(super) fn smaller(claim: impl Into<String>, numbers: &[Vec<Option<f64>>; 2], digits: usize) -> Self {
        let ranked = comparable(numbers.iter().map(Vec::as_slice));
        let median = |k: usize| Summary::of(ranked[k].iter().copied()).map(|summary| summary.median);
        let shown = |number: f64| if number < LAST { format!("{number:.digits$}") } else { "no result".to_owned() };
        let claim = claim.into();
        match (rank_sum(&ranked[0], &ranked[1]), median(0).zip(median(1))) {
            (Some(test), Some((first, second))) => Self {
                claim,
                holds: (test.p < LEVEL).then_some(test.smaller > 0.5),
                because: format!(
                    "medians {} and {}, rank-sum test p {}, A = {:.2}",
                    shown(first),
                    shown(second),
                    probability(test.p),
                    test.smaller
                ),
            },
            _ => Self { claim, holds: None, because: "no runs".to_owned() },
        }
    }

    /// That the first numbers spread less than the second ones: Brown and Forsythe's test at 5 %.
    pub(super) fn steadier(claim: impl Into<String>, numbers: &[Vec<f64>; 2], digits: usize) -> Self {
        let deviation = |k: usize| Summary::of(numbers[k].iter().copied()).and_then(|summary| summary.std);
        let claim = claim.into();
        match (brown_forsythe(&numbers[0], &numbers[1]), deviation(0).zip(deviation(1))) {
            (Some(test), Some((first, second))) => Self {
                claim,
                holds: (test.p < LEVEL).then_some(first < second),
                because: format!(
                    "standard deviations {first:.digits$} and {second:.digits$}, Brown–Forsythe test p {}",
                    probability(test.p)
                ),
            },
            _ => Self { claim, holds: None, because: "too few runs".to_owned() },
        }
    }
}

/// A reproduction's result.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// The reproduction's name.
    pub name: &'static str,
    /// A line for people.
    pub title: &'static str,
    /// Where it was published.
    pub source: &'static str,
    /// Whether all of it comes out the same again.
    pub repeatable: bool,
    /// Runs a cell, where they are fewer or more than published.
    pub shortened: Option<String>,
    /// The published figures and the computed ones.
    #[serde(serialize_with = "document::serialize_figures")]
    pub figures: Vec<ComparedFigure>,
    /// The tables.
    pub tables: Vec<Table>,
    /// The claims.
    pub verdicts: Vec<Verdict>,
    /// What was chosen where the paper is silent, and what should be known when reading the tables.
    pub notes: Vec<String>,
    /// Command lines that repeat single runs.
    pub commands: Vec<String>,
    /// What was written.
    #[serde(serialize_with = "serialize_paths")]
    pub files: Vec<PathBuf>,
}

impl Report {
    /// Nothing to say yet.
    pub fn new(reproduction: &Study, runs: u64, published: u64) -> Self {
        let shortened = (runs != published).then(|| format!("{runs} runs a cell, published: {published}"));
        let Study { name, title, source, repeatable, .. } = *reproduction;
        let (figures, tables, verdicts, notes, commands, files) = Default::default();
        Self { name, title, source, repeatable, shortened, figures, tables, verdicts, notes, commands, files }
    }

    /// Writes each table as CSV and the whole as Markdown.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&mut self, options: &Options) -> Result<(), Failure> {
        forensics::attach(&mut self.figures, document::paper(self.source))?;
        fs::create_dir_all(&options.out).map_err(at(&options.out))?;
        for table in &self.tables {
            let path = options.out.join(format!("{}-{}.csv", self.name, table.name));
            table.csv().and_then(|text| fs::write(&path, text)).map_err(at(&path))?;
            self.files.push(path);
        }
        let path = options.out.join(format!("{}.md", self.name));
        fs::write(&path, self.markdown()).map_err(at(&path))?;
        self.files.push(path);
        Ok(())
    }

    fn heading(&self) -> String {
        let shortened = self.shortened.as_ref().map_or(String::new(), |text| format!(" ({text})"));
        format!("{}: {}, {}{shortened}", self.name, self.title, self.source)
    }

    /// For a terminal.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.heading());
        document::tables(&self.figures).iter().for_each(|table| text += &(table.text() + "\n"));
        self.tables.iter().for_each(|table| text += &(table.text() + "\n"));
        self.verdicts.iter().for_each(|verdict| text += &(line(verdict) + "\n"));
        let files = self.files.iter().map(|path| path_text(path));
        for (title, items) in [("Notes", self.notes.clone()), ("To repeat a run", self.commands.clone()), ("Written", files.collect())] {
            if items.is_empty() {
                continue;
            }
            let _ = writeln!(text, "\n{title}");
            items.iter().for_each(|item| text.extend(["  ", item, "\n"]));
        }
        text
    }

    fn markdown(&self) -> String {
        let mut text = format!("## {}\n\n{}", self.heading(), document::figures(self));
        self.tables.iter().for_each(|table| text += &(table.markdown() + "\n"));
        self.verdicts.iter().for_each(|verdict| text.extend(["- ", &line(verdict), "\n"]));
        if !self.notes.is_empty() {
            text += "\n";
        }
        self.notes.iter().for_each(|note| text.extend(["- ", note, "\n"]));
        if !self.commands.is_empty() {
            text += "\nTo repeat a run:\n\n";
        }
        self.commands.iter().for_each(|command| text.extend(["    ", command, "\n"]));
        text
    }
}

/// A claim, whether it holds and why, in a line.
pub(super) fn line(Verdict { claim, holds, because }: &Verdict) -> String {
    let word = match holds {
        Some(true) => "yes",
        Some(false) => "NO",
        None => "not decided",
    };
    format!("{claim}: {word} ({because})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_is_decided_by_a_test_alone() {
        let numbers = |from: u32| (from..from + 10).map(|n| Some(f64::from(n))).collect::<Vec<_>>();
        let smaller = Verdict::smaller("a", &[numbers(0), numbers(20)], 1);
        assert_eq!((smaller.holds, smaller.because.as_str()), (Some(true), "medians 4.5 and 24.5, rank-sum test p = 0.0002, A = 1.00"));
        assert_eq!(Verdict::smaller("a", &[numbers(20), numbers(0)], 1).holds, Some(false));
        // The smaller mean is no difference.
        assert_eq!(Verdict::smaller("a", &[numbers(0), numbers(1)], 1).holds, None);
        let failed = Verdict::smaller("a", &[numbers(0), vec![None; 10]], 0);
        assert!(failed.holds == Some(true) && failed.because.starts_with("medians 4 and no result"), "{failed:?}");
        assert_eq!(Verdict::smaller("a", &[vec![], numbers(0)], 1).holds, None);
        let spread = |by: f64| (0..20).map(|n| by * f64::from(n)).collect::<Vec<_>>();
        assert_eq!(Verdict::steadier("a", &[spread(1.0), spread(9.0)], 1).holds, Some(true));
        assert_eq!(Verdict::steadier("a", &[spread(9.0), spread(1.0)], 1).holds, Some(false));
        assert_eq!(Verdict::steadier("a", &[spread(1.0), spread(1.1)], 1).holds, None);
        assert_eq!(Verdict::steadier("a", &[vec![1.0], spread(1.1)], 1).holds, None);
    }
}
