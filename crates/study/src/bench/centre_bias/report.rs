//! Each planner's centre bias: a table, a report with a plot, and the ratios as CSV.

use std::{
    fmt::Write as _,
    path::{Path, PathBuf},
};

use forage::statistics::Summary;

use super::{
    super::{
        super::{
            disk,
            failure::{Failure, at},
            plot::{self, Bar},
            table::{Cell, Table, digits},
        },
        suite::distinct,
        targets,
    },
    form::Form,
    measure::{Ratio, ratio},
    row::Row,
};

/// The file of ratios: the catalogue's is one.
const RATIOS: &str = "centre-bias.csv";

fn contenders(rows: &[Row]) -> Vec<String> {
    distinct(rows.iter().map(Row::contender))
}

fn of<'a>(rows: &'a [Row], contender: &str) -> Vec<&'a Row> {
    rows.iter().filter(|row| row.contender() == contender).collect()
}

fn cells(ratio: Option<Ratio>) -> [Cell; 3] {
    let end = |k: usize| ratio.and_then(|ratio| Some(ratio.interval?[k]));
    [ratio.map(|ratio| ratio.value), end(0), end(1)].map(|number| Cell::significant(number, 3))
}

fn ratios(rows: &[Row]) -> Table {
    let columns = ["planner", "shifted : centred", "shifted from", "shifted to", "rotated : centred", "rotated from", "rotated to"];
    let title = "Gap on shifted and on rotated functions as a multiple of that on centred ones, with 95 % intervals";
    let mut table = Table::new("centre-bias", title, &columns);
    for contender in contenders(rows) {
        let own = of(rows, &contender);
        let [shifted, rotated] = [Form::Shifted, Form::Rotated].map(|form| cells(ratio(&own, form)));
        table.rows.push([Cell::Text(contender)].into_iter().chain(shifted).chain(rotated).collect());
    }
    table
}

/// The table that is printed.
pub(super) fn table(rows: &[Row]) -> Table {
    ratios(rows)
}

/// The median gap in the end by planner and form on a function, and how many runs were solved.
fn gaps(rows: &[Row], function: &str) -> Table {
    let names: Vec<[String; 2]> = Form::ALL.iter().map(|form| [form.name().to_owned(), "solved".to_owned()]).collect();
    let columns: Vec<&str> = ["planner"].into_iter().chain(names.iter().flatten().map(String::as_str)).collect();
    let title = format!("Median gap in the end on {function}, and how many runs were solved");
    let mut table = Table::new(function, title, &columns);
    for contender in contenders(rows) {
        let own: Vec<&Row> = of(rows, &contender).into_iter().filter(|row| row.function == function).collect();
        let of_form = |form: Form| {
            let gaps: Vec<f64> = own.iter().filter(|row| row.form == form).map(|row| row.gap).collect();
            let solved = gaps.iter().filter(|gap| **gap <= targets::FINAL).count();
            let median = Summary::of(gaps.iter().copied()).map(|gaps| gaps.median);
            [Cell::significant(median, 3), Cell::Text(format!("{solved} of {}", gaps.len()))]
        };
        let cells = Form::ALL.into_iter().flat_map(of_form);
        table.rows.push([Cell::Text(contender.clone())].into_iter().chain(cells).collect());
    }
    table
}

/// The ratios with all their digits.
fn file(rows: &[Row]) -> String {
    let mut text = String::from("planner,shifted,shifted_from,shifted_to,rotated,rotated_from,rotated_to\n");
    for contender in contenders(rows) {
        let own = of(rows, &contender);
        let found = [Form::Shifted, Form::Rotated].map(|form| ratio(&own, form));
        let numbers = found.iter().flat_map(|ratio| {
            let [from, to] = [0, 1].map(|k| ratio.and_then(|ratio| Some(ratio.interval?[k])));
            [ratio.map(|ratio| ratio.value), from, to].map(|number| number.map_or(String::new(), digits))
        });
        text.push_str(&[contender].into_iter().chain(numbers).collect::<Vec<_>>().join(","));
        text.push('\n');
    }
    text
}

/// Writes the report, its picture and the file of ratios.
pub(super) fn write(rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let [report, picture, file_of_ratios] = ["report.md", "shifted.svg", RATIOS].map(|name| folder.join(name));
    let bar = |name: String| {
        let Ratio { value, interval } = ratio(&of(rows, &name), Form::Shifted)?;
        Some(Bar { name, value, interval })
    };
    let bars: Vec<Bar> = contenders(rows).into_iter().filter_map(bar).collect();
    plot::draw_ratios(&picture, "gap on shifted functions : gap on centred ones", &bars)?;
    disk::write(&file_of_ratios, file(rows)).map_err(at(&file_of_ratios))?;
    let budgets = distinct(rows.iter().map(|row| (row.budget / row.dimension.max(1) as u64).to_string()));
    let dimensions = distinct(rows.iter().map(|row| row.dimension.to_string()));
    let mut text = String::from("# centre-bias\n\n");
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{} runs in {} variables, at most {} evaluations for each; a run is over when it is {:e} above the minimum. Each function has its \
         minimum in the middle of the search box (centred), anywhere within four fifths of half a side (shifted), or in the middle with its \
         axes turned (rotated). A gap is how far above the minimum the best is, averaged by its logarithm over the evaluations and, between \
         runs of the same seed, over instances and functions. Above 1 in the first column, a planner is biased to the centre, or needs more \
         where the minimum is nearer to a border; random search shows how much of the latter there is. Above 1 in the second one, it \
         depends on the axes.\n",
        rows.len(),
        dimensions.join(" or "),
        budgets.join(" or "),
        targets::FINAL,
    );
    text.push_str(&ratios(rows).markdown());
    text.push_str("\n![Ratio of gaps for each planner, with 95 % intervals](shifted.svg)\n");
    for function in distinct(rows.iter().map(|row| row.function.clone())) {
        text.push('\n');
        text.push_str(&gaps(rows, &function).markdown());
    }
    disk::write(&report, text).map_err(at(&report))?;
    Ok(vec![report, picture, file_of_ratios])
}
