//! What a script gives back, as data.

use serde_json::Value;

use crate::{
    kernel::{
        Candidate, Error, Inspection, Item, Message, Solution, TourEnds,
        fields::{Fields, each, number, shown},
    },
    message,
};

/// A solution: its `cost`, and a `position`, a `path` of corners or an `order` of stops. Null: none yet.
///
/// # Errors
/// The field that is wrong, its value and what is allowed.
pub fn candidate(value: Value) -> Result<Option<Candidate>, Error> {
    if value.is_null() {
        return Ok(None);
    }
    let mut fields =
        Fields::of("best", value, message!("script-best", "nothing, or an object with a cost and a position, a path or an order"))?;
    let cost = fields.number("cost")?;
    let solution = if fields.has("path") {
        Solution::Path(fields.points("path")?)
    } else if fields.has("order") {
        let order = each("best.order", fields.list("order")?, |at, value| {
            let stop = number(at.to_owned(), &value)?;
            let whole = stop.fract() == 0.0 && (0.0..1e9).contains(&stop);
            if whole {
                Ok(stop as usize)
            } else {
                Err(Error::refused(at, shown(&value), message!("script-stop", "the number of a stop, from 0")))
            }
        })?;
        Solution::Tour { order, ends: TourEnds::default(), path: Vec::new() }
    } else {
        Solution::Position(each("best.position", fields.list("position")?, |at, value| number(at.to_owned(), &value))?)
    };
    fields.end()?;
    Ok(Some(Candidate { cost, solution }))
}

/// An explanation of an item: a text, or an object with a `title` and a `summary`. Null: none.
///
/// # Errors
/// The field that is wrong, its value and what is allowed.
pub fn inspection(item: Item, value: Value) -> Result<Option<Inspection>, Error> {
    let said = |title: String, summary: String| {
        let title = if title.is_empty() { format!("{} {}", item.layer.0, item.index + 1) } else { title };
        Some(Inspection::new(item, Message::verbatim(title), "", Message::verbatim(summary)))
    };
    match value {
        Value::Null => Ok(None),
        Value::String(summary) => Ok(said(String::new(), summary)),
        other => {
            let mut fields = Fields::of("explain", other, message!("script-explained", "a text, or an object with a title and a summary"))?;
            let (title, summary) = (fields.optional_text("title")?.unwrap_or_default(), fields.text("summary")?);
            fields.end()?;
            Ok(said(title, summary))
        }
    }
}

/// What is said of code that uses what is lent to it at another time.
pub fn not_lent() -> Error {
    Error::refused("tools", "a call from elsewhere", message!("script-lent", "used only while `start` or `advance` runs"))
}

/// What is said of code that threw something.
pub fn threw(error: &str) -> Message {
    message!("script-threw", "its code throws “{error}”", error)
}
