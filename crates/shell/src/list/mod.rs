//! `forage list`: an overview, or a page about one planner, generator, scene, the drive or the arm's motion.

mod entry;
mod page;

// Its messages are listed, too.
use forage_script as _;
use std::{fmt::Write, process::ExitCode};

use crate::registry::registry;

use forage::{
    Scene,
    kernel::{Message, message::sentences},
    message,
    types::{Declarations, declarations},
};

use super::{
    args::ListArgs,
    convert::size,
    failure::{Failure, Outcome},
    help, kinds,
    language::say,
    names,
    output::{print, print_json, print_raw},
    text::{columns, cut_list, escape, fit, listed, padded, quoted, wide, wrap},
};

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
    let near = names::nearest(name, known);
    let said = message!("shell-no-page", "{name} is not a planner, generator or scene", name = quoted(name));
    let hint = message!("shell-all-names", "`forage list` shows all names");
    Failure::Refused(if near.is_empty() {
        let list = cut_list(known, 80);
        names::hinted(&message!("shell-must-be-one-of", "{said}; it must be one of {list}", said, list), &hint)
    } else {
        names::meant(&said, &near).then(hint)
    })
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
    let width = |part: fn(&Line) -> &String| groups.iter().flat_map(|(_, lines)| lines).map(|line| wide(part(line))).max();
    let [name, title, note] =
        [width(|line| &line.name), width(|line| &line.title), width(|line| &line.note)].map(Option::unwrap_or_default);
    // Where the terminal is narrow, titles are cut; names never are.
    let title = title.min(columns.saturating_sub(name + note + 6)).max(12);
    let mut text = String::new();
    for (heading, lines) in groups {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{heading}");
        for line in lines {
            let shown = format!("  {}  {}  {}", padded(&line.name, name), padded(&fit(&line.title, title), title), line.note);
            let _ = writeln!(text, "{}", fit(shown.trim_end(), columns));
        }
        text.push('\n');
    }
    let more = message!("shell-list-pages", "`forage list NAME` shows a page with all parameters and an example.");
    text + &wrap(&more.text(), columns, 0)
}

fn groups() -> Vec<(String, Vec<Line>)> {
    let mut groups: Vec<(String, Vec<Line>)> = Vec::new();
    let mut add = |heading: Message, name: &str, title: &str, note: String| {
        let (heading, line) = (heading.to_string(), Line { name: name.to_owned(), title: escape(title).into_owned(), note });
        match groups.iter_mut().find(|(known, _)| *known == heading) {
            Some((_, lines)) => lines.push(line),
            None => groups.push((heading, vec![line])),
        }
    };
    for entry in registry().planners() {
        let heading = message!("shell-planners", "Planners: {family}", family = kinds::family(entry));
        let title = say(entry.title, &format!("planners.{}.title", entry.name));
        add(heading, entry.name, title, listed(&kinds::of_planner(entry)));
    }
    for generator in registry().generators() {
        let title = say(generator.title, &format!("generators.{}.title", generator.name));
        let heading = message!("shell-generators", "Generators of random scenes");
        add(heading, generator.name, title, kinds::name(generator.kind.name()));
    }
    for follower in registry().followers() {
        let title = say(follower.title, &format!("{}.title", follower.name));
        add(message!("shell-followers", "Following a path"), follower.name, title, kinds::name(follower.kind.name()));
    }
    for scene in registry().scenes() {
        let title = say(&scene.header().title, &format!("scenes.{}.title", scene.name()));
        add(scene_heading(scene), scene.name(), title, size(scene));
    }
    groups
}

fn scene_heading(scene: &Scene) -> Message {
    let kind = registry().kinds().iter().find(|kind| kind.id == scene.kind());
    kinds::scenes(scene.kind().name(), kind.map_or("", |kind| kind.title))
}
