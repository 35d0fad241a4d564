//! Pictures: fits beside published ones, log-log, what many runs converge to, and times over the number of stops.

use std::{error::Error, path::Path};

use plotters::{element::DashedPathElement, prelude::*};

use forage::math;

use super::{
    failure::Failure,
    fit::Fit,
    quantities::{Case, QUANTITIES, Range},
    svg::drawn,
};

const SIZE: (u32, u32) = (1040, 480);
/// For the smallest and the largest: apart without colours, too, by their symbols.
const COLOURS: [RGBColor; 2] = [RGBColor(0, 98, 155), RGBColor(200, 80, 0)];

/// N and M over D: points, our lines and the published ones (dashed).
///
/// # Errors
/// A file that cannot be written.
pub(super) fn draw(path: &Path, case: &Case, ranges: &[Range], fits: &[Option<Fit>; 4]) -> Result<(), Failure> {
    drawn(path, |out| picture(out, case, ranges, fits))
}

fn picture(out: &mut String, case: &Case, ranges: &[Range], fits: &[Option<Fit>; 4]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::with_string(out, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let largest = ranges.iter().flat_map(|range| [range.n[1], range.m[1]]).max().unwrap_or(0).max(250) as f64;
    for (k, area) in root.split_evenly((1, 2)).into_iter().enumerate() {
        let letter = ["N", "M"][k];
        let mut chart = ChartBuilder::on(&area)
            .caption(format!("{}: {letter} over D", case.title), ("sans-serif", 18))
            .margin(12)
            .x_label_area_size(38)
            .y_label_area_size(52)
            .build_cartesian_2d((4.5..22.0_f64).log_scale(), (3.0..largest * 1.3).log_scale())?;
        let label = |number: &f64| format!("{number:.0}");
        chart.configure_mesh().x_desc("D").y_desc(letter).x_label_formatter(&label).y_label_formatter(&label).draw()?;
        for (j, colour) in COLOURS.into_iter().enumerate() {
            let q = 2 * k + j;
            let (name, of) = QUANTITIES[q];
            let points = ranges.iter().map(|range| (range.d as f64, of(range) as f64));
            if j == 0 {
                chart.draw_series(points.map(|point| Circle::new(point, 4, colour.filled())))?;
            } else {
                chart.draw_series(points.map(|point| TriangleMarker::new(point, 6, colour.filled())))?;
            }
            let published = curve(case.published[q].b, [5.0, 20.0]);
            chart
                .draw_series(DashedLineSeries::new(published, 6, 4, colour.stroke_width(1)))?
                .label(format!("{name}, published"))
                .legend(move |(x, y)| DashedPathElement::new([(x, y), (x + 24, y)], 6, 4, colour.stroke_width(1)));
            if let (Some(fit), Some(first), Some(last)) = (fits[q], ranges.first(), ranges.last()) {
                chart
                    .draw_series(LineSeries::new(curve(fit.b, [first.d as f64, last.d as f64]), colour.stroke_width(2)))?
                    .label(format!("{name}, here, R² {:.3}", fit.r2))
                    .legend(move |(x, y)| PathElement::new([(x, y), (x + 24, y)], colour.stroke_width(2)));
            }
        }
        chart.configure_series_labels().position(SeriesLabelPosition::LowerRight).background_style(WHITE.mix(0.85)).draw()?;
    }
    root.present()?;
    Ok(())
}

/// A curve over the iterations.
pub(super) struct Curve<'a> {
    pub name: &'a str,
    pub points: Vec<[f64; 2]>,
}

/// Up to three curves over the logarithm of the iteration, apart without colours too, and a thin line at `least`.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn convergence(path: &Path, title: &str, curves: &[Curve], least: (&str, f64)) -> Result<(), Failure> {
    drawn(path, |out| lines(out, title, curves, least))
}

