//! A page about one planner, generator, scene, the drive or the arm's motion.

use std::fmt::Write;

use forage::{
    Scene,
    describe::{CentreBias, Entry, Follower, Generator, Ratio},
    kernel::SceneKindId,
    params::Parameter,
    scene::{ARM, GridScene},
};

use super::words::{family, kinds};
use crate::{
    convert::describe,
    exact::unit,
    registry::registry,
    text::{escape, point, wrap},
};

/// The page about a name, which must be known.
pub(super) fn page(name: &str, columns: usize) -> String {
    let mut page = Page { text: String::new(), columns };
    if let Ok(entry) = registry().planner(name) {
        planner(entry, &mut page);
    } else if let Ok(found) = registry().generator(name) {
        generator(found, &mut page);
    } else if let Ok(found) = registry().follower(name) {
        following(found, &mut page);
    } else if let Ok(found) = registry().scene(name) {
        scene(&found, &mut page);
    }
    page.text
}

struct Page {
    text: String,
    columns: usize,
}

impl Page {
    fn line(&mut self, line: &str) {
        self.text.extend([line, "\n"]);
    }

    fn paragraph(&mut self, text: &str, indent: usize) {
        let lines = wrap(text, self.columns, indent);
        self.text.extend([&*" ".repeat(indent), &lines, "\n"]);
    }

    /// A label with what it stands for.
    fn field(&mut self, label: &str, value: &str) {
        let lines = wrap(value, self.columns, 13);
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {label:<9}  {lines}");
    }

    fn heading(&mut self, heading: &str) {
        self.text.extend(["\n", heading, "\n"]);
    }

    /// A name in a column of `width`, what it is, and a paragraph about it.
    fn named(&mut self, name: &str, width: usize, title: &str, help: &str) {
        let indent = width + 4;
        let lines = wrap(title, self.columns, indent);
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {name:width$}  {lines}");
        if !help.is_empty() {
            self.paragraph(help, indent);
        }
    }

    fn parameters(&mut self, option: &str, parameters: &[&[Parameter]], kinds: &[SceneKindId]) {
        self.heading(&format!("Parameters ({option} NAME=VALUE)"));
        let width = parameters.iter().copied().flatten().map(|parameter| parameter.name.len()).max().unwrap_or(0);
        for parameter in parameters.iter().copied().flatten() {
            let range = format!("{}; default {}", parameter.allowed(), defaults(parameter, kinds));
            let condition = parameter.when.map_or(String::new(), |when| format!("; only if {}={}", when.parameter, when.value));
            self.named(parameter.name, width, &format!("{range}{condition}"), parameter.help);
        }
    }

    fn examples(&mut self, examples: &[String]) {
        self.heading(if examples.len() == 1 { "Example" } else { "Examples" });
        examples.iter().for_each(|example| self.line(&format!("  {example}")));
    }
}

/// The default, or the defaults by kind where they differ.
fn defaults(parameter: &Parameter, kinds: &[SceneKindId]) -> String {
    let on: Vec<SceneKindId> = kinds.iter().copied().filter(|&kind| parameter.applies_to(kind)).collect();
    let values: Vec<String> = on.iter().map(|&kind| parameter.default_on(kind).to_string()).collect();
    let Some(first) = values.first() else { return "none".to_owned() };
    if values.iter().any(|value| value != first) {
        let pairs: Vec<_> = values.iter().zip(&on).map(|(value, kind)| format!("{value} on {}", kind.name())).collect();
        return pairs.join(", ");
    }
    if on.len() == kinds.len() {
        return first.clone();
    }
    let names: Vec<_> = on.iter().map(|kind| kind.name()).collect();
    format!("{first}; only on {}", names.join(", "))
}

/// The centre bias of a planner, with that of random search.
fn centre_bias(bias: CentreBias) -> String {
    let shown = |ratio: Ratio| format!("{:.2} ({:.2} to {:.2})", ratio.value, ratio.from, ratio.to);
    format!(
        "With default parameters, in 10 variables and 10,000 evaluations: shifting the minimum away from the centre of the search box \
         multiplies the gap by {} (random search: {:.2}). Rotating the axes multiplies it by {}.",
        shown(bias.shifted),
        bias.random_search.value,
        shown(bias.rotated)
    )
}

