//! Files in the format `bbob-new2` of COCO’s observer, without positions: `cocopp FOLDER` makes a report of them.

use std::{collections::BTreeMap, fmt::Write as _, path::Path};

use forage::{math, scene::FunctionScene};

use super::{
    super::{
        super::disk,
        super::failure::{Failure, at},
        suite::safe_file_name,
        targets,
    },
    row::Row,
};

/// In steps of a fifth of a decade a line is written when the best falls below the next one.
const STEPS: f64 = 5.0;

/// As C prints it: two digits of exponent at least, and its sign.
fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:+.digits$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (sign, exponent) = exponent.strip_prefix('-').map_or(('+', exponent), |exponent| ('-', exponent));
    format!("{mantissa}e{sign}{exponent:0>2}")
}

/// What stands before the data of a run.
fn head(minimum: f64) -> String {
    let minimum = number(minimum, 12);
    let minimum = minimum.trim_start_matches('+');
    format!(
        "% f evaluations | g evaluations | best noise-free fitness - Fopt ({minimum}) + sum g_i+ | measured fitness | best measured fitness"
    )
}

/// A line of data; where it is not an improvement, the measured value is the best so far.
fn line(out: &mut String, evaluations: u64, gap: f64, minimum: f64) {
    let value = number(gap + minimum, 9);
    // Writing to a text cannot fail.
    let _ = writeln!(out, "{evaluations} 0 {} {value} {value}", number(gap, 9));
}

/// Where the best falls below the next fifth of a decade, and the end.
fn by_values(improvements: &[(u64, f64)], end: u64, minimum: f64, out: &mut String) {
    let level = |gap: f64| (STEPS * math::log10(gap.max(targets::FINAL))).ceil();
    let mut next = f64::INFINITY;
    let mut written = 0;
    for &(at, gap) in improvements {
        if level(gap) < next {
            next = level(gap);
            written = at;
            line(out, at, gap, minimum);
        }
    }
    if let Some(&(_, gap)) = improvements.last().filter(|_| written < end) {
        line(out, end, gap, minimum);
    }
}

/// At numbers of evaluations that are spread evenly, by the logarithm.
fn by_evaluations(improvements: &[(u64, f64)], dimension: usize, end: u64, minimum: f64, out: &mut String) {
    let twentieths = (0..=240).map(|k| math::pow(10.0, f64::from(k) / 20.0).floor() as u64);
    let rounds = (0..12).flat_map(|k| [1, 2, 5].map(|factor| factor * dimension as u64 * 10_u64.pow(k)));
    let mut all: Vec<u64> = twentieths.chain(rounds).filter(|at| *at < end).chain([end]).collect();
    all.sort_unstable();
    all.dedup();
    for at in all {
        let before = improvements.partition_point(|(found, _)| *found <= at);
        if let Some(&(_, gap)) = before.checked_sub(1).and_then(|last| improvements.get(last)) {
            line(out, at, gap, minimum);
        }
    }
}

/// Writes a folder for each planner.
pub(super) fn write(rows: &[Row], folder: &Path) -> Result<(), Failure> {
    let mut infos: BTreeMap<(String, usize), String> = BTreeMap::new();
    let mut groups: BTreeMap<(String, usize, usize), Vec<&Row>> = BTreeMap::new();
    for row in rows {
        groups.entry((row.contender(), row.function, row.dimension)).or_default().push(row);
    }
    for ((contender, function, dimension), rows) in groups {
        let own = folder.join(safe_file_name(&contender));
        let data = format!("data_f{function}");
        let stem = format!("bbobexp_f{function}_DIM{dimension}");
        disk::make_folder(&own.join(&data)).map_err(at(&own))?;
        let (mut values, mut evaluations) = (String::new(), String::new());
        let info = infos.entry((contender.clone(), function)).or_default();
        let _ = write!(
            info,
            "suite = 'bbob', funcId = {function}, DIM = {dimension}, Precision = 1.000e-08, algId = '{contender}', \
             logger = 'forage-{version}', data_format = 'bbob-new2'\n% written by forage bench\n{data}/{stem}.dat",
            version = env!("CARGO_PKG_VERSION"),
        );
        for row in rows {
            let improvements = row.improvements();
            let minimum = FunctionScene::bbob(function, row.instance, dimension)?.minimum().map_or(0.0, |minimum| minimum.value);
            for (out, what) in [(&mut values, true), (&mut evaluations, false)] {
                let _ = writeln!(out, "{}", head(minimum));
                if what {
                    by_values(&improvements, row.evaluations, minimum, out);
                } else {
                    by_evaluations(&improvements, dimension, row.evaluations, minimum, out);
                }
            }
            let _ = write!(info, ", {}:{}|{}", row.instance, row.evaluations, number(row.gap, 1).trim_start_matches('+'));
        }
        info.push('\n');
        for (ending, text) in [("dat", values), ("tdat", evaluations)] {
            let path = own.join(&data).join(format!("{stem}.{ending}"));
            disk::write(&path, text).map_err(at(&path))?;
        }
    }
    for ((contender, function), info) in infos {
        let path = folder.join(safe_file_name(&contender)).join(format!("bbobexp_f{function}.info"));
        disk::write(&path, info).map_err(at(&path))?;
    }
    Ok(())
}
