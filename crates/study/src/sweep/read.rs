//! A sweep's file: TOML. Everything in it is checked here, before anything is run.

use std::{collections::BTreeMap, path::PathBuf, sync::Arc};

use serde::Deserialize;
use toml::{Table, Value as Toml};

use forage::{
    Scene, Value,
    describe::{Entry, Registry},
    kernel::{
        Error, Message,
        limits::{check_whole, whole_range},
    },
    message,
    run::trial::WITHIN,
};

use super::{
    super::{digest, failure::Failure},
    line::{Format, columns},
    plan::{Budget, MOST, MOST_CELLS, Seeds, Setting, Sweep, Variants},
    text::value_text,
};

/// More evaluations than these nobody waits for.
const MOST_BUDGET: u64 = 1_000_000_000_000;

/// Finds the scene that a text stands for.
pub type Load<'a> = &'a dyn Fn(&str) -> Result<Arc<Scene>, Failure>;

/// What a file says.
#[derive(Debug)]
pub struct Experiment {
    /// The runs.
    pub sweep: Sweep,
    /// Where the rows are to go, if it says so.
    pub out: Option<PathBuf>,
}

/// As it stands there. What the fields hold is checked with their places in hand.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: Option<Toml>,
    scenes: Option<Toml>,
    seeds: Option<Toml>,
    within: Option<Toml>,
    iterations: Option<Toml>,
    budget: Option<Toml>,
    out: Option<Toml>,
    #[serde(default)]
    planner: Vec<Planner>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Planner {
    name: Option<Toml>,
    #[serde(default)]
    params: Table,
}

/// Reads a sweep's file, which is called `file`.
///
/// # Errors
/// The field, its value and what is allowed.
pub fn read(registry: &Arc<Registry>, file: &str, default_name: &str, text: &str, load: Load) -> Result<Experiment, Failure> {
    let given: File = toml::from_str(text).map_err(|problem| Error::malformed(file, placed(text, &problem)))?;
    let name = given.name.map_or(Ok(default_name.to_owned()), |name| plain_text("name", &name))?;
    let scenes = scenes(given.scenes.as_ref(), load)?;
    let seeds = seeds(given.seeds.as_ref())?;
    let within = given.within.map_or(Ok(WITHIN), |within| {
        let share = number(&within).filter(|share| (0.0..=1e6).contains(share));
        share.ok_or_else(|| {
            let allowed =
                message!("study-within", "a number from 0 to 1000000, a share of the exact optimum, or on functions a difference");
            refused("within", &within, allowed)
        })
    })?;
    let out = given.out.map(|out| plain_text("out", &out).map(PathBuf::from)).transpose()?;
    out.as_deref().map(|out| Format::of("out", out)).transpose()?;
    let budget = budget(given.budget.as_ref(), given.iterations.is_some())?;
    let (planners, parameters) = planners(registry, &given.planner, given.iterations.as_ref(), &scenes)?;

    let registry = Arc::clone(registry);
    let mut sweep = Sweep {
        registry,
        name,
        origins: Vec::new(),
        scenes,
        within,
        budget,
        allowances: Vec::new(),
        parameters,
        seeds,
        in_front: in_front(&planners),
        planners,
        weights: Vec::new(),
    };
    let columns = columns(&sweep);
    sweep.origins = sweep.scenes.iter().map(|scene| digest::origin(scene, &columns)).collect();
    let groups = sweep.planners.iter().map(|planner| planner.count).fold(0, usize::saturating_add);
    let cells = groups.saturating_mul(sweep.scenes.len());
    if cells > MOST_CELLS {
        let allowed = message!(
            "study-most-cells",
            "at most {most} combinations of planners × scenes × parameter values, without the seeds",
            most = MOST_CELLS
        );
        return Err(Error::refused("planner", message!("study-sweep-of-cells", "a sweep of {cells}", cells), allowed).into());
    }
    let runs = cells.saturating_mul(sweep.seeds.len());
    if runs > MOST {
        let allowed = message!("study-most-runs", "at most {most} runs, planners × scenes × parameter values × seeds", most = MOST);
        return Err(Error::refused("seeds", message!("study-sweep-of-runs", "a sweep of {runs} runs", runs), allowed).into());
    }
    sweep.allow()?;
    sweep.weigh()?;
    Ok(Experiment { sweep, out })
}

