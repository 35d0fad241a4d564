//! A field layer of a frame as pixels: pheromone, the cells that a search has settled.

use crate::{
    geometry::Bounds,
    kernel::{Frame, Role, Shape, VERTEX},
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

/// Colours from weak to strong, their opacity with them, so that walls and ground show through.
const PHEROMONE: [[[f64; 4]; 3]; 2] = [
    [[150.0, 120.0, 200.0, 0.0], [123.0, 94.0, 167.0, 150.0], [88.0, 40.0, 140.0, 235.0]],
    [[130.0, 105.0, 190.0, 0.0], [160.0, 125.0, 220.0, 150.0], [225.0, 200.0, 255.0, 240.0]],
];
const CLOSED: [[[f64; 4]; 3]; 2] = [
    [[190.0, 215.0, 232.0, 150.0], [127.0, 168.0, 201.0, 150.0], [70.0, 118.0, 165.0, 150.0]],
    [[35.0, 66.0, 92.0, 160.0], [52.0, 100.0, 138.0, 160.0], [92.0, 152.0, 196.0, 160.0]],
];

/// The field of a role in a drawn frame; `None` if it has none. Of pheromone the square root is shown: a path's weak
/// beginnings are what one looks for.
pub fn raster(frame: &Frame, role: Role, dark: bool) -> Option<Raster> {
    let span = frame.spans().find(|span| span.role == role && span.shape == Shape::Field && span.count > 0)?;
    let values = &frame.vertices()[span.first as usize * VERTEX..][..span.count as usize * VERTEX];
    let width = values[2] as usize;
    let height = span.count as usize / width.max(1);
    let weights = || values.chunks_exact(VERTEX).map(|v| f64::from(v[3]));
    let shown = || weights().filter(|&w| w >= 0.0);
    let (low, high) = shown().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), w| (low.min(w), high.max(w)));
    let ramp = &if role == Role::Pheromone { PHEROMONE } else { CLOSED }[usize::from(dark)];
    let mut pixels = Vec::with_capacity(4 * span.count as usize);
    for w in weights() {
        let share = if high > low { (w - low) / (high - low) } else { 0.0 };
        let t = if role == Role::Pheromone { share.max(0.0).sqrt() } else { share };
        pixels.extend(if w < 0.0 { [0; 4] } else { colour(ramp, t) });
    }
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

fn colour(ramp: &[[f64; 4]; 3], t: f64) -> [u8; 4] {
    let along = t.clamp(0.0, 1.0) * 2.0;
    let i = (along as usize).min(1);
    let part = along - i as f64;
    std::array::from_fn(|c| (ramp[i][c] + part * (ramp[i + 1][c] - ramp[i][c])) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_a_value_and_the_squares_they_stand_for() {
        let mut frame = Frame::default();
        frame.begin(Role::Pheromone, Shape::Field);
        for (i, w) in [0.0, 1.0, 4.0, -1.0, 0.0, 2.0].into_iter().enumerate() {
            frame.push_field([(i % 3) as f64 * 2.0 + 1.0, (i / 3) as f64 * 2.0 + 1.0], 3, w);
        }
        let picture = raster(&frame, Role::Pheromone, false).unwrap();
        assert_eq!((picture.width, picture.height, picture.range), (3, 2, [0.0, 4.0]));
        assert_eq!((picture.bounds.min, picture.bounds.max), ([0.0, 0.0], [6.0, 4.0]));
        assert_eq!(picture.pixels[8..12], [88, 40, 140, 235], "the strongest");
        assert_eq!(picture.pixels[4..8], [123, 94, 167, 150], "the root of a quarter is the middle");
        assert_eq!((picture.pixels[3], picture.pixels[15]), (0, 0), "the weakest and nothing are transparent");
        assert!(raster(&frame, Role::Closed, false).is_none());
    }
}
