//! What printed figures can rest on: how many runs, which paths, which other figures. Arithmetic on what the papers print, no runs.

mod finding;
pub mod samples;
mod tables;
mod texts;

use std::cmp::Reverse;

use forage::kernel::Error;

use super::{compared::ComparedFigure, marks::Marked, papers::PAPERS};

pub use finding::Finding;

/// Gives each figure of a report the mark of the findings about it, the gravest first.
///
/// # Errors
/// As [`findings`].
pub fn attach(figures: &mut [ComparedFigure], paper: &str) -> Result<(), Error> {
    let mut findings = findings()?;
    findings.retain(|finding| finding.place.starts_with(&format!("[{paper}]")));
    findings.sort_by_key(|finding| Reverse(finding.source));
    for figure in figures {
        let is_about = |finding: &&Finding| {
            let is_it = |[table, row, measure]: &[String; 3]| {
                figure.table.starts_with(table.as_str()) && figure.row == *row && figure.measure == *measure
            };
            finding.rows.iter().any(is_it)
        };
        let mine: Vec<_> = findings.iter().filter(is_about).collect();
        figure.source = mine.first().map(|gravest| {
            let because: Vec<_> = mine.iter().map(|finding| format!("{}: {}", finding.figure, finding.because)).collect();
            Marked { mark: gravest.source, because: because.join("; ") }
        });
    }
    Ok(())
}

/// All findings, paper by paper.
///
/// # Errors
/// A printed figure that cannot be read.
pub fn findings() -> Result<Vec<Finding>, Error> {
    let mut findings = [tables::findings()?, texts::findings()?].concat();
    findings.sort_by_key(|finding| PAPERS.iter().position(|paper| finding.place.starts_with(&format!("[{}]", paper.tag))));
    Ok(findings)
}

#[cfg(test)]
mod tests {
    use super::{super::marks::Source, *};

    #[test]
    fn the_papers_figures_that_cannot_be() {
        let found = findings().unwrap();
        let of =
            |figure: &str| found.iter().find(|finding| finding.figure.contains(figure)).unwrap_or_else(|| panic!("{figure}: {found:#?}"));
        for (figure, source, because) in [
            ("10 variables, wpso: mean", Source::Doubtful, "8 runs, 1 at 1.646224"),
            ("10 variables, pso: mean", Source::Doubtful, "16 runs, 2 at 1.155149, 1 at 1.646224, 1 at 2.013315"),
            ("3.734 times", Source::Consistent, "at least 14 runs"),
            ("M min: exponent", Source::Impossible, "holds it"),
            ("factor 0.3161", Source::Impossible, "0.3169"),
            ("traditional: length 45.53", Source::Impossible, "no path"),
            ("[14]: length 43.70", Source::Consistent, "can have"),
            ("13.38 rad", Source::Impossible, "17 of them are 13.35 rad"),
            ("7.07 rad", Source::Consistent, "9 of them are 7.07 rad"),
            ("24.04 %", Source::Doubtful, "14.29 %, the printed run times by 24.04 %"),
            ("17.2 %", Source::Impossible, "15.05 %"),
            ("bat: variance 0.95", Source::Impossible, "at most"),
            ("A*: length 602.8420", Source::Impossible, "computed from the time"),
            ("improved ants: length 562.8427", Source::Consistent, "can have"),
        ] {
            let finding = of(figure);
            assert!(finding.source == source && finding.because.contains(because), "{finding:?}");
        }
    }
}
