//! `forage exact`.

use std::process::ExitCode;

use forage::{
    Scene,
    exact::{Exact, MAX_EXACT_STOPS},
    planner::{Round, Yardstick},
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
    /// Of a scene with stops: the shortest tours through them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    tours: Vec<Tour<'a>>,
}

#[derive(Serialize)]
struct Tour<'a> {
    by: Yardstick,
    length: f64,
    order: &'a [usize],
    path: &'a [[f64; 2]],
}

/// The shortest tours by each rule that there is for a scene.
fn tours(scene: &Scene) -> Vec<Tour<'_>> {
    let (rules, round): (&[_], _) = match scene.body() {
        Body::Grid(_) => (&[Yardstick::AnyAngle, Yardstick::Cells], Round::Closed),
        Body::Tour(tour) => (&[Yardstick::Matrix], tour.round()),
        _ => (&[], Round::Closed),
    };
    let tour = |&by: &Yardstick| {
        let exact = scene.exact_tour(by, round)?;
        let by = if exact.stored { Yardstick::Stored } else { by };
        Some(Tour { by, length: exact.length, order: &exact.order, path: &exact.path })
    };
    rules.iter().filter_map(tour).collect()
}

/// Why there is no exact tour.
fn no_tour(stops: usize) -> String {
    match stops {
        0 | 1 => "one stop makes no tour".to_owned(),
        2..=MAX_EXACT_STOPS => "there is no tour: some stop cannot be reached from the others".to_owned(),
        _ => format!("{stops} stops, and a shortest tour is computed for {MAX_EXACT_STOPS} at most"),
    }
}

fn told(tour: &Tour<'_>) -> String {
    let by = match tour.by {
        Yardstick::AnyAngle => "at any angle",
        Yardstick::Cells => "from cell to cell",
        Yardstick::Matrix => "by the scene’s distances",
        Yardstick::Stored | Yardstick::Refuted => "as the scene’s file says",
    };
    let stops: Vec<_> = tour.order.iter().map(usize::to_string).collect();
    format!("shortest tour {} {by}, through the stops {}", tour.length, stops.join(" "))
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
        tours: tours(&scene),
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
                None if scene.ends().is_some() => print(&format!("{}: there is no way from start to goal", scene.name())),
                None if answer.tours.is_empty() => print(&format!("{}: {}", scene.name(), no_tour(scene.stops().len()))),
                None => {}
            },
        }
        answer.tours.iter().for_each(|tour| print(&format!("{}: {}", scene.name(), told(tour))));
    }
    Ok(if answer.length.is_some() || answer.cells.is_some() || !answer.tours.is_empty() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
