//! Plots that compare planners: curves over linear or logarithmic axes, ratios with intervals, mean ranks.

use std::{error::Error, io, ops::Range, path::Path};

use plotters::{
    coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter},
    element::DashedPathElement,
    prelude::*,
    style::text_anchor::{HPos, Pos, VPos},
};

use super::{
    chart::{DASHES, MANY},
    disk,
    failure::Failure,
    svg::drawn,
};

const SIZE: (u32, u32) = (900, 560);
/// An axis: what it is of, from where to where, and whether by logarithms.
pub(crate) struct Axis {
    pub title: &'static str,
    pub range: Range<f64>,
    pub log: bool,
}

impl Axis {
    /// An axis by logarithms around all values that are above 0.
    pub(crate) fn log(title: &'static str, values: impl Iterator<Item = f64>) -> Self {
        let (least, most) = values.filter(|value| *value > 0.0).fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        let range = if least < most { least..most } else { most.max(1e-9) / 2.0..most.max(1e-9) * 2.0 };
        // Only powers of ten have labels: two at least are within.
        let decade = |mut power: f64, bound: f64| {
            while power > bound {
                power /= 10.0;
            }
            while power * 10.0 <= bound {
                power *= 10.0;
            }
            power
        };
        let (low, high) = (decade(1.0, range.start), 10.0 * decade(1.0, range.end));
        let range = if decade(1.0, range.end) >= range.start * 10.0 { range } else { low..high };
        Self { title, range, log: true }
    }

    /// An axis from `least` to somewhat above the largest value.
    pub(crate) fn linear(title: &'static str, least: f64, values: impl Iterator<Item = f64>) -> Self {
        let most = values.fold(least, f64::max);
        Self { title, range: least..if most > least { most + 0.02 * (most - least) } else { least + 1.0 }, log: false }
    }
}

