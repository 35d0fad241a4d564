//! What a planner says of itself, read into an entry. It was checked where its code is: the package's `describe` names the field
//! that is wrong, and keeps the texts for people. Names live as long as the program: there are as many as planners that somebody brings.

use serde_json::Value;

use forage::{
    describe::{Entry, Group, Layer, Reading, Start, layers},
    kernel::{Error, LayerKey, SceneKindId, Started, fields::shown},
    message,
    params::{Choice, Domain, Param, Parameter},
    scene::{DISCS, FUNCTION, GRID, TOUR},
};

/// After how many iterations a run ends: every planner has it, whether it says so or not.
pub const ITERATIONS: Param<u64> =
    Param::integer("iterations", "k_{\\max}", "Iterations", [1, 1_000_000_000, 1000], "After how many iterations it stops.");

/// The kinds of scenes that such planners may run on.
const KINDS: [SceneKindId; 4] = [FUNCTION, DISCS, GRID, TOUR];

fn leak<T>(all: Vec<T>) -> &'static [T] {
    Box::leak(all.into_boxed_slice())
}

fn text(value: &Value, field: &str) -> &'static str {
    Box::leak(value[field].as_str().unwrap_or_default().into())
}

fn list<'a>(value: &'a Value, field: &str) -> &'a [Value] {
    value[field].as_array().map_or(&[], Vec::as_slice)
}

/// The entry of a planner that describes itself as the catalogue lists planners: by a `name`, a `title`, `kinds` of scenes, `parameters`, `readings` and
/// `layers`.
///
/// # Errors
/// [`Error::Refused`] for `planner`, where it is no such description.
pub fn entry(described: &Value, start: fn(&Start) -> Result<Started, Error>) -> Result<&'static Entry, Error> {
    let kinds: Vec<_> = list(described, "kinds").iter().filter_map(|kind| KINDS.into_iter().find(|known| kind == known.name())).collect();
    let parameters: Option<Vec<_>> = list(described, "parameters").iter().map(parameter).collect();
    let name = text(described, "name");
    let (false, false, Some(mut parameters)) = (name.is_empty(), kinds.is_empty(), parameters) else {
        return Err(Error::refused(
            "planner",
            shown(&described["name"]),
            message!("script-described", "a planner as the catalogue lists them"),
        ));
    };
    if parameters.iter().all(|parameter| parameter.name != ITERATIONS.name()) {
        parameters.push(ITERATIONS.entry());
    }
    let mut entry = Entry::new(name, text(described, "title"), "", "", start).family(Entry::OWN);
    entry.stops = kinds == [TOUR];
    entry.kinds = leak(kinds);
    entry.parameters = leak(vec![leak(parameters)]);
    entry.readings = leak(list(described, "readings").iter().map(reading).collect());
    entry.layers = leak(list(described, "layers").iter().map(layer).collect());
    Ok(Box::leak(Box::new(entry)))
}

fn parameter(said: &Value) -> Option<Parameter> {
    let default = &said["default"];
    let bound = |field| said[field].as_f64();
    let domain = match said["type"].as_str()? {
        "flag" => Domain::Flag { default: default.as_bool()? },
        "choice" => {
            let mut options: Vec<_> = list(said, "options").iter().map(|option| Choice::new(text(option, "value"), "", "")).collect();
            // The first one is the default.
            let first = options.iter().position(|option| default == option.value)?;
            options[..=first].rotate_right(1);
            Domain::Choice { options: leak(options) }
        }
        "integer" => Domain::Integer { min: bound("min")? as u64, max: bound("max")? as u64, default: default.as_f64()? as u64 },
        _ => Domain::Number { min: bound("min")?, max: bound("max")?, default: default.as_f64()? },
    };
    let mut parameter = Param::number(text(said, "name"), "", "", [0.0; 3], "").entry();
    parameter.domain = domain;
    Some(parameter)
}

fn reading(said: &Value) -> Reading {
    Reading::new(text(said, "name"), "", "", Group::Measure, "")
}

/// A layer with the look of a standard one of its name, or that of particles.
fn layer(said: &Value) -> Layer {
    let role = text(said, "role");
    let look = layers::COMMON.iter().find(|layer| layer.key.0 == role).map_or(layers::PARTICLES.look, |layer| layer.look);
    let layer = Layer::new(LayerKey(role), "", "", look);
    if said["pickable"] == true { layer.pickable() } else { layer }
}
