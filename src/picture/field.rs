//! A function's heights as pixels, with contours.

use crate::{
    describe::{Rgba, color_at},
    geometry::Bounds,
    math,
    scene::{FunctionScene, Scene},
};

const CONTOURS: f64 = 14.0;

/// A function's heights as a picture.
pub struct HeatMap {
    /// RGBA, row by row, the top one first.
    pub pixels: Vec<u8>,
    /// The values of the first colour, of the one in the middle and of the last.
    pub heights: [f64; 3],
}

/// The function over `view` as `width` × `height` RGBA pixels, top row first, in these colours from the lowest value to the highest: by
/// rank, so that every part of a landscape shows its shape, however steep the rest; lines between levels, lighter than colours that end
/// dark and darker than others. Where the function has no finite value it is transparent. `None` for scenes without a height, and where
/// none is finite.
pub fn heat_map(scene: &Scene, view: Bounds, width: usize, height: usize, colors: &[Rgba]) -> Option<HeatMap> {
    let function = scene.get::<FunctionScene>().ok()?;
    let at = |i: usize, n: usize, axis: usize| view.min[axis] + (i as f64 + 0.5) / n as f64 * (view.max[axis] - view.min[axis]);
    let mut values = vec![0.0; width * height];
    let mut points = Vec::with_capacity(width);
    for (row, values) in (0..height).rev().zip(values.chunks_exact_mut(width.max(1))) {
        points.clear();
        points.extend((0..width).map(|column| [at(column, width, 0), at(row, height, 1)]));
        function.section(&points, values);
    }
    let heights = equalise(&mut values);
    if !heights[0].is_finite() {
        return None;
    }
    let ends_dark = colors.last().is_some_and(|color| color[..3].iter().map(|&channel| u32::from(channel)).sum::<u32>() < 3 * 128);
    let contrast = if ends_dark { 1.25 } else { 0.86 };
    let mut pixels = Vec::with_capacity(4 * values.len());
    for (i, &t) in values.iter().enumerate() {
        let level = |v: f64| (v * CONTOURS).floor();
        let right = if (i + 1) % width == 0 { t } else { values[i + 1] };
        let below = values.get(i + width).copied().unwrap_or(t);
        let line = level(t) != level(right) || level(t) != level(below);
        if t.is_nan() {
            pixels.extend([0; 4]);
            continue;
        }
        let [r, g, b, opacity] = color_at(colors, t);
        let shade = if line { contrast } else { 1.0 };
        pixels.extend([r, g, b].map(|channel| (channel * shade).min(255.0) as u8));
        pixels.push(opacity as u8);
    }
    Some(HeatMap { pixels, heights })
}

/// Replaces values by the share of values that are lower (0 to 1), by a histogram over the logarithm of the height. Returns
/// the lowest value, the one in the middle of the shares, and the highest. What is not finite becomes NaN.
fn equalise(values: &mut [f64]) -> [f64; 3] {
    const BINS: usize = 4096;
    let finite = |v: &&f64| v.is_finite();
    let (low, high) = values.iter().filter(finite).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
    let scale = ((high - low) * 1e-5).max(f64::MIN_POSITIVE);
    let whole = math::ln(1.0 + (high - low) / scale).max(f64::MIN_POSITIVE);
    let place = |v: f64| math::ln(1.0 + (v - low) / scale) / whole * (BINS - 1) as f64;
    let mut count = vec![0_u32; BINS + 1];
    values.iter().filter(finite).for_each(|&v| count[place(v) as usize + 1] += 1);
    for bin in 0..BINS {
        count[bin + 1] += count[bin];
    }
    let total = f64::from(count[BINS].max(1));
    let (mut middle, mut off) = (low, f64::INFINITY);
    for v in values.iter_mut() {
        if !v.is_finite() {
            *v = f64::NAN;
            continue;
        }
        // Half by rank and half by height: rank alone would make a plain of a valley.
        let at = place(*v);
        let bin = at as usize;
        let rank = (f64::from(count[bin]) + (at - bin as f64) * f64::from(count[bin + 1] - count[bin])) / total;
        let share = f64::midpoint(rank, at / (BINS - 1) as f64);
        if (share - 0.5).abs() < off {
            (middle, off) = (*v, (share - 0.5).abs());
        }
        *v = share;
    }
    [low, middle, high]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{describe::layers::HEIGHTS, shipped};

    #[test]
    fn it_is_brightest_at_the_minimum_and_darkens_uphill() {
        let scene = shipped("matyas").unwrap();
        let side = 65;
        let dark = HEIGHTS.map(|color| color.on(true));
        let HeatMap { pixels, heights: [low, middle, high] } = heat_map(&scene, scene.view(), side, side, &dark).unwrap();
        assert!(low >= 0.0 && low < middle && middle < high && high <= 104.0 && high > 90.0, "Matyas: 104 at the farthest corners");
        assert_eq!(pixels.len(), side * side * 4);
        let brightness = |column: usize, row: usize| pixels[4 * (row * side + column)..][..3].iter().map(|&c| u32::from(c)).sum::<u32>();
        // The valley of Matyas runs along the diagonal x = y: lower left to upper right, the top row first.
        let (middle, along, across) = (brightness(32, 32), brightness(42, 22), brightness(42, 42));
        assert!(middle > along && along > across, "{middle} {along} {across}");
        assert!(heat_map(&shipped("wcpso-discs").unwrap(), scene.view(), 8, 8, &dark).is_none());
    }
}
