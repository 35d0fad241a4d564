//! A page about one planner, generator, scene, the drive or the arm's motion.

use std::fmt::Write;

use forage::{
    Scene,
    describe::{CentreBias, Entry, Follower, Generator, Ratio},
    kernel::{Message, SceneKindId},
    message,
    params::Parameter,
    scene::{ARM, GridScene},
};

use crate::{
    convert::describe,
    exact::unit,
    kinds,
    language::{say, say_numbered},
    registry::registry,
    text::{self, escape, listed, padded, point, wrap},
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
    fn field(&mut self, label: &Message, value: &str) {
        let lines = wrap(value, self.columns, 13);
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {}  {lines}", padded(&label.text(), 9));
    }

    fn heading(&mut self, heading: &Message) {
        self.text.extend(["\n", &heading.text(), "\n"]);
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

    /// Parameters, whose texts are at `place`.
    fn parameters(&mut self, option: &str, place: &str, parameters: &[&[Parameter]], kinds: &[SceneKindId]) {
        self.heading(&message!("shell-parameters", "Parameters ({option} NAME=VALUE)", option));
        let width = parameters.iter().copied().flatten().map(|parameter| parameter.name.len()).max().unwrap_or(0);
        for parameter in parameters.iter().copied().flatten() {
            let (allowed, default) = (parameter.allowed(), defaults(parameter, kinds));
            let range = match parameter.when {
                None => message!("shell-parameter", "{allowed}; default {default}", allowed, default),
                Some(when) => message!(
                    "shell-parameter-if",
                    "{allowed}; default {default}; only if {condition}",
                    allowed,
                    default,
                    condition = format!("{}={}", when.parameter, when.value)
                ),
            };
            let help = say(parameter.help, &format!("{place}.parameters.{}.help", parameter.name));
            self.named(parameter.name, width, &range.text(), help);
        }
    }

    fn examples(&mut self, examples: &[String]) {
        self.heading(&if examples.len() == 1 { message!("shell-example", "Example") } else { message!("shell-examples", "Examples") });
        examples.iter().for_each(|example| self.line(&format!("  {example}")));
    }
}

/// The default, or the defaults by kind where they differ.
fn defaults(parameter: &Parameter, kinds: &[SceneKindId]) -> Message {
    let on: Vec<SceneKindId> = kinds.iter().copied().filter(|&kind| parameter.applies_to(kind)).collect();
    let values: Vec<String> = on.iter().map(|&kind| parameter.default_on(kind).to_string()).collect();
    let Some(first) = values.first() else { return message!("shell-no-default", "none") };
    if values.iter().any(|value| value != first) {
        let pair = |(value, kind): (&String, &SceneKindId)| {
            message!("shell-value-on", "{value} on {kind}", value, kind = kinds::name(kind.name())).to_string()
        };
        return Message::verbatim(listed(&values.iter().zip(&on).map(pair).collect::<Vec<_>>()));
    }
    if on.len() == kinds.len() {
        return Message::verbatim(first);
    }
    message!("shell-value-only-on", "{value}; only on {kinds}", value = first, kinds = listed(&kinds::names(&on)))
}

/// The centre bias of a planner, with that of random search.
fn centre_bias(bias: CentreBias) -> Message {
    let shown = |Ratio { value, from, to }: Ratio| message!("shell-ratio", "{value:.2} ({from:.2} to {to:.2})", value, from, to);
    message!(
        "shell-centre-bias",
        "With default parameters, in 10 variables and 10,000 evaluations: shifting the minimum away from the centre of the search box multiplies the gap by {shifted} (random search: {random:.2}). Rotating the axes multiplies it by {rotated}.",
        shifted = shown(bias.shifted),
        random = bias.random_search.value,
        rotated = shown(bias.rotated)
    )
}

/// A name with its title, as a page begins.
fn titled(name: &str, title: &str) -> String {
    text::at(name, &Message::verbatim(title)).to_string()
}

fn planner(entry: &Entry, page: &mut Page) {
    let place = format!("planners.{}", entry.name);
    page.line(&titled(entry.name, say(entry.title, &format!("{place}.title"))));
    page.field(&message!("shell-page-family", "Family"), &kinds::family(entry).text());
    page.field(&message!("shell-page-source", "Source"), &say_numbered(entry.source));
    page.field(&message!("shell-page-scenes", "Scenes"), &listed(&kinds::of_planner(entry)));
    if !entry.evaluation.is_empty() {
        page.field(&message!("shell-page-evaluates", "Evaluates"), say(entry.evaluation, &format!("{place}.evaluation")));
    }
    if let Some(most) = entry.most_stops {
        page.field(&message!("shell-page-stops", "Stops"), &message!("shell-most-stops", "at most {most}", most).text());
    }
    page.line("");
    page.paragraph(say(entry.summary, &format!("{place}.summary")), 2);
    if let Some(bias) = CentreBias::of(entry.name) {
        page.heading(&message!("shell-page-centre-bias", "Centre bias (forage bench centre-bias)"));
        page.paragraph(&centre_bias(bias).text(), 2);
    }
    page.parameters("--set", &place, entry.parameters, entry.kinds);
    presets(entry, &place, page);
    page.heading(&message!("shell-page-metrics", "Metrics of each iteration (`readings` in JSON; --trace FILE writes them)"));
    let width = entry.readings.iter().map(|reading| reading.name.len()).max().unwrap_or(0);
    for reading in entry.readings {
        let part = |text, part| say(text, &format!("{place}.readings.{}.{part}", reading.name)).to_owned();
        let (title, help) = (part(reading.title, "title"), part(reading.help, "help"));
        page.named(reading.name, width, &message!("shell-metric", "{title}. {help}", title, help).text(), "");
    }
    let scene = example_scene(entry).map_or("FILE", |scene| scene.name());
    // A tuner runs thousands of colonies with its defaults.
    let quick = if entry.family == "tuning" { " --iterations 2 --set population=4" } else { "" };
    page.examples(&[format!("forage run {} --scene {scene}{quick}", entry.name)]);
}

fn presets(entry: &Entry, place: &str, page: &mut Page) {
    if entry.presets.is_empty() {
        return;
    }
    page.heading(&message!("shell-page-presets", "Presets (--preset NAME)"));
    let width = entry.presets.iter().map(|preset| preset.name.len()).max().unwrap_or(0);
    for preset in entry.presets {
        let values: Vec<_> = preset.given().iter().map(|(name, value)| format!("{name}={value}")).collect();
        let values = if values.is_empty() { message!("shell-the-defaults", "the defaults") } else { Message::verbatim(values.join(" ")) };
        let part = |text, part| say(text, &format!("{place}.presets.{}.{part}", preset.name));
        let title = text::at(part(preset.title, "title"), &values);
        page.named(preset.name, width, &title.text(), part(preset.help, "help"));
    }
}

/// A shipped scene on which a planner finds something.
fn example_scene(entry: &Entry) -> Option<&'static Scene> {
    const FIRST: [&str; 6] = ["arm-cuboid", "wcpso-discs", "qpso-10m", "crossing", "wolf-ant-20", "ant-bat-30"];
    let preferred = FIRST.iter().filter_map(|name| registry().scenes().iter().find(|scene| scene.name() == *name));
    let drives = |scene: &Scene| entry.family != "dynamic" || scene.get::<GridScene>().is_ok_and(|grid| !grid.moving.is_empty());
    preferred.chain(registry().scenes().iter()).map(|scene| &**scene).find(|scene| entry.check_scene(scene).is_ok() && drives(scene))
}

