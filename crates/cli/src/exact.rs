//! `forage exact`.

use std::process::ExitCode;

use forage::{
    Scene,
    exact::{AmongCuboids, MAX_EXACT_CUBOIDS, MAX_EXACT_STOPS, shortest_among_cuboids},
    planner::{Round, Yardstick},
    scene::{Body, MAX_EXACT_CELLS},
};
use serde::Serialize;

use super::{Outcome, load, print, print_json};

#[derive(Serialize)]
struct Answer<'a> {
    length: Option<f64>,
    path: Course<'a>,
    /// On grids: the same from cell to neighbouring cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    cells: Option<Way<'a>>,
    /// Of a scene with stops: the shortest tours through them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    tours: Vec<Tour<'a>>,
}

/// A path's points.
#[derive(Serialize)]
#[serde(untagged)]
enum Course<'a> {
    Plane(&'a [[f64; 2]]),
    Space(&'a [[f64; 3]]),
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

/// Why there is no exact path.
fn no_path(scene: &Scene) -> String {
    match scene.body() {
        Body::Arm(arm) => match shortest_among_cuboids(&arm.workspace, arm.start, arm.goal, &arm.cuboids) {
            AmongCuboids::NotComputed if arm.cuboids.len() > MAX_EXACT_CUBOIDS => {
                format!("not computed, there are more than {MAX_EXACT_CUBOIDS} cuboids")
            }
            AmongCuboids::NotComputed => "not computed, these cuboids are too much for it".to_owned(),
            _ => "there is no way from start to goal".to_owned(),
        },
        _ if scene.ends().is_some() => "there is no way from start to goal".to_owned(),
        _ => no_tour(scene.stops().len()),
    }
}

pub(super) fn exact(scene: &str, json: bool) -> Outcome {
    let scene = load::scene(scene)?;
    let found = scene.exact();
    let course = found.map_or(Course::Plane(&[]), |exact| match scene.body() {
        Body::Arm(_) => Course::Space(&exact.tip_path),
        _ => Course::Plane(&exact.path),
    });
    let cells = matches!(scene.body(), Body::Grid(_)).then(|| scene.exact_by(Yardstick::Cells)).flatten();
    let answer = Answer {
        length: scene.optimum(Yardstick::AnyAngle),
        path: course,
        cells: cells.map(|exact| Way { length: exact.length, path: &exact.path }),
        tours: tours(&scene),
    };
    if json {
        print_json(&answer);
    } else {
        tell(&scene, &answer);
    }
    Ok(if answer.length.is_some() || answer.cells.is_some() || !answer.tours.is_empty() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

fn tell(scene: &Scene, answer: &Answer<'_>) {
    let name = scene.name();
    let stored = scene.exact().is_some_and(|exact| exact.stored);
    match (answer.length, &answer.path, &answer.cells) {
        (Some(length), _, _) if stored => print(&format!("{name}: shortest path {length}, as the scene’s file says")),
        (Some(length), Course::Space(path), _) => print(&format!("{name}: the tip’s shortest path {length}, {} points", path.len())),
        (Some(length), Course::Plane([]), _) => print(&format!("{name}: minimum {length}")),
        (Some(length), Course::Plane(path), cells) => {
            let over_cells = cells.as_ref().map(|way| format!("; from cell to cell {}", way.length)).unwrap_or_default();
            print(&format!("{name}: shortest path {length}, {} points{over_cells}", path.len()));
        }
        (None, _, Some(way)) => print(&format!(
            "{name}: from cell to cell {}; at any angle not computed, there are more than {MAX_EXACT_CELLS} cells",
            way.length
        )),
        (None, _, None) if answer.tours.is_empty() || scene.ends().is_some() => print(&format!("{name}: {}", no_path(scene))),
        (None, _, None) => {}
    }
    answer.tours.iter().for_each(|tour| print(&format!("{name}: {}", told(tour))));
}
