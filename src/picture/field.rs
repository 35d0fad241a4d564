//! A function's heights as pixels, with contours.

use crate::{
    geometry::Bounds,
    math,
    scene::{FunctionScene, Scene},
};

/// Colours from the lowest to the highest value: calm, and monotone in lightness so that they also read in grey.
const LIGHT: [[f64; 3]; 5] =
    [[60.0, 96.0, 88.0], [122.0, 158.0, 140.0], [181.0, 203.0, 184.0], [222.0, 230.0, 214.0], [246.0, 244.0, 234.0]];
const DARK: [[f64; 3]; 5] = [[120.0, 190.0, 165.0], [62.0, 122.0, 112.0], [34.0, 76.0, 76.0], [21.0, 46.0, 50.0], [14.0, 26.0, 30.0]];
const CONTOURS: f64 = 14.0;

/// The function over `view` as `width` × `height` RGBA pixels, top row first: colours by rank, so that every part
/// of a landscape shows its shape, however steep the rest; lines between levels. `None` for scenes without a height.
pub fn heat_map(scene: &Scene, view: Bounds, width: usize, height: usize, dark: bool) -> Option<Vec<u8>> {
    let function = scene.get::<FunctionScene>().ok()?;
    let mut x = function.minimiser();
    let at = |i: usize, n: usize, axis: usize| view.min[axis] + (i as f64 + 0.5) / n as f64 * (view.max[axis] - view.min[axis]);
    let mut values = Vec::with_capacity(width * height);
    for row in (0..height).rev() {
        values.extend((0..width).map(|column| function.section([at(column, width, 0), at(row, height, 1)], &mut x)));
    }
    equalise(&mut values);
    let stops = if dark { &DARK } else { &LIGHT };
    let mut pixels = Vec::with_capacity(4 * values.len());
    for (i, &t) in values.iter().enumerate() {
        let level = |v: f64| (v * CONTOURS).floor();
        let right = if (i + 1) % width == 0 { t } else { values[i + 1] };
        let below = values.get(i + width).copied().unwrap_or(t);
        let line = level(t) != level(right) || level(t) != level(below);
        let shade = if line { if dark { 1.25 } else { 0.86 } } else { 1.0 };
        pixels.extend(colour(stops, t).map(|c| (c * shade).min(255.0) as u8));
        pixels.push(255);
    }
    Some(pixels)
}

/// Replaces values by the share of values that are lower (0 to 1), by a histogram over the logarithm of the height.
fn equalise(values: &mut [f64]) {
    const BINS: usize = 4096;
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
    let scale = ((high - low) * 1e-5).max(f64::MIN_POSITIVE);
    let whole = math::ln(1.0 + (high - low) / scale).max(f64::MIN_POSITIVE);
    let place = |v: f64| math::ln(1.0 + (v - low) / scale) / whole * (BINS - 1) as f64;
    let mut count = vec![0_u32; BINS + 1];
    values.iter().for_each(|&v| count[place(v) as usize + 1] += 1);
    for bin in 0..BINS {
        count[bin + 1] += count[bin];
    }
    let total = values.len().max(1) as f64;
    for v in values.iter_mut() {
        // Half by rank and half by height: rank alone would make a plain of a valley.
        let at = place(*v);
        let bin = at as usize;
        let rank = (f64::from(count[bin]) + (at - bin as f64) * f64::from(count[bin + 1] - count[bin])) / total;
        *v = f64::midpoint(rank, at / (BINS - 1) as f64);
    }
}

fn colour(stops: &[[f64; 3]; 5], t: f64) -> [f64; 3] {
    let along = t.clamp(0.0, 1.0) * 4.0;
    let i = (along as usize).min(3);
    let part = along - i as f64;
    std::array::from_fn(|c| stops[i][c] + part * (stops[i + 1][c] - stops[i][c]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    #[test]
    fn it_is_brightest_at_the_minimum_and_darkens_uphill() {
        let scene = shipped("matyas").unwrap();
        let side = 65;
        let pixels = heat_map(&scene, scene.view(), side, side, true).unwrap();
        assert_eq!(pixels.len(), side * side * 4);
        let brightness = |column: usize, row: usize| pixels[4 * (row * side + column)..][..3].iter().map(|&c| u32::from(c)).sum::<u32>();
        // The valley of Matyas runs along the diagonal x = y: lower left to upper right, the top row first.
        let (middle, along, across) = (brightness(32, 32), brightness(42, 22), brightness(42, 42));
        assert!(middle > along && along > across, "{middle} {along} {across}");
        assert!(heat_map(&shipped("wcpso-discs").unwrap(), scene.view(), 8, 8, true).is_none());
    }
}