/// Equal evaluations for all, unless the file says otherwise: also by how many iterations all have.
fn budget(given: Option<&Toml>, iterations: bool) -> Result<Budget, Error> {
    let allowed =
        || message!("study-budget", "evaluations: a whole number from 1 to {most}; \"first\" or \"own\"", most = MOST_BUDGET.to_string());
    match given {
        None if iterations => Ok(Budget::Own),
        None => Ok(Budget::First),
        Some(given) => match (given.as_str(), given.as_integer().and_then(|number| u64::try_from(number).ok())) {
            (Some("first"), _) => Ok(Budget::First),
            (Some("own"), _) => Ok(Budget::Own),
            (_, Some(number)) if (1..=MOST_BUDGET).contains(&number) => Ok(Budget::Evaluations(number)),
            _ => Err(refused("budget", given, allowed())),
        },
    }
}

/// A TOML error in one line, with its place.
fn placed(text: &str, problem: &toml::de::Error) -> Message {
    let before = problem.span().and_then(|span| text.get(..span.start)).unwrap_or("");
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
    let problem = problem.message().trim().replace('\n', ", ");
    message!("study-line-and-column", "line {line}, column {column}: {problem}", line, column, problem)
}

fn in_front(planners: &[Variants]) -> Vec<usize> {
    let counts = planners.iter().scan(0_usize, |sum, planner| {
        let before = *sum;
        *sum = sum.saturating_add(planner.count);
        Some(before)
    });
    counts.collect()
}

fn scenes(given: Option<&Toml>, load: Load) -> Result<Vec<Arc<Scene>>, Failure> {
    let names = list("scenes", given, message!("study-scenes", "a list of scenes: shipped names, files or links"))?;
    let mut scenes: Vec<Arc<Scene>> = Vec::with_capacity(names.len());
    for (i, name) in names.iter().enumerate() {
        let place = format!("scenes[{i}]");
        let scene = load(&plain_text(&place, name)?).map_err(|failure| match failure {
            Failure::Refused(error) => Failure::Refused(in_scene(&place, error)),
            other => other,
        })?;
        let called = scene.name();
        if called.contains(char::is_control) {
            return Err(Error::refused(
                format!("{place}.name"),
                format!("{called:?}"),
                message!("study-name-in-one-line", "a name in one line"),
            )
            .into());
        }
        if let Some(other) = scenes.iter().position(|known| known.name() == called) {
            let allowed =
                message!("study-scene-of-another-name", "a scene of another name than scenes[{other}]: rows are told apart by it", other);
            return Err(Error::refused(place, format!("`{called}`"), allowed).into());
        }
        scenes.push(scene);
    }
    Ok(scenes)
}

/// An error of a scene, with the scene's place.
fn in_scene(place: &str, error: Error) -> Error {
    match error {
        Error::Refused { field, value, allowed } if field == "scene" => Error::refused(place, value, allowed),
        Error::Malformed { field, problem } if field == "scene" => Error::malformed(place, problem),
        other => other.within(place),
    }
}

