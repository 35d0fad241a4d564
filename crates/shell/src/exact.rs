//! `forage exact`.

use std::process::ExitCode;

use forage::{
    Scene,
    arm::ArmScene,
    exact::{AmongCuboids, MAX_EXACT_CUBOIDS, MAX_EXACT_STOPS, shortest_among_cuboids},
    kernel::{ReferenceOptimum, TourEnds},
    scene::{ARM, FUNCTION, GRID, MAX_EXACT_CELLS, TourScene},
};
use serde::Serialize;

use super::{
    failure::Outcome,
    load,
    output::{print, print_json},
    text::{escape, measured, number},
};

#[derive(Serialize)]
struct Answer<'a> {
    length: Option<f64>,
    path: Points<'a>,
    /// On grids: the shortest path from cell to neighbouring cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    cells: Option<CellPath<'a>>,
    /// In scenes with stops: the shortest tours.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    tours: Vec<Tour<'a>>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Points<'a> {
    Plane(&'a [[f64; 2]]),
    Space(&'a [[f64; 3]]),
}

#[derive(Serialize)]
struct CellPath<'a> {
    length: f64,
    path: &'a [[f64; 2]],
}

#[derive(Serialize)]
struct Tour<'a> {
    by: ReferenceOptimum,
    length: f64,
    order: &'a [usize],
    path: &'a [[f64; 2]],
}

pub(super) fn exact(scene: &str, json: bool) -> Outcome {
    let scene = load::scene(scene)?;
    let path = scene.exact().map_or(Points::Plane(&[]), |exact| match scene.kind() {
        ARM => Points::Space(&exact.tip_path),
        _ => Points::Plane(&exact.path),
    });
    let cells = (scene.kind() == GRID).then(|| scene.exact_by(ReferenceOptimum::Cells)).flatten();
    let answer = Answer {
        length: scene.optimum(ReferenceOptimum::AnyAngle),
        path,
        cells: cells.map(|exact| CellPath { length: exact.length, path: &exact.path }),
        tours: tours(&scene),
    };
    if json {
        print_json(&answer)?;
    } else {
        print(&summary(&scene, &answer))?;
    }
    let found = answer.length.is_some() || answer.cells.is_some() || !answer.tours.is_empty();
    Ok(ExitCode::from(u8::from(!found)))
}

/// The shortest tours by each rule that applies to a scene.
fn tours(scene: &Scene) -> Vec<Tour<'_>> {
    let (rules, ends): (&[_], _) = match scene.get::<TourScene>() {
        Ok(tour) => (&[ReferenceOptimum::Matrix], tour.ends()),
        Err(_) => (&[ReferenceOptimum::AnyAngle, ReferenceOptimum::Cells], TourEnds::Closed),
    };
    let tour = |&by: &ReferenceOptimum| {
        let exact = scene.exact_tour(by, ends)?;
        let by = if exact.stored { ReferenceOptimum::Stored } else { by };
        Some(Tour { by, length: exact.length, order: &exact.order, path: &exact.path })
    };
    rules.iter().filter_map(tour).collect()
}

/// The unit of a scene's lengths, to be written after a number; empty if there is none.
pub(super) fn unit(scene: &Scene) -> &str {
    match scene.header().units.as_deref() {
        Some("metres, degrees") => "m",
        None | Some("unitless") => "",
        Some(unit) => unit,
    }
}

fn summary(scene: &Scene, answer: &Answer<'_>) -> String {
    let unit = escape(unit(scene));
    let length = |length: f64| measured(length, &unit);
    let mut lines = Vec::new();
    let stored = scene.exact().is_some_and(|exact| exact.stored);
    match (answer.length, &answer.path, &answer.cells) {
        (Some(found), _, _) if stored => lines.push(format!("shortest path {}, stated in the scene file", length(found))),
        (Some(found), Points::Space(path), _) => {
            lines.push(format!("shortest path of the tool tip {}, {} points", length(found), path.len()));
        }
        (Some(found), Points::Plane([]), _) => {
            let stated = scene.minimum().is_some_and(|minimum| minimum.stated);
            lines.push(format!("minimum {}{}", number(found), if stated { ", stated in the scene file" } else { "" }));
        }
        (Some(found), Points::Plane(path), cells) => {
            lines.push(format!("shortest path {}, {} points", length(found), path.len()));
            lines.extend(cells.as_ref().map(|cells| format!("shortest path from cell to cell {}", length(cells.length))));
        }
        (None, _, Some(cells)) => lines.push(format!(
            "shortest path from cell to cell {}; the any-angle path is not computed for more than {MAX_EXACT_CELLS} cells",
            length(cells.length)
        )),
        (None, _, None) if answer.tours.is_empty() || scene.ends().is_some() => lines.push(no_path(scene)),
        (None, _, None) => {}
    }
    lines.extend(answer.tours.iter().map(|tour| tour_line(tour, &length(tour.length))));
    let name = escape(scene.name());
    lines.iter().map(|line| format!("{name}: {line}")).collect::<Vec<_>>().join("\n")
}

fn tour_line(tour: &Tour<'_>, length: &str) -> String {
    let by = match tour.by {
        ReferenceOptimum::AnyAngle => "with any-angle paths",
        ReferenceOptimum::Cells => "from cell to cell",
        ReferenceOptimum::Matrix => "by the scene’s distances",
        ReferenceOptimum::Stored | ReferenceOptimum::Refuted => "stated in the scene file",
    };
    let stops: Vec<_> = tour.order.iter().map(usize::to_string).collect();
    format!("shortest tour {length} {by}, stops {}", stops.join(" "))
}

/// Why there is no exact path.
fn no_path(scene: &Scene) -> String {
    const NONE: &str = "there is no path from start to goal";
    match scene.get::<ArmScene>() {
        Ok(arm) => match shortest_among_cuboids(&arm.workspace, arm.start, arm.goal, &arm.cuboids) {
            AmongCuboids::NotComputed if arm.cuboids.len() > MAX_EXACT_CUBOIDS => {
                format!("not computed for more than {MAX_EXACT_CUBOIDS} cuboids")
            }
            AmongCuboids::NotComputed => "not computed: these cuboids would take too long".to_owned(),
            _ => NONE.to_owned(),
        },
        _ if scene.ends().is_some() => NONE.to_owned(),
        _ if scene.kind() == FUNCTION => "the minimum of this function is not known".to_owned(),
        _ => no_tour(scene.stops().len()),
    }
}

/// Why there is no exact tour.
fn no_tour(stops: usize) -> String {
    match stops {
        0 => "there are no stops, and start and goal are missing".to_owned(),
        1 => "a tour needs at least two stops".to_owned(),
        2..=MAX_EXACT_STOPS => "there is no tour: some stop cannot be reached from the others".to_owned(),
        _ => format!("not computed for more than {MAX_EXACT_STOPS} stops; this scene has {stops}"),
    }
}
