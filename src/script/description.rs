//! What a planner says of itself, read into an entry. Names live as long as the program: there are as many as planners that somebody
//! brings.

use serde_json::Value;

use crate::{
    describe::{Entry, Group, Layer, Look, Reading, Start, layers},
    kernel::{
        Error, LayerKey, Message, SceneKindId, Started,
        fields::{Fields, each, shown},
    },
    message,
    params::{Choice, Domain, Param, Parameter},
    scene::{DISCS, FUNCTION, GRID, TOUR},
};

/// After how many iterations a run ends: every planner has it, whether it says so or not.
pub const ITERATIONS: Param<u64> =
    Param::integer("iterations", "k_{\\max}", "Iterations", [1, 1_000_000_000, 1000], "After how many iterations it stops.");

/// The kinds of scenes that such planners may run on.
const KINDS: [SceneKindId; 4] = [FUNCTION, DISCS, GRID, TOUR];

/// The longest name, title or help text, in bytes.
const LONGEST: usize = 2000;

fn leak(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

fn leak_all<T>(all: Vec<T>) -> &'static [T] {
    Box::leak(all.into_boxed_slice())
}

/// The entry of a planner that describes itself by a `name`, a `title`, `kinds` of scenes, `parameters`, `readings` and `layers`.
///
/// # Errors
/// The field that is wrong, its value and what is allowed.
pub fn entry(value: Value, start: fn(&Start) -> Result<Started, Error>) -> Result<&'static Entry, Error> {
    let mut fields = Fields::of("", value, message!("error-an-object", "an object"))?;
    let name = word(&mut fields)?;
    let title = text(&mut fields, "title")?.unwrap_or_else(|| name.clone());
    let summary = text(&mut fields, "summary")?.unwrap_or_default();
    let kinds = each("kinds", fields.list("kinds")?, |at, value| {
        let known = KINDS.into_iter().find(|kind| value == kind.name());
        known.ok_or_else(|| Error::refused(at, shown(&value), Message::verbatim(KINDS.map(SceneKindId::name).join(", "))))
    })?;
    if kinds.is_empty() {
        return Err(Error::refused(
            "kinds",
            shown(&Value::Array(Vec::new())),
            message!("script-one-kind", "a list of one kind of scene at least"),
        ));
    }
    if kinds.contains(&TOUR) && kinds.len() > 1 {
        let allowed = message!("script-tour-alone", "tour alone, or without it: a tour is another thing than a path");
        return Err(Error::refused("kinds", shown(&Value::Array(kinds.iter().map(|kind| kind.name().into()).collect())), allowed));
    }
    let mut parameters = each("parameters", fields.optional_list("parameters")?, parameter)?;
    if parameters.iter().all(|parameter| parameter.name != ITERATIONS.name()) {
        parameters.push(ITERATIONS.entry());
    }
    let readings = each("readings", fields.optional_list("readings")?, |at, value| {
        let mut fields = Fields::of(at, value, message!("script-named", "an object with a name"))?;
        let name = word(&mut fields)?;
        let title = text(&mut fields, "title")?.unwrap_or_else(|| name.clone());
        let help = text(&mut fields, "help")?.unwrap_or_default();
        let reading = Reading::new(leak(name), "", leak(title), Group::Measure, leak(help));
        fields.end()?;
        Ok(reading)
    })?;
    let layers = each("layers", fields.optional_list("layers")?, layer)?;
    for (field, names) in [
        ("parameters", parameters.iter().map(|parameter| parameter.name).collect::<Vec<_>>()),
        ("readings", readings.iter().map(|reading| reading.name).collect()),
        ("layers", layers.iter().map(|layer| layer.key.0).collect()),
    ] {
        if let Some((i, name)) = names.iter().enumerate().find(|(i, name)| names[..*i].contains(name)) {
            return Err(Error::refused(format!("{field}[{i}].name"), *name, message!("script-once", "a name that no other one has")));
        }
    }
    fields.end()?;
    let stops = kinds == [TOUR];
    let entry = Entry {
        stops,
        kinds: leak_all(kinds),
        parameters: leak_all(vec![leak_all(parameters)]),
        readings: leak_all(readings),
        layers: leak_all(layers),
        ..Entry::new(leak(name), leak(title), "", leak(summary), start).family("own")
    };
    Ok(Box::leak(Box::new(entry)))
}

