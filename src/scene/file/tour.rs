//! The fields of a `tour` scene.

use serde_json::Value;

use crate::kernel::Error;

use super::{
    super::{Distances, MAX_STOPS, Metric, TourScene},
    Fields, number, point_of, points, shown,
};

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
}

impl Fields {
    pub(super) fn tour(&mut self) -> Result<TourScene, Error> {
        let has = |fields: &Self, name: &str| fields.left.contains_key(name);
        let points = if has(self, "points") || !has(self, "matrix") {
            let list = self.list("points")?;
            list.iter().enumerate().map(|(i, point)| point_of(&format!("points[{i}]"), point)).collect::<Result<_, _>>()?
        } else {
            self.known.push("points");
            Vec::new()
        };
        let mut scene = if has(self, "matrix") {
            if has(self, "metric") {
                return Err(Error::refused("metric", "this field", "left out: the matrix gives the distances"));
            }
            TourScene::by(self.matrix()?, points)
        } else {
            self.known.push("matrix");
            let metric = if has(self, "metric") { self.one_of("metric", Metric::ALL, Metric::name)? } else { Metric::default() };
            TourScene::through(points, metric)
        };
        self.known.push("metric");
        scene.closed = self.flag("closed", true)?;
        Ok(scene)
    }

    /// As many rows as there are stops, each with as many numbers.
    fn matrix(&mut self) -> Result<Distances, Error> {
        let rows = self.list("matrix")?;
        let n = rows.len();
        if n > MAX_STOPS {
            return Err(Error::refused("matrix", format!("a list of {n}"), format!("at most {MAX_STOPS} stops")));
        }
        let mut values = Vec::with_capacity(n * n);
        for (i, row) in rows.iter().enumerate() {
            let name = format!("matrix[{i}]");
            let row = row
                .as_array()
                .filter(|row| row.len() == n)
                .ok_or_else(|| Error::refused(&name, shown(row), format!("a list of {n} distances")))?;
            for (j, value) in row.iter().enumerate() {
                values.push(number(format!("{name}[{j}]"), value)?);
            }
        }
        Distances::new("matrix", n, values)
    }
}
