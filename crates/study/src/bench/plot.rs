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

/// A value with its interval, on a line of its own.
pub(super) struct Bar {
    pub name: String,
    pub value: f64,
    pub interval: Option<[f64; 2]>,
}

/// Draws values with their intervals over a logarithmic axis, one below the other, and a line at 1.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn draw_ratios(path: &Path, title: &str, bars: &[Bar]) -> Result<(), Failure> {
    ratios(path, title, bars).map_err(|problem| Failure::File(path.to_owned(), io::Error::other(problem.to_string())))
}

fn ratios(path: &Path, title: &str, bars: &[Bar]) -> Result<(), Box<dyn Error>> {
    let ends = bars.iter().flat_map(|bar| bar.interval.unwrap_or([bar.value; 2])).filter(|end| *end > 0.0);
    let (low, high) = ends.fold((0.5_f64, 2.0_f64), |(low, high), end| (low.min(end), high.max(end)));
    let root = SVGBackend::new(path, (SIZE.0, 70 + 30 * bars.len() as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .margin(14)
        .x_label_area_size(42)
        .y_label_area_size(150)
        .build_cartesian_2d((low / 1.2..high * 1.2).log_scale(), -0.5..bars.len() as f64 - 0.5)?;
    // The first is at the top.
    let place = |k: usize| (bars.len() - 1 - k) as f64;
    let name = |y: &f64| {
        let k = bars.len() as f64 - 1.0 - y.round();
        let bar = bars.get(k as usize).filter(|_| k >= 0.0 && (y - y.round()).abs() < 1e-9);
        bar.map_or(String::new(), |bar| bar.name.clone())
    };
    let label = |number: &f64| format!("{}", (number * 1e9).round() / 1e9);
    chart
        .configure_mesh()
        .x_desc(title)
        .y_labels(2 * bars.len())
        .disable_y_mesh()
        .x_label_formatter(&label)
        .y_label_formatter(&name)
        .draw()?;
    chart.draw_series([PathElement::new([(1.0, -0.5), (1.0, bars.len() as f64 - 0.5)], BLACK.mix(0.5))])?;
    let colour = MANY[0];
    for (k, bar) in bars.iter().enumerate() {
        if let Some([low, high]) = bar.interval {
            chart.draw_series([PathElement::new([(low, place(k)), (high, place(k))], colour.stroke_width(3))])?;
        }
        chart.draw_series([Circle::new((bar.value, place(k)), 5, colour.filled())])?;
    }
    root.present()?;
    Ok(())
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
