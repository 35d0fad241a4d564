//! The fields of a `tour` scene.

use serde_json::Value;

use crate::{
    exact::{Distances, MAX_MATRIX, Metric},
    kernel::{
        Error,
        error::list_of,
        fields::{Fields, number, points, shown},
    },
    message,
    scene::check::this_field,
};

use super::body::TourScene;

/// Its fields, in the order in which they are written.
pub(super) fn write(tour: &TourScene, out: &mut Vec<(&'static str, Value)>) {
    if !tour.points.is_empty() {
        out.push(("points", points(&tour.points)));
    }
    match &tour.matrix {
        Some(matrix) => {
            let row = |row: &[f64]| Value::Array(row.iter().copied().map(Value::from).collect());
            out.push(("matrix", Value::Array(matrix.rows().map(row).collect())));
        }
        None if tour.metric != Metric::default() => out.push(("metric", Value::from(tour.metric.name()))),
        None => {}
    }
    if !tour.closed {
        out.push(("closed", Value::Bool(false)));
    }
    if !tour.fixed.is_empty() {
        let pairs: Vec<[f64; 2]> = tour.fixed.iter().map(|pair| pair.map(|stop| stop as f64)).collect();
        out.push(("fixed", points(&pairs)));
    }
}

/// Reads its fields.
pub(super) fn read(fields: &mut Fields) -> Result<TourScene, Error> {
    let points = if fields.has("points") || !fields.has("matrix") {
        fields.points("points")?
    } else {
        fields.allow("points");
        Vec::new()
    };
    let mut scene = if fields.has("matrix") {
        if fields.has("metric") {
            let allowed = message!("scene-no-metric", "left out: the matrix gives the distances");
            return Err(Error::refused("metric", this_field(), allowed));
        }
        TourScene::by(matrix(fields)?, points)
    } else {
        fields.allow("matrix");
        let metric = if fields.has("metric") { fields.one_of("metric", Metric::ALL, Metric::name)? } else { Metric::default() };
        TourScene::through(points, metric)
    };
    fields.allow("metric");
    scene.closed = fields.flag("closed", true)?;
    fields.allow("fixed");
    if fields.has("fixed") {
        for pair in fields.points("fixed")? {
            // What is no number of a stop is one that there is not.
            scene.fixed.push(pair.map(|stop| if stop.fract() == 0.0 && stop >= 0.0 { stop as usize } else { usize::MAX }));
        }
    }
    Ok(scene)
}

/// As many rows as there are stops, each with as many numbers.
fn matrix(fields: &mut Fields) -> Result<Distances, Error> {
    let rows = fields.list("matrix")?;
    let n = rows.len();
    if n > MAX_MATRIX {
        return Err(Error::refused("matrix", list_of(n), message!("scene-most-stops", "at most {most} stops", most = MAX_MATRIX)));
    }
    let mut values = Vec::with_capacity(n * n);
    for (i, row) in rows.iter().enumerate() {
        let name = format!("matrix[{i}]");
        let row = row.as_array().filter(|row| row.len() == n).ok_or_else(|| {
            let allowed = message!("scene-matrix-row", "a list of {n} distances", n);
            Error::refused(&name, shown(row), allowed)
        })?;
        for (j, value) in row.iter().enumerate() {
            values.push(number(format!("{name}[{j}]"), value)?);
        }
    }
    Distances::new("matrix", n, values)
}
