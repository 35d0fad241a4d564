//! `forage list`: an overview, or a page about one planner, generator, scene, the drive or the arm's motion.

mod entry;
mod page;
mod words;

// Its messages are listed, too.
use forage_script as _;
use std::{fmt::Write, process::ExitCode};

use crate::registry::registry;

use forage::{
    Scene,
    kernel::message::sentences,
    types::{Declarations, declarations},
};

use super::{
    args::ListArgs,
    convert::describe,
    failure::{Failure, Outcome},
    help, names,
    output::{print, print_json, print_raw},
    text::{columns, cut_list, escape, fit, quoted, wrap},
};

use words::{family, kinds};

pub(super) fn list(args: &ListArgs) -> Outcome {
    match &args.name {
        None if args.types => print(&declarations(Declarations::with::<forage_formats::Imported>))?,
        None if args.messages => print_json(&sentences())?,
        None if args.texts => print_json(&help::texts())?,
        None if args.json => print_json(&registry().catalogue())?,
        None => print(&overview(columns()))?,
        Some(name) => {
            let known = names::pages();
            if !known.contains(&name.as_str()) {
                return Err(unknown(name, &known));
            }
            if args.json {
                print_raw(entry::json(name).as_bytes())?;
            } else {
                print(&page::page(name, columns()))?;
            }
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn unknown(name: &str, known: &[&str]) -> Failure {
    let near: Vec<_> = names::nearest(name, known).iter().map(|name| format!("`{name}`")).collect();
    let near =
        if near.is_empty() { format!("it must be one of {}", cut_list(known, 80)) } else { format!("did you mean {}?", near.join(" or ")) };
    let end = if near.ends_with('?') { "" } else { ";" };
    Failure::Refused(format!("{} is not a planner, generator or scene; {near}{end} `forage list` shows all names", quoted(name)))
}

/// A line: name, title, and where it applies.
struct Line {
    name: String,
    title: String,
    note: String,
}

/// All names, grouped, one line each.
fn overview(columns: usize) -> String {
    let groups = groups();
    let width = |part: fn(&Line) -> &String| groups.iter().flat_map(|(_, lines)| lines).map(|line| part(line).chars().count()).max();
    let [name, title, note] =
        [width(|line| &line.name), width(|line| &line.title), width(|line| &line.note)].map(Option::unwrap_or_default);
    // Where the terminal is narrow, titles are cut; names never are.
    let title = title.min(columns.saturating_sub(name + note + 6)).max(12);
    let mut text = String::new();
    for (heading, lines) in groups {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{heading}");
        for line in lines {
            let shown = format!("  {:name$}  {:title$}  {}", line.name, fit(&line.title, title), line.note);
            let _ = writeln!(text, "{}", fit(shown.trim_end(), columns));
        }
        text.push('\n');
    }
    text + &wrap("`forage list NAME` shows a page with all parameters and an example.", columns, 0)
}

fn groups() -> Vec<(String, Vec<Line>)> {
    let mut groups: Vec<(String, Vec<Line>)> = Vec::new();
    let mut add = |heading: String, line: Line| match groups.iter_mut().find(|(known, _)| *known == heading) {
        Some((_, lines)) => lines.push(line),
        None => groups.push((heading, vec![line])),
    };
    for entry in registry().planners() {
        let line = Line { name: entry.name.to_owned(), title: entry.title.to_owned(), note: kinds(entry) };
        add(format!("Planners: {}", family(entry)), line);
    }
    for generator in registry().generators() {
        let line = Line { name: generator.name.to_owned(), title: generator.title.to_owned(), note: generator.kind.name().to_owned() };
        add("Generators of random scenes".to_owned(), line);
    }
    for follower in registry().followers() {
        let line = Line { name: follower.name.to_owned(), title: follower.title.to_owned(), note: follower.kind.name().to_owned() };
        add("Following a path".to_owned(), line);
    }
    for scene in registry().scenes() {
        let description = describe(scene);
        let size = description.split_once(", ").map_or("", |(_, size)| size).to_owned();
        let line = Line { name: scene.name().to_owned(), title: escape(&scene.header().title).into_owned(), note: size };
        add(format!("Scenes: {}", scene_heading(scene)), line);
    }
    groups
}

fn scene_heading(scene: &Scene) -> &'static str {
    registry().kinds().iter().find(|kind| kind.id == scene.kind()).map_or("others", |kind| kind.title)
}