fn seeds(given: Option<&Toml>) -> Result<Seeds, Error> {
    let whole = |place: &str, value: &Toml, allowed: Message| {
        let number = value.as_integer().and_then(|number| u64::try_from(number).ok());
        number.ok_or_else(|| refused(place, value, allowed))
    };
    let seed = |place: &str, value: &Toml| {
        let number = whole(place, value, whole_range())?;
        check_whole(place, number)
    };
    match given {
        Some(Toml::Table(range)) => {
            if let Some(name) = range.keys().find(|name| !["from", "count"].contains(&name.as_str())) {
                return Err(Error::unknown("seeds", name, ["from", "count"]));
            }
            let missing = |place: &str| Error::refused(place, nothing(), message!("study-whole-number", "a whole number"));
            let from = seed("seeds.from", range.get("from").ok_or_else(|| missing("seeds.from"))?)?;
            let given = range.get("count").ok_or_else(|| missing("seeds.count"))?;
            let allowed = || message!("error-whole-from-to", "a whole number from {min} to {max}", min = 1_u64, max = MOST);
            let count = whole("seeds.count", given, allowed())?;
            if !(1..=MOST as u64).contains(&count) {
                return Err(refused("seeds.count", given, allowed()));
            }
            let small = || message!("study-seeds-small", "small enough that the last seed is at most 9007199254740991");
            check_whole("seeds", from + (count - 1)).map_err(|_| refused("seeds.count", given, small()))?;
            Ok(Seeds::From(from, count as usize))
        }
        other => {
            let mut places = BTreeMap::new();
            let mut seeds = Vec::new();
            let allowed = message!("study-seeds", "{range} or a list of whole numbers", range = "{ from = 1, count = 50 }");
            for (i, value) in list("seeds", other, allowed)?.iter().enumerate() {
                let place = format!("seeds[{i}]");
                let number = seed(&place, value)?;
                if let Some(first) = places.insert(number, i) {
                    return Err(refused(&place, value, message!("study-another-seed", "another seed than seeds[{first}]", first)));
                }
                seeds.push(number);
            }
            Ok(Seeds::List(seeds, places))
        }
    }
}

/// The planners, and the names of all their parameters.
fn planners(
    registry: &Registry,
    given: &[Planner],
    iterations: Option<&Toml>,
    scenes: &[Arc<Scene>],
) -> Result<(Vec<Variants>, Vec<String>), Error> {
    if given.is_empty() {
        return Err(Error::refused("planner", nothing(), message!("study-one-planner", "one [[planner]] with a name at least")));
    }
    let mut parameters = Vec::new();
    let mut all: Vec<Variants> = Vec::with_capacity(given.len());
    for (i, planner) in given.iter().enumerate() {
        let place = format!("planner[{i}]");
        let field = format!("{place}.name");
        let name = planner.name.as_ref().ok_or_else(|| {
            Error::refused(&field, nothing(), message!("study-planner-name", "a planner’s name; `forage list` shows them"))
        })?;
        let entry = registry.planner(&plain_text(&field, name)?).map_err(|error| match error {
            Error::Unknown { value, known, .. } => Error::Unknown { field: field.clone(), value, known },
            other => other,
        })?;
        check_scenes(entry, &field, scenes)?;
        let variants = variants(entry, &place, &planner.params, iterations, &mut parameters)?;
        if let Some(other) = all.iter().position(|known| known.meets(&variants)) {
            let allowed = message!(
                "study-other-parameters",
                "a planner with other parameters than planner[{other}]: some of its runs would be the same",
                other
            );
            return Err(Error::refused(field, entry.name, allowed));
        }
        all.push(variants);
    }
    Ok((all, parameters))
}

fn check_scenes(entry: &Entry, field: &str, scenes: &[Arc<Scene>]) -> Result<(), Error> {
    for (j, scene) in scenes.iter().enumerate() {
        entry.check_scene(scene).map_err(|error| match error {
            Error::Unsupported { planner, kind, kinds } => {
                let allowed = message!(
                    "study-planner-for-scene",
                    "a planner for scenes[{j}], {scene}, which is of kind {kind}; {planner} runs on: {kinds}; leave one of them out, or give it a sweep of its own",
                    j,
                    scene = scene.name(),
                    kind,
                    planner,
                    kinds
                );
                Error::refused(field, planner, allowed)
            }
            Error::Refused { field: part, value, allowed } => {
                let allowed = message!(
                    "study-allowed-for-planner",
                    "{allowed}, for {planner}; leave one of them out, or give it a sweep of its own",
                    allowed,
                    planner = entry.name
                );
                Error::refused(format!("scenes[{j}].{part}"), value, allowed)
            }
            other => other.within(&format!("scenes[{j}]")),
        })?;
    }
    Ok(())
}

