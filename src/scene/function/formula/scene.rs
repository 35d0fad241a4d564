//! Scenes whose function is a formula: their fields, and what is minimised.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    kernel::{
        Error, Message, Minimum,
        fields::{Fields, each, number, object, shown},
        objective::{Evaluation, Objective, Scratch, SearchBox},
    },
    message,
};

use super::{
    super::{
        body::FunctionScene,
        named::MAX_DIMENSION,
        read::{EXPRESSION, dimension},
    },
    Formula,
};

/// How far from 0 a side of the search box may be.
const FARTHEST: f64 = 1e15;

/// A formula over a box.
struct FormulaObjective {
    formula: Formula,
    search_box: SearchBox,
}

impl Objective for FormulaObjective {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation {
        self.formula.value(x, &mut scratch.numbers).into()
    }

    fn evaluate_all(&self, xs: &[f64], scratch: &mut Scratch, out: &mut [Evaluation]) {
        let mut out = out.iter_mut();
        self.formula.each_value(xs, &mut scratch.numbers, |value| {
            if let Some(out) = out.next() {
                *out = value.into();
            }
        });
    }

    fn refuses(&self, cost: f64) -> bool {
        !cost.is_finite()
    }
}

impl Formula {
    /// A scene in which it is minimised over a box of as many sides as it has variables; with the minimum and where that is, as far as
    /// they are known.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong: more than [`MAX_DIMENSION`] variables, a side without length or farther than 10¹⁵
    /// from 0, a position outside of the box, or one where the formula has another value than the minimum.
    ///
    /// ```
    /// use forage::{scene::Formula, swarm::objective::SearchBox};
    ///
    /// let bowl = Formula::new("(x - 1)^2 + y^2", 2)?.over(SearchBox::cube(2, -5.0, 5.0)?, Some(0.0), Some(vec![1.0, 0.0]))?;
    /// assert_eq!(bowl.value(&[3.0, 1.0]), 5.0);
    /// # Ok::<(), forage::Error>(())
    /// ```
    pub fn over(self, search_box: SearchBox, minimum: Option<f64>, minimiser: Option<Vec<f64>>) -> Result<FunctionScene, Error> {
        let (n, minimum) = (self.dimension, minimum.map(|value| Minimum { value, stated: true }));
        if n > MAX_DIMENSION {
            let allowed = message!("scene-most-variables", "a whole number from 1 to {most}", most = MAX_DIMENSION);
            return Err(Error::refused("dimension", n, allowed));
        }
        let (low, high) = (search_box.low(), search_box.high());
        if low.len() != n {
            return Err(Error::refused("bounds", low.len(), message!("scene-sides", "a number, or {n} of them, one for each variable", n)));
        }
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
            let value = self.value(minimiser, &mut Vec::new());
            if let Some(minimum) = minimum
                && (value.is_nan() || (value - minimum.value).abs() > minimum.rounding())
            {
                let allowed = message!("scene-minimum-there", "the value at its position, {value}", value);
                return Err(Error::refused("optimum.value", minimum.value, allowed));
            }
        }
        let mut fields = vec![
            (EXPRESSION, Value::from(self.text.as_str())),
            ("dimension", Value::from(n)),
            ("bounds", object(vec![("min", side(low)), ("max", side(high))])),
        ];
        if let Some(minimum) = minimum {
            fields.push((
                "optimum",
                match &minimiser {
                    Some(position) => object(vec![("value", Value::from(minimum.value)), ("position", Value::from(position.as_slice()))]),
                    None => Value::from(minimum.value),
                },
            ));
        }
        let objective = Arc::new(FormulaObjective { formula: self, search_box });
        Ok(FunctionScene::written(objective, fields, minimum, minimiser))
    }
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

/// Reads the fields of such a scene.
pub fn read(fields: &mut Fields) -> Result<FunctionScene, Error> {
    let text = fields.text(EXPRESSION)?;
    let n = dimension(fields)?;
    let formula = Formula::new(&text, n.min(MAX_DIMENSION + 1))?;
    let bounds = fields.take("bounds");
    let allowed = || message!("scene-box", "an object with min and max, each a number or a list of {n} numbers", n);
    let mut bounds = Fields::of("bounds", bounds, allowed())?;
    let low = sides(&mut bounds, "min", n)?;
    let high = sides(&mut bounds, "max", n)?;
    bounds.end()?;
    let (value, position) = optimum(fields)?;
    formula.over(SearchBox::of(low.into_iter().zip(high).map(|(low, high)| [low, high])), value, position)
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

/// The minimum and where it is, as far as they are stated.
fn optimum(fields: &mut Fields) -> Result<(Option<f64>, Option<Vec<f64>>), Error> {
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
