//! `forage exact`.

use std::process::ExitCode;

use forage::{
    Scene,
    arm::ArmScene,
    exact::{AmongCuboids, MAX_EXACT_CUBOIDS, MAX_EXACT_STOPS, shortest_among_cuboids},
    kernel::{Message, ReferenceOptimum, TourEnds},
    message,
    scene::{ARM, FUNCTION, GRID, MAX_EXACT_CELLS, TourScene},
};
use serde::Serialize;

use super::{
    failure::Outcome,
    language::say,
    load,
    output::{print, print_json},
    text::{self, escape, measured, number},
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
    let unit = escape(say(unit(scene), &format!("scenes.{}.units", scene.name())));
    let length = |length: f64| measured(length, &unit);
    let stored = scene.exact().is_some_and(|exact| exact.stored);
    let mut lines = paths(scene, answer, stored, &length);
    lines.extend(answer.tours.iter().map(|tour| tour_line(tour, &length(tour.length))));
    let name = escape(scene.name());
    lines.into_iter().map(|line| text::at(&name, &line).to_string()).collect::<Vec<_>>().join("\n")
}

/// What is said of the shortest path, or of the minimum.
fn paths(scene: &Scene, answer: &Answer<'_>, stored: bool, length: &dyn Fn(f64) -> String) -> Vec<Message> {
    let by_cells = |cells: &CellPath<'_>| {
        message!("shell-shortest-cell-path", "shortest path from cell to cell {length}", length = length(cells.length))
    };
    let shortest =
        |found, points| message!("shell-shortest-path", "shortest path {length}, {points} points", length = length(found), points);
    match (answer.length, &answer.path, &answer.cells) {
        (Some(found), _, _) if stored => {
            vec![message!("shell-shortest-path-stated", "shortest path {length}, stated in the scene file", length = length(found))]
        }
        (Some(found), Points::Space(path), _) => {
            let (length, points) = (length(found), path.len());
            vec![message!("shell-shortest-tip-path", "shortest path of the tool tip {length}, {points} points", length, points)]
        }
        (Some(found), Points::Plane([]), _) => {
            let value = number(found);
            vec![if scene.minimum().is_some_and(|minimum| minimum.stated) {
                message!("shell-minimum-stated", "minimum {value}, stated in the scene file", value)
            } else {
                message!("shell-minimum", "minimum {value}", value)
            }]
        }
        (Some(found), Points::Plane(path), cells) => {
            [shortest(found, path.len())].into_iter().chain(cells.as_ref().map(by_cells)).collect()
        }
        (None, _, Some(cells)) => vec![message!(
            "shell-only-cell-path",
            "shortest path from cell to cell {length}; the any-angle path is not computed for more than {most} cells",
            length = length(cells.length),
            most = MAX_EXACT_CELLS
        )],
        (None, _, None) if answer.tours.is_empty() || scene.ends().is_some() => vec![no_path(scene)],
        (None, _, None) => Vec::new(),
    }
}

fn tour_line(tour: &Tour<'_>, length: &str) -> Message {
    let stops = tour.order.iter().map(usize::to_string).collect::<Vec<_>>().join(" ");
    match tour.by {
        ReferenceOptimum::AnyAngle => {
            message!("shell-tour-any-angle", "shortest tour {length} with any-angle paths, stops {stops}", length, stops)
        }
        ReferenceOptimum::Cells => message!("shell-tour-cells", "shortest tour {length} from cell to cell, stops {stops}", length, stops),
        ReferenceOptimum::Matrix => {
            message!("shell-tour-matrix", "shortest tour {length} by the scene’s distances, stops {stops}", length, stops)
        }
        ReferenceOptimum::Stored | ReferenceOptimum::Refuted => {
            message!("shell-tour-stated", "shortest tour {length} stated in the scene file, stops {stops}", length, stops)
        }
    }
}

/// Why there is no exact path.
fn no_path(scene: &Scene) -> Message {
    let none = || message!("shell-no-path", "there is no path from start to goal");
    match scene.get::<ArmScene>() {
        Ok(arm) => match shortest_among_cuboids(&arm.workspace, arm.start, arm.goal, &arm.cuboids) {
            AmongCuboids::NotComputed if arm.cuboids.len() > MAX_EXACT_CUBOIDS => {
                message!("shell-too-many-cuboids", "not computed for more than {most} cuboids", most = MAX_EXACT_CUBOIDS)
            }
            AmongCuboids::NotComputed => message!("shell-cuboids-too-slow", "not computed: these cuboids would take too long"),
            _ => none(),
        },
        _ if scene.ends().is_some() => none(),
        _ if scene.kind() == FUNCTION => message!("shell-minimum-unknown", "the minimum of this function is not known"),
        _ => no_tour(scene.stops().len()),
    }
}

/// Why there is no exact tour.
fn no_tour(stops: usize) -> Message {
    match stops {
        0 => message!("shell-no-stops", "there are no stops, and start and goal are missing"),
        1 => message!("shell-one-stop", "a tour needs at least two stops"),
        2..=MAX_EXACT_STOPS => message!("shell-no-tour", "there is no tour: some stop cannot be reached from the others"),
        _ => message!(
            "shell-too-many-stops",
            "not computed for more than {most} stops; this scene has {stops}",
            most = MAX_EXACT_STOPS,
            stops
        ),
    }
}