fn variants(entry: &Entry, place: &str, params: &Table, iterations: Option<&Toml>, names: &mut Vec<String>) -> Result<Variants, Error> {
    // The limit for all comes first: what changes least.
    let common = iterations.filter(|_| !params.contains_key("iterations")).map(|value| ("iterations", "iterations".to_owned(), value));
    let own = params.iter().map(|(name, value)| (name.as_str(), format!("{place}.params.{name}"), value));
    let mut settings = Vec::new();
    let mut count = 1_usize;
    for (name, field, value) in common.into_iter().chain(own) {
        if let Some(parameter) = entry.parameter(name) {
            let values = values(&field, value, field != "iterations")?;
            for (at, value) in values.iter().enumerate() {
                let field = if value_is_alone(params.get(name)) { field.clone() } else { format!("{field}[{at}]") };
                parameter.check(value).map_err(|_| Error::refused(field, shown_value(value), parameter.allowed()))?;
            }
            count = count.saturating_mul(values.len());
            settings.push(Setting::new(column(names, name), values));
        } else {
            return Err(Error::unknown(&format!("{place}.params"), name, entry.all_parameters().map(|parameter| parameter.name)));
        }
    }
    Ok(Variants { planner: entry.name.to_owned(), settings, count })
}

fn value_is_alone(value: Option<&Toml>) -> bool {
    !matches!(value, Some(Toml::Array(_)))
}

fn column(names: &mut Vec<String>, name: &str) -> usize {
    names.iter().position(|known| known == name).unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    })
}

/// One value, or each of a list, no two alike.
fn values(field: &str, given: &Toml, many: bool) -> Result<Vec<Value>, Error> {
    let Toml::Array(items) = given else { return Ok(vec![value(field, given)?]) };
    if !many || items.is_empty() {
        let allowed = if many {
            message!("study-a-value", "a value, or a list of one value at least")
        } else {
            message!("study-one-number", "one number for all planners")
        };
        return Err(refused(field, given, allowed));
    }
    let mut texts = BTreeMap::new();
    let mut values = Vec::with_capacity(items.len());
    for (i, item) in items.iter().enumerate() {
        let place = format!("{field}[{i}]");
        let found = value(&place, item)?;
        if let Some(first) = texts.insert(value_text(&found), i) {
            return Err(refused(&place, item, message!("study-another-value", "another value than {field}[{first}]", field, first)));
        }
        values.push(found);
    }
    Ok(values)
}

fn value(field: &str, given: &Toml) -> Result<Value, Error> {
    match given {
        Toml::Boolean(flag) => Ok(Value::Flag(*flag)),
        Toml::String(text) => Ok(Value::Text(text.clone())),
        other => {
            let allowed = || message!("study-value-or-list", "a number, a text, true or false, or a list of such");
            number(other).map(Value::Number).ok_or_else(|| refused(field, other, allowed()))
        }
    }
}

/// −0 becomes 0, as in scenes and links.
fn number(given: &Toml) -> Option<f64> {
    match given {
        Toml::Integer(number) => Some(*number as f64),
        Toml::Float(number) => Some(number + 0.0),
        _ => None,
    }
}

fn list<'a>(field: &str, given: Option<&'a Toml>, allowed: Message) -> Result<&'a [Toml], Error> {
    match given {
        Some(Toml::Array(items)) if !items.is_empty() => Ok(items),
        Some(other) => Err(refused(field, other, message!("study-one-at-least", "{allowed}, one at least", allowed))),
        None => Err(Error::refused(field, nothing(), allowed)),
    }
}

fn plain_text(field: &str, given: &Toml) -> Result<String, Error> {
    let text = given.as_str().filter(|text| !text.is_empty() && !text.contains(char::is_control));
    text.map(str::to_owned).ok_or_else(|| refused(field, given, message!("study-text-in-one-line", "a text in one line")))
}

/// What is said of what is missing.
fn nothing() -> Message {
    message!("error-nothing", "nothing")
}

fn refused(field: &str, given: &Toml, allowed: Message) -> Error {
    let shown = match given {
        Toml::Array(items) => message!("error-list-of", "a list of {n}", n = items.len()).to_string(),
        Toml::Table(_) => message!("study-a-table", "a table").to_string(),
        Toml::String(text) => format!("{text:?}"),
        other => other.to_string(),
    };
    Error::refused(field, shown, allowed)
}

fn shown_value(value: &Value) -> String {
    match value {
        Value::Text(text) => format!("{text:?}"),
        other => value_text(other),
    }
}
