//! `forage exact`.

use std::process::ExitCode;

use forage::{
    exact::Exact,
    planner::Yardstick,
    scene::{Body, MAX_EXACT_CELLS},
};
use serde::Serialize;

use super::{Outcome, load, print, print_json};

#[derive(Serialize)]
struct Answer<'a> {
    length: Option<f64>,
    path: &'a [[f64; 2]],
    /// On grids: the same from cell to neighbouring cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    cells: Option<Way<'a>>,
}

#[derive(Serialize)]
struct Way<'a> {
    length: f64,
    path: &'a [[f64; 2]],
}

pub(super) fn exact(scene: &str, json: bool) -> Outcome {
    let scene = load::scene(scene)?;
    let path = |exact: Option<&'_ Exact>| -> Vec<[f64; 2]> { exact.map_or_else(Vec::new, |exact| exact.path.clone()) };
    let any_angle = path(scene.exact());
    let cells = matches!(scene.body(), Body::Grid(_)).then(|| scene.exact_by(Yardstick::Cells)).flatten();
    let answer = Answer {
        length: scene.optimum(Yardstick::AnyAngle),
        path: &any_angle,
        cells: cells.map(|exact| Way { length: exact.length, path: &exact.path }),
    };
    if json {
        print_json(&answer);
    } else {
        match answer.length {
            Some(length) if answer.path.is_empty() => print(&format!("{}: minimum {length}", scene.name())),
            Some(length) => {
                let over_cells = answer.cells.as_ref().map(|way| format!("; from cell to cell {}", way.length)).unwrap_or_default();
                print(&format!("{}: shortest path {length}, {} points{over_cells}", scene.name(), answer.path.len()));
            }
            None => match &answer.cells {
                Some(way) => print(&format!(
                    "{}: from cell to cell {}; at any angle not computed, there are more than {MAX_EXACT_CELLS} cells",
                    scene.name(),
                    way.length
                )),
                None => print(&format!("{}: there is no way from start to goal", scene.name())),
            },
        }
    }
    Ok(if answer.length.is_some() || answer.cells.is_some() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
