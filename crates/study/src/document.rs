//! All reproductions in one document: `REPRODUCTION.md` for people, `REPRODUCTION.csv` with the figures and
//! `REPRODUCTION.claims.json` with the claims for programs, and the fingerprints of their rows. All hold only what is computed, so that running everything again gives the same bytes.

use std::{
    fmt::Write,
    fs, io,
    path::{Path, PathBuf},
};

use forage::message;

use super::{
    claims, disk,
    escape::path_text,
    failure::{Failure, at},
    fingerprints::{self, Fingerprints},
    marking::{RULES, marked},
    marks::{Marks, RankingMark, ValueMark},
    options::Options,
    papers::{self, PAPERS},
    report::{Report, figures},
    table::digits,
};

/// The names of the files.
pub const FILES: [&str; 4] = ["REPRODUCTION.md", "REPRODUCTION.csv", "REPRODUCTION.claims.json", fingerprints::FILE];

/// The columns of the second one.
pub const COLUMNS: [&str; 24] = [
    "reproduction",
    "paper",
    "table",
    "row",
    "measure",
    "lower_is_better",
    "published_best",
    "published_mean",
    "published_std",
    "published_runs",
    "best",
    "mean",
    "std",
    "median",
    "runs",
    "value",
    "value_because",
    "ranking",
    "ranking_because",
    "basis",
    "basis_because",
    "source",
    "source_because",
    "command",
];

/// How often each mark was given: `value: 3 same digits, 1 differs; ranking: 2 same`.
fn counted<'a>(marks: &(impl Iterator<Item = &'a Marks> + Clone)) -> String {
    let count = |name: &str, of: &dyn Fn(&Marks) -> bool| (marks.clone().filter(|marks| of(marks)).count(), name.to_owned());
    let listed = |counts: Vec<(usize, String)>| {
        counts.into_iter().filter(|(count, _)| *count > 0).map(|(count, name)| format!("{count} {name}")).collect::<Vec<_>>().join(", ")
    };
    let mut values: Vec<_> = ValueMark::ALL
        .iter()
        .map(|&mark| count(mark.name(), &|marks| marks.value.as_ref().is_some_and(|value| value.mark == mark)))
        .collect();
    values.push(count("without a value to compare", &|marks| marks.value.is_none()));
    let rankings = RankingMark::ALL
        .iter()
        .map(|&mark| count(mark.name(), &|marks| marks.ranking.as_ref().is_some_and(|ranking| ranking.mark == mark)))
        .collect();
    let rankings = listed(rankings);
    if rankings.is_empty() {
        return format!("values: {}", listed(values));
    }
    format!("values: {}; rankings of the rows that they are in: {rankings}", listed(values))
}

/// The whole document.
pub fn markdown(reports: &[Report]) -> String {
    let all: Vec<(&Report, Vec<Marks>)> =
        reports.iter().map(|report| (report, marked(&report.figures).into_iter().map(|(_, marks)| marks).collect())).collect();
    let mut text = format!(
        "# Reproduction\n\nWhat five papers claim, their published figures and the computed ones, and results beyond the papers, as `forage reproduce` writes them. The figures \
are in `REPRODUCTION.csv` too, the claims in `REPRODUCTION.claims.json`. All of it is reproducible bit for bit, which `scripts/test reproduction` checks. `forage reproduce NAME` prints further tables.\n\n\
{}. {}: {}.\n\n## How claims are judged\n\n{}\n\n## How figures are marked\n\n{RULES}\n",
        claims::counted(reports.iter().flat_map(|report| &report.claims)),
        capital(&figures_in_words(all.iter().map(|(_, marks)| marks.len()).sum())),
        counted(&all.iter().flat_map(|(_, marks)| marks)),
        claims::RULES,
    );
    for paper in &PAPERS {
        let mine: Vec<&(&Report, Vec<Marks>)> = all.iter().filter(|(report, _)| report.paper() == paper.tag).collect();
        let marks = mine.iter().flat_map(|(_, marks)| marks);
        let count = marks.clone().count();
        if mine.is_empty() {
            continue;
        }
        let claimed = || mine.iter().flat_map(|(report, _)| &report.claims);
        let _ = write!(text, "\n## [{}]\n\n{}\n\n", paper.tag, paper.citation());
        if claimed().next().is_some() {
            let _ = write!(text, "{}.\n\n", claims::counted(claimed()));
        }
        if count > 0 {
            let _ = write!(text, "{}: {}.\n\n", capital(&figures_in_words(count)), counted(&marks));
        }
        text += "Pictures without numbers:\n\n";
        for picture in paper.pictures {
            let claims = if picture.claims.is_empty() { String::new() } else { format!(" Claims: {}.", picture.claims.join(", ")) };
            let remark = if picture.remark.is_empty() { String::new() } else { format!(" {}", picture.remark) };
            let _ = writeln!(text, "- {}: {}.{claims}{remark}", picture.name, picture.shows);
        }
        // The claims first, then the figures that they rest on.
        let (with, without): (Vec<_>, Vec<_>) = mine.into_iter().partition(|(report, _)| !report.claims.is_empty());
        for (report, _) in with.into_iter().chain(without) {
            let _ = write!(text, "\n### {}: {}, {}\n\n", report.name, report.title, report.source);
            if let Some(shortened) = &report.shortened {
                let _ = write!(text, "SHORTENED: {shortened}.\n\n");
            }
            if !report.repeatable {
                let _ = writeln!(
                    text,
                    "Measured times: `forage reproduce {}` prints them; they are not the same again and not kept here.",
                    report.name
                );
                continue;
            }
            text += &claims::markdown(&report.claims);
            text += &figures(report);
            report.notes.iter().for_each(|note| text.extend(["- ", note, "\n"]));
        }
    }
    let own: Vec<&Report> = reports.iter().filter(|report| papers::find(report.paper()).is_none()).collect();
    if !own.is_empty() {
        text += "\n## Beyond the papers\n";
    }
    for report in own {
        let _ = write!(text, "\n### {}: {}\n\n", report.name, report.title);
        if let Some(shortened) = &report.shortened {
            let _ = write!(text, "SHORTENED: {shortened}.\n\n");
        }
        report.notes.iter().for_each(|note| text.extend(["- ", note, "\n"]));
        report.tables.iter().for_each(|table| text.extend(["\n", &table.markdown()]));
    }
    text
}

fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

fn figures_in_words(count: usize) -> String {
    if count == 1 { "one figure".to_owned() } else { format!("{count} figures") }
}

/// The figures for programs, with all digits.
///
/// # Errors
/// None that is known: it is written to memory.
pub fn csv(reports: &[Report]) -> Result<String, io::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS).map_err(io::Error::other)?;
    for report in reports {
        for (figure, marks) in marked(&report.figures) {
            let number = |number: Option<f64>| number.map(digits).unwrap_or_default();
            let count = |count: Option<u64>| count.map(|count| count.to_string()).unwrap_or_default();
            let [best, std, median] = figure.computed.spread();
            let because = |because: Option<&String>| because.cloned().unwrap_or_default();
            let Marks { value, ranking, basis, source } = &marks;
            writer
                .write_record([
                    report.name,
                    report.paper(),
                    &figure.table,
                    &figure.row,
                    &figure.measure,
                    if figure.lower_is_better { "yes" } else { "no" },
                    &number(figure.published.best.map(|printed| printed.value)),
                    &number(figure.published.mean.map(|printed| printed.value)),
                    &number(figure.published.std),
                    &count(figure.published.runs),
                    &number(best),
                    &number(figure.computed.mean()),
                    &number(std),
                    &number(median),
                    &count(figure.computed.count()),
                    value.as_ref().map_or("", |value| value.mark.name()),
                    &because(value.as_ref().map(|value| &value.because)),
                    ranking.as_ref().map_or("", |ranking| ranking.mark.name()),
                    &because(ranking.as_ref().map(|ranking| &ranking.because)),
                    basis.mark.name(),
                    &basis.because,
                    source.as_ref().map_or("", |source| source.mark.name()),
                    &because(source.as_ref().map(|source| &source.because)),
                    &figure.command,
                ])
                .map_err(io::Error::other)?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| io::Error::other(error.to_string()))?;
    String::from_utf8(bytes).map_err(io::Error::other)
}

/// All documents, in the order of [`FILES`].
fn texts(reports: &[Report], rows: &Fingerprints) -> Result<[String; 4], Failure> {
    Ok([markdown(reports), csv(reports).map_err(at(Path::new(FILES[1])))?, claims::json(reports)?, rows.text()])
}

/// Writes all files into the folder of the experiment, and says where.
///
/// # Errors
/// A file that cannot be written.
pub fn write(reports: &[Report], rows: &Fingerprints, options: &Options) -> Result<[PathBuf; 4], Failure> {
    let paths = FILES.map(|name| options.out.join(name));
    for (path, text) in paths.iter().zip(texts(reports, rows)?) {
        disk::write(path, text).map_err(at(path))?;
    }
    Ok(paths)
}

