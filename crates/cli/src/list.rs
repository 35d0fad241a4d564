//! `forage list`, and the part of the help that follows from the catalogue.

use std::fmt::Write;

use forage::{arm, catalogue, catalogue::PLANNERS, drive, scene::Kind, shipped_names};

use super::{print, print_json};

pub(super) fn list(json: bool) {
    if json {
        print_json(&catalogue());
        return;
    }
    let mut text = String::from("PLANNERS\n");
    for entry in PLANNERS {
        let kinds: Vec<_> = entry.kinds.iter().map(|kind| kind.name()).collect();
        let _ = writeln!(text, "\n{}  {} {}\n  {}\n  runs on: {}", entry.name, entry.title, entry.source, entry.summary, kinds.join(", "));
        for parameter in entry.parameters {
            let mut defaults: Vec<String> = entry
                .kinds
                .iter()
                .filter(|&&kind| parameter.applies_to(kind))
                .map(|&kind| format!("{} on {}", parameter.default_on(kind), kind.name()))
                .collect();
            if defaults.iter().all(|d| d.split(' ').next() == defaults[0].split(' ').next()) {
                let only = if parameter.kinds.is_empty() { String::new() } else { format!(", on {} only", kinds_of(parameter)) };
                defaults = vec![defaults[0].split(" on ").next().unwrap_or_default().to_owned() + &only];
            }
            let when = parameter.when.map_or(String::new(), |when| format!("; only with {}={}", when.parameter, when.value));
            let _ = writeln!(text, "    {:<16} {}; default {}{when}", parameter.name, parameter.allowed(), defaults.join(", "));
            let _ = writeln!(text, "    {:<16} {}", "", parameter.help);
        }
    }
    for (title, entry, kind) in [("DRIVE", &drive::ENTRY, Kind::Grid), ("MOTION", &arm::MOTION, Kind::Arm)] {
        let _ = writeln!(text, "\n{title} {}\n  {}", entry.source, entry.summary);
        for parameter in entry.parameters {
            let when = parameter.when.map_or(String::new(), |when| format!("; only with {}={}", when.parameter, when.value));
            let _ = writeln!(text, "    {:<16} {}; default {}{when}", parameter.name, parameter.allowed(), parameter.default_on(kind));
            let _ = writeln!(text, "    {:<16} {}", "", parameter.help);
        }
    }
    text.push_str("\nGENERATORS of random scenes\n");
    text.push_str(&super::generate::generators());
    text.push_str("\nSCENES\n\n");
    for scene in shipped_names() {
        let _ = writeln!(text, "{:<16} {:<9} {}", scene.name(), scene.kind().name(), scene.header().title);
    }
    print(&text);
}

fn kinds_of(parameter: &forage::params::Parameter) -> String {
    parameter.kinds.iter().map(|kind| kind.name()).collect::<Vec<_>>().join(", ")
}

/// Planners, scenes and examples, below the options of `forage run --help`.
pub(super) fn after_help() -> String {
    let planners: Vec<_> = PLANNERS.iter().map(|entry| entry.name).collect();
    let scenes: Vec<_> = shipped_names().map(|scene| scene.name()).collect();
    format!(
        "Planners: {}\nShipped scenes: {}\n\nExamples:\n  forage run wcpso --scene wcpso-discs\n  forage run pso --scene my.json --seed 7 --set population=40 --json\n  forage run '#v=1&planner=wcpso&scene=wcpso-discs&seed=7&at=120'",
        planners.join(", "),
        scenes.join(", ")
    )
}
