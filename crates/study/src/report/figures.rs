//! The published figures of a report beside the computed ones, with their marks, the reasons and the commands.

use std::fmt::Write;

use super::{
    super::{
        compared::{ComparedFigure, Printed},
        marking::marked,
        marks::{Basis, Marked, Marks},
        table::{Cell, Table, significant},
    },
    Report,
};

/// A mark in a table.
fn cell<M>(marked: Option<&Marked<M>>, name: impl Fn(&M) -> &'static str) -> Cell {
    marked.map_or(Cell::Empty, |marked| name(&marked.mark).into())
}

/// A table for each of the papers' tables.
pub(super) fn tables(figures: &[ComparedFigure]) -> Vec<Table> {
    marked(figures).chunk_by(|(a, _), (b, _)| a.table == b.table).map(table).collect()
}

/// The published figures of a table and the computed ones.
fn table(figures: &[(&ComparedFigure, Marks)]) -> Table {
    let columns = [
        "row",
        "of",
        "published best",
        "published mean",
        "published std",
        "best",
        "mean",
        "std",
        "median",
        "runs",
        "value",
        "ranking",
        "basis",
        "source",
    ];
    let title = figures.first().map(|(figure, _)| figure.table.clone()).unwrap_or_default();
    let mut table = Table::new("figures", title, &columns);
    for (figure, marks) in figures {
        let number = |number: Option<f64>| Cell::significant(number, 6);
        let printed = |printed: Option<Printed>| printed.map_or(Cell::Empty, |printed| Cell::Text(printed.shown()));
        let [best, std, median] = figure.computed.spread();
        table.rows.push(vec![
            Cell::Text(figure.row.clone()),
            Cell::Text(figure.measure.clone()),
            printed(figure.published.best),
            printed(figure.published.mean),
            number(figure.published.std),
            number(best),
            number(figure.computed.mean()),
            number(std),
            number(median),
            figure.computed.count().map_or(Cell::Empty, Cell::whole),
            cell(marks.value.as_ref(), |mark| mark.name()),
            cell(marks.ranking.as_ref(), |mark| mark.name()),
            marks.basis.mark.name().into(),
            cell(marks.source.as_ref(), |mark| mark.name()),
        ]);
    }
    table
}

/// The reasons of a figure's marks, in a sentence.
fn reasons(figure: &ComparedFigure, marks: &Marks) -> String {
    let mut reasons: Vec<String> = Vec::new();
    reasons.extend(marks.value.as_ref().map(|value| value.because.clone()));
    reasons.extend(marks.ranking.as_ref().map(|ranking| ranking.because.clone()));
    reasons.extend((marks.basis.mark != Basis::Printed).then(|| marks.basis.because.clone()));
    reasons.extend(marks.source.as_ref().map(|source| source.because.clone()));
    format!("{} ({})", reasons.join("; "), figure.measure)
}

/// The figures of a report, one table after the other, each with the reasons and the commands of its rows.
pub(crate) fn figures(report: &Report) -> String {
    let mut text = String::new();
    for some in marked(&report.figures).chunk_by(|(a, _), (b, _)| a.table == b.table) {
        text += &table(some).markdown();
        text += "\nWhy, and the command that repeats the row’s first run (the others: other seeds):\n\n";
        let mut rows: Vec<(String, String, &str)> = Vec::new();
        for (figure, marks) in some {
            let because = reasons(figure, marks);
            match rows.last_mut().filter(|(row, _, command)| *row == figure.row && *command == figure.command) {
                Some((_, all, _)) => all.extend(["; ", &because]),
                None => rows.push((figure.row.clone(), because, &figure.command)),
            }
        }
        for (row, because, command) in rows {
            let _ = writeln!(text, "- {row}: {because}. `{command}`");
        }
        text += "\n";
    }
    text
}

impl Printed {
    /// As the paper has it, as near as can be.
    fn shown(&self) -> String {
        let places = format!("{:e}", self.unit).split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0);
        if (-6..=0).contains(&places) { format!("{:.*}", places.unsigned_abs() as usize, self.value) } else { significant(self.value, 7) }
    }
}