fn lines(out: &mut String, title: &str, curves: &[Curve], (name, least): (&str, f64)) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::with_string(out, (SIZE.0 * 7 / 10, SIZE.1)).into_drawing_area();
    root.fill(&WHITE)?;
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let last = points().map(|point| point[0]).fold(2.0, f64::max);
    let highest = points().map(|point| point[1]).fold(least, f64::max);
    let margin = 0.05 * (highest - least).max(0.01 * least);
    let mut chart = ChartBuilder::on(&root)
        .caption(title, ("sans-serif", 18))
        .margin(12)
        .x_label_area_size(38)
        .y_label_area_size(60)
        .build_cartesian_2d((1.0..last).log_scale(), least - margin..highest + margin)?;
    let label = |number: &f64| format!("{number:.0}");
    chart.configure_mesh().x_desc("iteration").y_desc("mean length of the best way").x_label_formatter(&label).draw()?;
    chart
        .draw_series(LineSeries::new([(1.0, least), (last, least)], BLACK.mix(0.6).stroke_width(1)))?
        .label(name)
        .legend(|(x, y)| PathElement::new([(x, y), (x + 24, y)], BLACK.mix(0.6).stroke_width(1)));
    // Whole, in long pieces, in short ones.
    let styles = [(1, 0, COLOURS[0]), (12, 5, COLOURS[1]), (3, 3, RGBColor(90, 60, 140))];
    for (curve, (piece, gap, colour)) in curves.iter().zip(styles) {
        let style = colour.stroke_width(2);
        chart
            .draw_series(DashedLineSeries::new(curve.points.iter().map(|&[x, y]| (x, y)), piece, gap, style))?
            .label(curve.name)
            .legend(move |(x, y)| DashedPathElement::new([(x, y), (x + 24, y)], piece, gap, style));
    }
    chart.configure_series_labels().position(SeriesLabelPosition::UpperRight).background_style(WHITE.mix(0.85)).draw()?;
    root.present()?;
    Ok(())
}

/// Milliseconds over the number of stops, both by their logarithms: a picture for each title, with a curve a planner.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn times(path: &Path, pictures: &[(&str, &[Curve])]) -> Result<(), Failure> {
    drawn(path, |out| over_stops(out, pictures))
}

/// The curves' colours, different in lightness too.
pub(super) const MANY: [RGBColor; 7] = [
    RGBColor(0, 98, 155),
    RGBColor(200, 80, 0),
    RGBColor(90, 60, 140),
    RGBColor(0, 130, 90),
    RGBColor(190, 30, 90),
    RGBColor(120, 100, 40),
    RGBColor(40, 40, 40),
];
/// A curve's piece and gap: whole, long, short, by turns.
pub(super) const DASHES: [(u32, u32); 3] = [(1, 0), (12, 5), (3, 3)];

fn over_stops(out: &mut String, pictures: &[(&str, &[Curve])]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::with_string(out, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    for (&(title, curves), area) in pictures.iter().zip(root.split_evenly((1, pictures.len()))) {
        let range = |axis: usize| {
            let values = || curves.iter().flat_map(|curve| &curve.points).map(move |point| point[axis]);
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
        };
        let ((left, right), (low, high)) = (range(0), range(1));
        let mut chart = ChartBuilder::on(&area)
            .caption(title, ("sans-serif", 18))
            .margin(12)
            .x_label_area_size(38)
            .y_label_area_size(60)
            .build_cartesian_2d((left / 1.1..right * 1.1).log_scale(), (low / 1.5..high * 1.5).log_scale())?;
        let (whole, number) = (|number: &f64| format!("{number:.0}"), |number: &f64| format!("{number}"));
        chart.configure_mesh().x_desc("stops").y_desc("ms").x_label_formatter(&whole).y_label_formatter(&number).draw()?;
        for (k, curve) in curves.iter().enumerate() {
            let (style, (piece, gap)) = (MANY[k % MANY.len()].stroke_width(2), DASHES[k % DASHES.len()]);
            chart
                .draw_series(DashedLineSeries::new(curve.points.iter().map(|&[x, y]| (x, y)), piece, gap, style))?
                .label(curve.name)
                .legend(move |(x, y)| DashedPathElement::new([(x, y), (x + 24, y)], piece, gap, style));
            chart.draw_series(curve.points.iter().map(|&[x, y]| Circle::new((x, y), 3, style.filled())))?;
        }
        chart.configure_series_labels().position(SeriesLabelPosition::UpperLeft).background_style(WHITE.mix(0.85)).draw()?;
    }
    root.present()?;
    Ok(())
}

/// exp(b0) D^b1, close enough together for dashes.
fn curve([b0, b1]: [f64; 2], [from, to]: [f64; 2]) -> Vec<(f64, f64)> {
    const PIECES: usize = 60;
    let at = |i: usize| from * math::pow(to / from, i as f64 / PIECES as f64);
    (0..=PIECES).map(at).map(|d| (d, math::exp(b0 + b1 * math::ln(d)))).collect()
}