fn generator(generator: &'static Generator, page: &mut Page) {
    let place = format!("generators.{}", generator.name);
    page.line(&titled(generator.name, say(generator.title, &format!("{place}.title"))));
    let kind = kinds::name(generator.kind.name());
    page.field(&message!("shell-page-makes", "Makes"), &message!("shell-scenes-of-kind", "scenes of kind {kind}", kind).text());
    page.line("");
    page.paragraph(say(generator.help, &format!("{place}.help")), 2);
    page.parameters("--set", &place, generator.parameters, &[generator.kind]);
    page.examples(&[format!("forage generate {0} --seed 7 --out {0}.json", generator.name)]);
}

fn following(entry: &Follower, page: &mut Page) {
    let (name, kind) = (entry.name, entry.kind);
    page.line(&titled(name, say(entry.title, &format!("{name}.title"))));
    page.field(&message!("shell-page-source", "Source"), &say_numbered(entry.source));
    page.field(&message!("shell-page-scenes", "Scenes"), &kinds::name(kind.name()));
    page.line("");
    page.paragraph(say(entry.summary, &format!("{name}.summary")), 2);
    page.parameters(&format!("--{name}-set"), name, entry.parameters, &[kind]);
    page.heading(&message!("shell-page-columns", "Columns of the CSV file that --{name} FILE writes", name));
    let width = entry.columns.iter().map(|column| column.name.len()).max().unwrap_or(0);
    for column in entry.columns {
        let title = say(column.title, &format!("{name}.columns.{}.title", column.name));
        let title = if column.unit.is_empty() {
            Message::verbatim(title)
        } else {
            message!("shell-with-unit", "{title} ({unit})", title, unit = column.unit)
        };
        page.named(column.name, width, &title.text(), "");
    }
    let example = if kind == ARM { "run rrt-guided --scene arm-cuboid" } else { "run ltqpso --scene qpso-10m" };
    page.examples(&[format!("forage {example} --{name} {name}.csv")]);
}

fn scene(scene: &Scene, page: &mut Page) {
    let header = scene.header();
    let place = |part: &str| format!("scenes.{}.{part}", scene.name());
    page.line(&titled(scene.name(), &escape(say(&header.title, &place("title")))));
    page.field(&message!("shell-page-kind", "Kind"), &describe(scene));
    let unit = unit(scene);
    if !unit.is_empty() {
        page.field(&message!("shell-page-unit", "Unit"), &escape(say(unit, &place("units"))));
    }
    if let Some(source) = &header.source {
        page.field(&message!("shell-page-source", "Source"), &escape(&say_numbered(source)));
    }
    if let Some((start, goal)) = scene.ends() {
        page.field(&message!("shell-page-start", "Start"), &point(start));
        page.field(&message!("shell-page-goal", "Goal"), &point(goal));
    }
    if let Some(note) = &header.note {
        page.line("");
        page.paragraph(&escape(say(note, &place("note"))), 2);
    }
    page.heading(&message!("shell-page-suited", "Planners that run on it"));
    let planners: Vec<_> = registry().suited(scene).map(|entry| entry.name).collect();
    page.paragraph(&planners.join(", "), 2);
    let run = planners.first().map(|planner| format!("forage run {planner} --scene {}", scene.name()));
    page.examples(&run.into_iter().chain([format!("forage exact --scene {}", scene.name())]).collect::<Vec<_>>());
}