/// Where the documents differ from those that a folder holds, if they do: the first line of each.
///
/// # Errors
/// A file that cannot be read.
pub fn differences(reports: &[Report], rows: &Fingerprints, folder: &Path) -> Result<Vec<String>, Failure> {
    let mut different = Vec::new();
    for (name, now) in FILES.iter().zip(texts(reports, rows)?) {
        let kept = folder.join(name);
        let then = fs::read_to_string(&kept).map_err(at(&kept))?;
        let mut lines = now.lines().zip(then.lines()).enumerate();
        if let Some((k, (now, then))) = lines.find(|(_, (now, then))| now != then) {
            let place = message!("study-differs-in-line", "{file} differs in line {line}:", file = path_text(&kept), line = k + 1);
            let (now, there) = (message!("study-line-now", "now   {now}", now), message!("study-line-there", "there {then}", then));
            different.push(format!("{place}\n  {now}\n  {there}"));
        } else if now != then {
            let (file, then, now) = (path_text(&kept), then.lines().count(), now.lines().count());
            different.push(message!("study-lines-differ", "{file} has {then} lines instead of {now}", file, then, now).to_string());
        }
    }
    Ok(different)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        compared::{ComparedFigure, Computed, Printed, Published},
        marks::Basis,
        registry::{REPRODUCTIONS, STUDIES},
        study::find,
        table::Table,
    };

    fn report() -> Report {
        let mut report = find(REPRODUCTIONS, "NAME", "wcpso-functions").unwrap().report(50, 50);
        let figure = |row: &str, text: &str, computed: Computed| ComparedFigure {
            table: "Table 2".to_owned(),
            group: String::new(),
            row: row.to_owned(),
            measure: "value".to_owned(),
            lower_is_better: true,
            published: Published::figure(Printed::read(text).unwrap()),
            computed,
            basis: Basis::Printed,
            source: None,
            command: format!("forage run {row} --scene matyas --seed 1"),
        };
        report.figures =
            vec![figure("pso", "1.50e-3", Computed::runs([0.001, 0.002])), figure("wpso, \"linear\"", "7", Computed::runs([8.5, 9.0]))];
        report
    }

    #[test]
    fn the_document_counts_marks_and_gives_each_rows_command() {
        let text = markdown(&[report()]);
        for part in [
            RULES,
            "2 figures: values: 1 same digits, 1 same power of ten; rankings of the rows that they are in: 2 undecided.",
            "## [WCPSO]",
            "- pso: the same to the digits that are printed; of 1 pairs 0 differ significantly as printed, 0 the other way (value). `forage run pso --scene matyas --seed 1`",
            "0.00150",
            "| same power of ten",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[test]
    fn programs_read_what_people_read() {
        let text = csv(&[report()]).unwrap();
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        assert_eq!(reader.headers().unwrap().iter().collect::<Vec<_>>(), COLUMNS);
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.iter().map(|row| &row[15]).collect::<Vec<_>>(), ["same digits", "same power of ten"]);
        assert_eq!((&rows[0][1], &rows[0][11], &rows[1][3]), ("WCPSO", "0.0015", "wpso, \"linear\""));
    }

    #[test]
    fn a_document_that_differs_is_told_by_its_line() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().to_owned();
        let options = Options { out: out.clone(), threads: None, runs: None, fresh: false };
        let written = write(&[report()], &Fingerprints::default(), &options).unwrap();
        assert_eq!(differences(&[report()], &Fingerprints::default(), &out).unwrap(), Vec::<String>::new());
        let text = fs::read_to_string(&written[1]).unwrap();
        fs::write(&written[1], text.replace("0.0015", "0.0016")).unwrap();
        let found = differences(&[report()], &Fingerprints::default(), &out).unwrap();
        assert!(found.len() == 1 && found[0].contains("REPRODUCTION.csv differs in line 2"), "{found:?}");
        fs::write(&written[1], text + "\n").unwrap();
        assert!(differences(&[report()], &Fingerprints::default(), &out).unwrap()[0].contains("lines instead of"));
    }

    #[test]
    fn studies_of_our_own_follow_the_papers() {
        let mut own = STUDIES[0].report(2, 100);
        own.tables.push(Table { rows: vec![vec!["a-star".into()]], ..Table::new("maze", "maze, 2 maps", &["planner"]) });
        let text = markdown(&[report(), own]);
        let [papers, beyond] = ["## [WCPSO]", "## Beyond the papers"].map(|heading| text.find(heading).unwrap());
        assert!(papers < beyond && text[beyond..].contains("a-star"), "{text}");
        assert!(!markdown(&[report()]).contains("Beyond"));
    }

    #[test]
    fn every_reproduction_is_of_a_paper_that_the_document_has() {
        for reproduction in REPRODUCTIONS {
            assert!(papers::find(papers::tag(reproduction.source)).is_some(), "{}", reproduction.source);
        }
    }
}
