//! Pictures of suites: a curve for each planner, over linear or logarithmic axes.

use std::{error::Error, io, ops::Range, path::Path};

use plotters::{
    coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter},
    element::DashedPathElement,
    prelude::*,
};

use super::super::{
    chart::{DASHES, MANY},
    failure::Failure,
};

const SIZE: (u32, u32) = (900, 560);
/// An axis: what it is of, from where to where, and whether by logarithms.
pub(super) struct Axis {
    pub title: &'static str,
    pub range: Range<f64>,
    pub log: bool,
}

impl Axis {
    /// An axis by logarithms around all values that are above 0.
    pub(super) fn log(title: &'static str, values: impl Iterator<Item = f64>) -> Self {
        let (least, most) = values.filter(|value| *value > 0.0).fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        let range = if least < most { least..most } else { most.max(1e-9) / 2.0..most.max(1e-9) * 2.0 };
        Self { title, range, log: true }
    }

    /// An axis from `least` to somewhat above the largest value.
    pub(super) fn linear(title: &'static str, least: f64, values: impl Iterator<Item = f64>) -> Self {
        let most = values.fold(least, f64::max);
        Self { title, range: least..if most > least { most + 0.02 * (most - least) } else { least + 1.0 }, log: false }
    }
}

/// A planner's curve.
pub(super) struct Curve {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

/// Draws curves, with the names where there is room for them.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn draw(path: &Path, x: &Axis, y: &Axis, curves: &[Curve], legend: SeriesLabelPosition) -> Result<(), Failure> {
    let ([a, b], [c, d]) = ([x, y].map(|axis| axis.range.clone()), [x, y].map(|axis| axis.range.clone()));
    let done = match (x.log, y.log) {
        (false, false) => picture(path, [x.title, y.title], a, b, curves, legend),
        (true, false) => picture(path, [x.title, y.title], a.log_scale(), b, curves, legend),
        (false, true) => picture(path, [x.title, y.title], c, d.log_scale(), curves, legend),
        (true, true) => picture(path, [x.title, y.title], c.log_scale(), d.log_scale(), curves, legend),
    };
    done.map_err(|problem| Failure::File(path.to_owned(), io::Error::other(problem.to_string())))
}

fn picture<X, Y>(
    path: &Path,
    [across, up]: [&str; 2],
    x: X,
    y: Y,
    curves: &[Curve],
    legend: SeriesLabelPosition,
) -> Result<(), Box<dyn Error>>
where
    X: AsRangedCoord<Value = f64, CoordDescType: ValueFormatter<f64>>,
    Y: AsRangedCoord<Value = f64, CoordDescType: ValueFormatter<f64>>,
    <X as AsRangedCoord>::CoordDescType: Ranged<ValueType = f64>,
    <Y as AsRangedCoord>::CoordDescType: Ranged<ValueType = f64>,
{
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root).margin(14).x_label_area_size(42).y_label_area_size(64).build_cartesian_2d(x, y)?;
    let label = |number: &f64| format!("{}", (number * 1e9).round() / 1e9);
    chart.configure_mesh().x_desc(across).y_desc(up).x_label_formatter(&label).y_label_formatter(&label).draw()?;
    for (k, curve) in curves.iter().enumerate() {
        let (colour, (piece, gap)) = (MANY[k % MANY.len()], DASHES[k / MANY.len() % DASHES.len()]);
        let style = colour.stroke_width(2);
        chart
            .draw_series(DashedLineSeries::new(curve.points.iter().copied(), piece, gap, style))?
            .label(&curve.name)
            .legend(move |(x, y)| DashedPathElement::new([(x, y), (x + 24, y)], piece, gap, style));
    }
    chart.configure_series_labels().position(legend).background_style(WHITE.mix(0.85)).draw()?;
    root.present()?;
    Ok(())
}