/// A name of small letters, digits and dashes or underlines.
fn word(fields: &mut Fields) -> Result<String, Error> {
    let name = fields.text("name")?;
    let fits = name.starts_with(|first: char| first.is_ascii_lowercase())
        && name.len() <= 60
        && name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-' || byte == b'_');
    if fits {
        return Ok(name);
    }
    let allowed = message!("script-name", "1 to 60 small letters, digits, - and _, a letter first");
    Err(Error::refused(fields.path("name"), format!("\"{name}\""), allowed))
}

fn text(fields: &mut Fields, name: &'static str) -> Result<Option<String>, Error> {
    let text = fields.optional_text(name)?;
    match &text {
        Some(long) if long.len() > LONGEST => {
            let found = message!("error-bytes", "a size of {n} bytes", n = long.len());
            Err(Error::refused(fields.path(name), found, message!("error-most-bytes", "at most {most} bytes", most = LONGEST)))
        }
        _ => Ok(text),
    }
}

/// A number from `min` to `max`, whole if it says `integer`; one of `options`; or a flag, whose default is true or false.
fn parameter(at: &str, value: Value) -> Result<Parameter, Error> {
    let mut fields = Fields::of(at, value, message!("script-named", "an object with a name"))?;
    let name = word(&mut fields)?;
    let title = text(&mut fields, "title")?.unwrap_or_else(|| name.clone());
    let symbol = text(&mut fields, "symbol")?.unwrap_or_default();
    let help = text(&mut fields, "help")?.unwrap_or_default();
    let options = each(&fields.path("options"), fields.optional_list("options")?, |at, value| match value {
        Value::String(option) if !option.is_empty() && option.len() <= 60 => Ok(leak(option)),
        other => Err(Error::refused(at, shown(&other), message!("script-option", "a text of 1 to 60 characters"))),
    })?;
    let default = fields.take("default");
    let path = fields.path("default");
    let wrong = |allowed: Message| Error::refused(path, shown(&default), allowed);
    let domain = if let Value::Bool(default) = default {
        Domain::Flag { default }
    } else if options.is_empty() {
        let (min, max) = (fields.optional_number("min")?, fields.optional_number("max")?);
        let integer = fields.flag("integer", false)?;
        let (min, max) = (min.unwrap_or(if integer { 0.0 } else { -1e9 }), max.unwrap_or(1e9));
        let whole = |number: f64| number.fract() == 0.0 && (0.0..=1e15).contains(&number);
        if min > max || (integer && !(whole(min) && whole(max))) {
            let allowed = message!("script-range", "a number from min on; both whole and not negative where integer is true");
            return Err(Error::refused(fields.path("max"), max, allowed));
        }
        let given = default.as_f64().filter(|given| (min..=max).contains(given) && (!integer || given.fract() == 0.0));
        let Some(default) = given else {
            return Err(wrong(message!("error-number-from-to", "a number from {low} to {high}", low = min, high = max)));
        };
        if integer {
            Domain::Integer { min: min as u64, max: max as u64, default: default as u64 }
        } else {
            Domain::Number { min, max, default }
        }
    } else {
        let mut choices: Vec<_> = options.iter().map(|option| Choice::new(option, option, "")).collect();
        let Some(first) = options.iter().position(|option| default == *option) else {
            return Err(wrong(message!("error-one-of", "one of {names}", names = options.join(", "))));
        };
        choices.swap(0, first);
        Domain::Choice { options: leak_all(choices) }
    };
    fields.end()?;
    Ok(Parameter { domain, ..Param::number(leak(name), leak(symbol), leak(title), [0.0, 1.0, 0.0], leak(help)).entry() })
}

/// A layer with the look of a standard one of its name, or one of a few others, in turn.
fn layer(at: &str, value: Value) -> Result<Layer, Error> {
    let mut fields = Fields::of(at, value, message!("script-named", "an object with a name"))?;
    let name = leak(word(&mut fields)?);
    let title = text(&mut fields, "title")?;
    let help = text(&mut fields, "help")?.unwrap_or_default();
    let pickable = fields.flag("pickable", false)?;
    fields.end()?;
    let known = layers::COMMON.iter().find(|layer| layer.key.0 == name);
    let look: &'static Look = known.map_or(layers::PARTICLES.look, |layer| layer.look);
    let layer = Layer::new(LayerKey(name), leak(title.unwrap_or_else(|| name.to_owned())), leak(help), look);
    Ok(if pickable { layer.pickable() } else { layer })
}