fn planner(entry: &Entry, page: &mut Page) {
    page.line(&format!("{}: {}", entry.name, entry.title));
    page.field("Family", family(entry));
    page.field("Source", entry.source);
    page.field("Scenes", &kinds(entry));
    if !entry.evaluation.is_empty() {
        page.field("Evaluates", entry.evaluation);
    }
    if let Some(most) = entry.most_stops {
        page.field("Stops", &format!("at most {most}"));
    }
    page.line("");
    page.paragraph(entry.summary, 2);
    if let Some(bias) = CentreBias::of(entry.name) {
        page.heading("Centre bias (forage bench centre-bias)");
        page.paragraph(&centre_bias(bias), 2);
    }
    page.parameters("--set", entry.parameters, entry.kinds);
    if !entry.presets.is_empty() {
        page.heading("Presets (--preset NAME)");
        let width = entry.presets.iter().map(|preset| preset.name.len()).max().unwrap_or(0);
        for preset in entry.presets {
            let values: Vec<_> = preset.given().iter().map(|(name, value)| format!("{name}={value}")).collect();
            let values = if values.is_empty() { "the defaults".to_owned() } else { values.join(" ") };
            page.named(preset.name, width, &format!("{}: {values}", preset.title), preset.help);
        }
    }
    page.heading("Metrics of each iteration (`readings` in JSON; --trace FILE writes them)");
    let width = entry.readings.iter().map(|reading| reading.name.len()).max().unwrap_or(0);
    for reading in entry.readings {
        page.named(reading.name, width, &format!("{}. {}", reading.title, reading.help), "");
    }
    let scene = example_scene(entry).map_or("FILE", |scene| scene.name());
    // A tuner runs thousands of colonies with its defaults.
    let quick = if entry.family == "tuning" { " --iterations 2 --set population=4" } else { "" };
    page.examples(&[format!("forage run {} --scene {scene}{quick}", entry.name)]);
}

/// A shipped scene on which a planner finds something.
fn example_scene(entry: &Entry) -> Option<&'static Scene> {
    const FIRST: [&str; 6] = ["arm-cuboid", "wcpso-discs", "qpso-10m", "crossing", "wolf-ant-20", "ant-bat-30"];
    let preferred = FIRST.iter().filter_map(|name| registry().scenes().iter().find(|scene| scene.name() == *name));
    let drives = |scene: &Scene| entry.family != "dynamic" || scene.get::<GridScene>().is_ok_and(|grid| !grid.moving.is_empty());
    preferred.chain(registry().scenes().iter()).map(|scene| &**scene).find(|scene| entry.check_scene(scene).is_ok() && drives(scene))
}

fn generator(generator: &'static Generator, page: &mut Page) {
    page.line(&format!("{}: {}", generator.name, generator.title));
    page.field("Makes", &format!("scenes of kind {}", generator.kind.name()));
    page.line("");
    page.paragraph(generator.help, 2);
    page.parameters("--set", generator.parameters, &[generator.kind]);
    page.examples(&[format!("forage generate {0} --seed 7 --out {0}.json", generator.name)]);
}

fn following(entry: &Follower, page: &mut Page) {
    let (name, kind) = (entry.name, entry.kind);
    page.line(&format!("{name}: {}", entry.title));
    page.field("Source", entry.source);
    page.field("Scenes", kind.name());
    page.line("");
    page.paragraph(entry.summary, 2);
    page.parameters(&format!("--{name}-set"), entry.parameters, &[kind]);
    page.heading(&format!("Columns of the CSV file that --{name} FILE writes"));
    let width = entry.columns.iter().map(|column| column.name.len()).max().unwrap_or(0);
    for column in entry.columns {
        let unit = if column.unit.is_empty() { String::new() } else { format!(" ({})", column.unit) };
        page.named(column.name, width, &format!("{}{unit}", column.title), "");
    }
    let example = if kind == ARM { "run rrt-guided --scene arm-cuboid" } else { "run ltqpso --scene qpso-10m" };
    page.examples(&[format!("forage {example} --{name} {name}.csv")]);
}

fn scene(scene: &Scene, page: &mut Page) {
    let header = scene.header();
    page.line(&format!("{}: {}", scene.name(), escape(&header.title)));
    page.field("Kind", &describe(scene));
    let unit = unit(scene);
    if !unit.is_empty() {
        page.field("Unit", &escape(unit));
    }
    if let Some(source) = &header.source {
        page.field("Source", &escape(source));
    }
    if let Some((start, goal)) = scene.ends() {
        page.field("Start", &point(start));
        page.field("Goal", &point(goal));
    }
    if let Some(note) = &header.note {
        page.line("");
        page.paragraph(&escape(note), 2);
    }
    page.heading("Planners that run on it");
    let planners: Vec<_> = registry().suited(scene).map(|entry| entry.name).collect();
    page.paragraph(&planners.join(", "), 2);
    let run = planners.first().map(|planner| format!("forage run {planner} --scene {}", scene.name()));
    page.examples(&run.into_iter().chain([format!("forage exact --scene {}", scene.name())]).collect::<Vec<_>>());
}
