//! `forage exact`.

use std::process::ExitCode;

use serde::Serialize;

use super::{Outcome, load, print, print_json};

#[derive(Serialize)]
struct Answer<'a> {
    length: Option<f64>,
    path: &'a [[f64; 2]],
}

pub(super) fn exact(scene: &str, json: bool) -> Outcome {
    let scene = load::scene(scene)?;
    let answer = Answer { length: scene.optimum(), path: scene.exact().map_or(&[], |exact| &exact.path) };
    if json {
        print_json(&answer);
    } else {
        match answer.length {
            Some(length) if answer.path.is_empty() => print(&format!("{}: minimum {length}", scene.name())),
            Some(length) => print(&format!("{}: shortest path {length}, {} points", scene.name(), answer.path.len())),
            None => print(&format!("{}: there is no way from start to goal", scene.name())),
        }
    }
    Ok(if answer.length.is_some() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