/// A planner's curve.
pub(crate) struct Curve {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

impl Curve {
    /// The empirical cumulative distribution of sorted `numbers` among `all`, as steps between `from` and `to`.
    pub(crate) fn ecdf(name: &str, numbers: &[f64], all: usize, [from, to]: [f64; 2]) -> Self {
        let share = |count: usize| count as f64 / all.max(1) as f64;
        let first = numbers.partition_point(|number| *number <= from);
        let mut points = vec![(from, share(first))];
        for (k, at) in numbers.iter().enumerate().skip(first).filter(|(_, number)| **number <= to) {
            // Equal numbers are one step.
            if numbers.get(k + 1) != Some(at) {
                let before = points.last().map_or(0.0, |point| point.1);
                points.extend([(*at, before), (*at, share(k + 1))]);
            }
        }
        points.push((to, points.last().map_or(0.0, |point| point.1)));
        Self { name: name.to_owned(), points }
    }
}

/// Removes a picture of an earlier time that is not drawn again.
pub(crate) fn remove(path: &Path) -> Result<(), Failure> {
    match disk::remove(path) {
        Err(problem) if problem.kind() != io::ErrorKind::NotFound => Err(Failure::File(path.to_owned(), problem)),
        _ => Ok(()),
    }
}

/// Draws curves, with a legend at the given position.
///
/// # Errors
/// A file that cannot be written.
pub(crate) fn draw(path: &Path, x: &Axis, y: &Axis, curves: &[Curve], legend: SeriesLabelPosition) -> Result<(), Failure> {
    let ([a, b], [c, d]) = ([x, y].map(|axis| axis.range.clone()), [x, y].map(|axis| axis.range.clone()));
    drawn(path, |out| match (x.log, y.log) {
        (false, false) => picture(out, [x.title, y.title], a, b, curves, legend),
        (true, false) => picture(out, [x.title, y.title], a.log_scale(), b, curves, legend),
        (false, true) => picture(out, [x.title, y.title], c, d.log_scale(), curves, legend),
        (true, true) => picture(out, [x.title, y.title], c.log_scale(), d.log_scale(), curves, legend),
    })
}

/// A value with its interval, on a line of its own.
pub(crate) struct Bar {
    pub name: String,
    pub value: f64,
    pub interval: Option<[f64; 2]>,
}

/// Draws ratios with their intervals over a logarithmic axis, one below the other, and a line at 1.
///
/// # Errors
/// A file that cannot be written.
pub(crate) fn draw_ratios(path: &Path, title: &str, bars: &[Bar]) -> Result<(), Failure> {
    let ends = bars.iter().flat_map(|bar| bar.interval.unwrap_or([bar.value; 2])).filter(|end| *end > 0.0);
    let (low, high) = ends.fold((0.5_f64, 2.0_f64), |(low, high), end| (low.min(end), high.max(end)));
    drawn(path, |out| intervals(out, title, bars, (low / 1.2..high * 1.2).log_scale(), 1.0))
}

/// Draws values from 0 on with their intervals, one below the other.
///
/// # Errors
/// A file that cannot be written.
pub(crate) fn draw_values(path: &Path, title: &str, bars: &[Bar]) -> Result<(), Failure> {
    let most = bars.iter().map(|bar| bar.interval.map_or(bar.value, |[_, high]| high)).fold(1e-9, f64::max);
    drawn(path, |out| intervals(out, title, bars, 0.0..most * 1.05, 0.0))
}

fn intervals<X>(out: &mut String, title: &str, bars: &[Bar], x: X, line: f64) -> Result<(), Box<dyn Error>>
where
    X: AsRangedCoord<Value = f64, CoordDescType: ValueFormatter<f64>>,
    <X as AsRangedCoord>::CoordDescType: Ranged<ValueType = f64>,
{
    let root = SVGBackend::with_string(out, (SIZE.0, 70 + 30 * bars.len() as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    let longest = bars.iter().map(|bar| bar.name.chars().count()).max().unwrap_or(0) as u32;
    let mut chart = ChartBuilder::on(&root)
        .margin(14)
        .x_label_area_size(42)
        .y_label_area_size((7 * longest + 20).max(150))
        .build_cartesian_2d(x, -0.5..bars.len() as f64 - 0.5)?;
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
    chart.draw_series([PathElement::new([(line, -0.5), (line, bars.len() as f64 - 0.5)], BLACK.mix(0.5))])?;
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

/// A planner with its mean rank.
pub(crate) struct Ranked {
    pub name: String,
    pub rank: f64,
}

/// Draws mean ranks along a line, the names below, and a bar over those that do not differ.
///
/// # Errors
/// A file that cannot be written.
pub(crate) fn draw_ranks(path: &Path, ranked: &[Ranked], difference: f64, bars: &[Vec<usize>]) -> Result<(), Failure> {
    drawn(path, |out| ranks(out, ranked, difference, bars))
}

fn ranks(out: &mut String, ranked: &[Ranked], difference: f64, bars: &[Vec<usize>]) -> Result<(), Box<dyn Error>> {
    const LINE: i32 = 22;
    let rows = ranked.len().div_ceil(2) as i32;
    let axis = 70;
    let below = axis + 14 + 9 * bars.len() as i32;
    // Names and ranks have room at both sides.
    let longest = ranked.iter().map(|one| one.name.chars().count()).max().unwrap_or(0) as i32;
    let side = (8 * longest + 90).max(190);
    let size = ((SIZE.0 as i32 + 2 * (side - 190)) as u32, (below + LINE * rows + 24) as u32);
    let root = SVGBackend::with_string(out, size).into_drawing_area();
    root.fill(&WHITE)?;
    let wide = f64::from(size.0 as i32 - 2 * side);
    let last = ranked.len().max(2) as f64;
    let at = |rank: f64| side + ((rank - 1.0) / (last - 1.0) * wide).round() as i32;
    let text = |anchor: HPos, size: i32| TextStyle::from(("sans-serif", size)).pos(Pos::new(anchor, VPos::Center));
    let line = |points: Vec<(i32, i32)>, width: u32| PathElement::new(points, BLACK.stroke_width(width));
    root.draw(&line(vec![(at(1.0), axis), (at(last), axis)], 1))?;
    for rank in 1..=ranked.len() {
        root.draw(&line(vec![(at(rank as f64), axis - 5), (at(rank as f64), axis)], 1))?;
        root.draw(&Text::new(rank.to_string(), (at(rank as f64), axis - 15), text(HPos::Center, 13)))?;
    }
    // How far apart ranks must be to differ.
    let end = side + (difference / (last - 1.0) * wide).round() as i32;
    root.draw(&line(vec![(side, 28), (end.min(size.0 as i32 - 20), 28)], 2))?;
    root.draw(&Text::new(format!("critical difference {difference:.2}"), (side, 14), text(HPos::Left, 13)))?;
    for (k, bar) in bars.iter().enumerate() {
        let [first, last] = [bar.first(), bar.last()].map(|one| one.map_or(1.0, |&one| ranked[one].rank));
        let height = axis + 9 + 9 * k as i32;
        root.draw(&line(vec![(at(first) - 4, height), (at(last) + 4, height)], 4))?;
    }
    let mut order: Vec<&Ranked> = ranked.iter().collect();
    order.sort_by(|a, b| a.rank.total_cmp(&b.rank));
    // The better half to the left, the best on top; the worse half to the right, the worst on top: so lines do not cross.
    for (k, one) in order.iter().enumerate() {
        let left = k < order.len().div_ceil(2);
        let row = if left { k } else { order.len() - 1 - k } as i32;
        let height = below + LINE * row + LINE / 2;
        let (edge, name, anchor) =
            if left { (side - 20, side - 26, HPos::Right) } else { (size.0 as i32 - side + 20, size.0 as i32 - side + 26, HPos::Left) };
        root.draw(&line(vec![(at(one.rank), axis), (at(one.rank), height), (edge, height)], 1))?;
        root.draw(&Text::new(format!("{} {:.2}", one.name, one.rank), (name, height), text(anchor, 13)))?;
    }
    root.present()?;
    Ok(())
}

fn picture<X, Y>(
    out: &mut String,
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
    let root = SVGBackend::with_string(out, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart =
        ChartBuilder::on(&root).margin(14).margin_right(34).x_label_area_size(42).y_label_area_size(64).build_cartesian_2d(x, y)?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_steps() {
        let Curve { points, .. } = Curve::ecdf("", &[1.0, 2.0, 2.0, 5.0, 9.0], 10, [1.0, 8.0]);
        assert_eq!(points, [(1.0, 0.1), (2.0, 0.1), (2.0, 0.3), (5.0, 0.3), (5.0, 0.4), (8.0, 0.4)]);
        assert_eq!(Curve::ecdf("", &[], 0, [1.0, 2.0]).points, [(1.0, 0.0), (2.0, 0.0)]);
    }
}
