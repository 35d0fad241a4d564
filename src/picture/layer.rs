//! A field layer of a frame as pixels: pheromone, the cells that a search has settled.

use crate::{
    describe::{Layer, Rgba, color_at},
    geometry::Bounds,
    kernel::{Frame, Shape, VERTEX},
};

/// A field as a picture, a pixel for each value, transparent where there is nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// RGBA, the row of the smallest y first.
    pub pixels: Vec<u8>,
    /// The part of the plane that it covers.
    pub bounds: Bounds,
    /// The smallest and the largest value.
    pub range: [f64; 2],
}

/// The field of a layer in a drawn frame, in these colours from the smallest value to the largest; `None` if it has none. Where the
/// layer's ramp says so, the square root is shown: a path's weak beginnings are what one looks for.
pub fn raster(frame: &Frame, layer: &Layer, colors: &[Rgba]) -> Option<Raster> {
    let ramp = layer.look.ramp?;
    let span = frame.spans().find(|span| span.layer == layer.key && span.shape == Shape::Field && span.count > 0)?;
    let values = &frame.vertices()[span.first as usize * VERTEX..][..span.count as usize * VERTEX];
    let width = values[2] as usize;
    let height = span.count as usize / width.max(1);
    let weights = || values.chunks_exact(VERTEX).map(|v| f64::from(v[3]));
    let shown = || weights().filter(|&w| w >= 0.0);
    let (low, high) = shown().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), w| (low.min(w), high.max(w)));
    let share = |w: f64| if high > low { (w - low) / (high - low) } else { 0.0 };
    let shade = |w: f64| color_at(colors, if ramp.root { share(w).sqrt() } else { share(w) }).map(|channel| channel as u8);
    let mut pixels = Vec::with_capacity(4 * span.count as usize);
    weights().for_each(|w| pixels.extend(if w < 0.0 { [0; 4] } else { shade(w) }));
    // Half a square beyond the middles of the outermost squares.
    let side = match (width, height) {
        (2.., _) => values[VERTEX] - values[0],
        (_, 2..) => values[VERTEX * width + 1] - values[1],
        _ => 1.0,
    };
    let half = f64::from(side) / 2.0;
    let last = &values[values.len() - VERTEX..];
    let bounds = Bounds {
        min: [f64::from(values[0]) - half, f64::from(values[1]) - half],
        max: [f64::from(last[0]) + half, f64::from(last[1]) + half],
    };
    let range = if low <= high { [low, high] } else { [0.0, 0.0] };
    Some(Raster { width, height, pixels, bounds, range })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::describe::layers::{CLOSED, PHEROMONE};

    #[test]
    fn a_pixel_a_value_and_the_squares_they_stand_for() {
        let mut frame = Frame::default();
        frame.clear(100, [PHEROMONE.key]);
        frame.begin(PHEROMONE.key, Shape::Field);
        for (i, w) in [0.0, 1.0, 4.0, -1.0, 0.0, 2.0].into_iter().enumerate() {
            frame.push_field([(i % 3) as f64 * 2.0 + 1.0, (i / 3) as f64 * 2.0 + 1.0], 3, w);
        }
        let picture = raster(&frame, &PHEROMONE, &PHEROMONE.look.ramp.unwrap().on(false)).unwrap();
        assert_eq!((picture.width, picture.height, picture.range), (3, 2, [0.0, 4.0]));
        assert_eq!((picture.bounds.min, picture.bounds.max), ([0.0, 0.0], [6.0, 4.0]));
        assert_eq!(picture.pixels[8..12], [88, 40, 140, 200], "the strongest");
        assert_eq!(picture.pixels[4..8], [123, 94, 167, 136], "the root of a quarter is the middle");
        assert_eq!((picture.pixels[3], picture.pixels[15]), (0, 0), "the weakest and nothing are transparent");
        assert!(raster(&frame, &CLOSED, &[]).is_none());
    }
}
