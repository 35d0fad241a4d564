//! Functions that are not among those with names: checked, with a box and what is known of the minimum.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    kernel::{
        Error, Message, Minimum,
        fields::{Fields, each, number, object, shown},
        objective::{Objective, Scratch, SearchBox},
    },
    message,
};

use super::{body::FunctionScene, named::MAX_DIMENSION};

/// How far from 0 a side of the search box may be.
const FARTHEST: f64 = 1e15;

/// Where an objective comes from.
pub(super) enum Origin {
    /// A field of the scene file.
    Field(&'static str, Value),
    /// Code, which no file can hold.
    Code,
}

/// The scene of an objective; with the minimum and where that is, as far as they are known.
pub(super) fn scene(
    objective: Arc<dyn Objective>,
    origin: Origin,
    minimum: Option<f64>,
    minimiser: Option<Vec<f64>>,
) -> Result<FunctionScene, Error> {
    let minimum = minimum.map(|value| Minimum { value, stated: true });
    let (low, high) = (objective.search_box().low(), objective.search_box().high());
    let n = low.len();
    check_dimension(n)?;
    for (j, (&low, &high)) in low.iter().zip(high).enumerate() {
        if low.abs() > FARTHEST {
            return Err(Error::refused(format!("bounds.min[{j}]"), low, far()));
        }
        if high.abs() > FARTHEST {
            return Err(Error::refused(format!("bounds.max[{j}]"), high, far()));
        }
        if low >= high {
            return Err(Error::refused(format!("bounds.max[{j}]"), high, message!("scene-above", "a number above {low}", low)));
        }
    }
    if let Some(minimiser) = &minimiser {
        if minimiser.len() != n {
            let allowed = message!("scene-numbers", "a list of {n} numbers, one for each variable", n);
            return Err(Error::refused("optimum.position", minimiser.len(), allowed));
        }
        for (j, (&x, (&low, &high))) in minimiser.iter().zip(low.iter().zip(high)).enumerate() {
            if !(low..=high).contains(&x) {
                let allowed = message!("error-from-to", "from {min} to {max}", min = low, max = high);
                return Err(Error::refused(format!("optimum.position[{j}]"), x, allowed));
            }
        }
        let value = objective.evaluate(minimiser, &mut Scratch::default()).cost;
        if let Some(minimum) = minimum
            && (value.is_nan() || (value - minimum.value).abs() > minimum.rounding())
        {
            let allowed = message!("scene-minimum-there", "the value at its position, {value}", value);
            return Err(Error::refused("optimum.value", minimum.value, allowed));
        }
    }
    let mut fields = vec![("dimension", Value::from(n)), ("bounds", object(vec![("min", side(low)), ("max", side(high))]))];
    if let Some(minimum) = minimum {
        let value = Value::from(minimum.value);
        let optimum = match &minimiser {
            Some(position) => object(vec![("value", value), ("position", Value::from(position.as_slice()))]),
            None => value,
        };
        fields.push(("optimum", optimum));
    }
    let code = matches!(origin, Origin::Code);
    if let Origin::Field(name, value) = origin {
        fields.insert(0, (name, value));
    }
    Ok(FunctionScene::written(objective, fields, minimum, minimiser, code))
}

/// Refuses more variables than a function may have.
pub(super) fn check_dimension(n: usize) -> Result<(), Error> {
    if (1..=MAX_DIMENSION).contains(&n) {
        return Ok(());
    }
    let allowed = message!("scene-most-variables", "a whole number from 1 to {most}", most = MAX_DIMENSION);
    Err(Error::refused("dimension", n, allowed))
}

/// One number where all sides are the same.
fn side(of: &[f64]) -> Value {
    match of {
        [first, others @ ..] if others.iter().all(|other| other == first) => Value::from(*first),
        _ => Value::from(of),
    }
}

fn far() -> Message {
    message!("error-from-to", "from {min} to {max}", min = -FARTHEST, max = FARTHEST)
}

/// Reads the box of so many sides.
pub(super) fn read_box(fields: &mut Fields, n: usize) -> Result<SearchBox, Error> {
    let bounds = fields.take("bounds");
    let allowed = message!("scene-box", "an object with min and max, each a number or a list of {n} numbers", n);
    let mut bounds = Fields::of("bounds", bounds, allowed)?;
    let low = sides(&mut bounds, "min", n)?;
    let high = sides(&mut bounds, "max", n)?;
    bounds.end()?;
    Ok(SearchBox::of(low.into_iter().zip(high).map(|(low, high)| [low, high])))
}

/// A number for all sides, or one for each.
fn sides(bounds: &mut Fields, name: &'static str, n: usize) -> Result<Vec<f64>, Error> {
    let found = bounds.take(name);
    let path = bounds.path(name);
    match found {
        Value::Number(_) => Ok(vec![number(path, &found)?; n]),
        Value::Array(items) if items.len() == n => each(&path, items, |at, value| number(at.to_owned(), &value)),
        _ => Err(Error::refused(path, shown(&found), message!("scene-sides", "a number, or {n} of them, one for each variable", n))),
    }
}

/// Reads the minimum and where it is, as far as they are stated.
pub(super) fn read_optimum(fields: &mut Fields) -> Result<(Option<f64>, Option<Vec<f64>>), Error> {
    match fields.optional("optimum") {
        None => Ok((None, None)),
        Some(value @ Value::Number(_)) => Ok((Some(number("optimum".to_owned(), &value)?), None)),
        Some(value) => {
            let allowed = message!("scene-optimum", "a number, or an object with value and position");
            let mut optimum = Fields::of("optimum", value, allowed)?;
            let value = optimum.number("value")?;
            let position = if optimum.has("position") {
                Some(each("optimum.position", optimum.list("position")?, |at, value| number(at.to_owned(), &value))?)
            } else {
                None
            };
            optimum.allow("position");
            optimum.end()?;
            Ok((Some(value), position))
        }
    }
}
