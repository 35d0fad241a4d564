//! Pictures made in the core: a run as SVG, a function's heights as pixels, and what lies under a pointer.

mod field;
mod glyph;
mod layer;
mod svg;

pub use field::{HeatMap, heat_map};
pub use layer::{Raster, raster};
pub use svg::svg;

use crate::{
    geometry::distance_squared,
    kernel::{Frame, Item, LayerKey, Shape, VERTEX},
};

/// The piece nearest to a point, within `reach`, among these of a frame's layers. The frame must be complete
/// (not thinned), so that pieces are counted as the planner counts them.
pub fn nearest(frame: &Frame, layers: &[LayerKey], point: [f64; 2], reach: f64) -> Option<Item> {
    let mut found = (reach * reach, None);
    let mut count = vec![0; frame.layers().len()];
    for span in frame.spans().filter(|span| layers.contains(&span.layer)) {
        let first = &mut count[span.index];
        let points: Vec<_> = frame.points(span).collect();
        let mut offer_at = |squared: f64, piece: usize| {
            if squared < found.0 || (squared == found.0 && found.1.is_none()) {
                found = (squared, Some(Item { layer: span.layer, index: *first + piece }));
            }
        };
        let mut offer = |piece: usize, a, b| offer_at(distance_squared(a, b, point), piece);
        let pieces = match span.shape {
            Shape::Points | Shape::Field => {
                points.iter().enumerate().for_each(|(i, &p)| offer(i, p, p));
                points.len()
            }
            Shape::Tube => {
                let half = frame.vertices().get(span.first as usize * VERTEX + 3).map_or(0.0, |&half| f64::from(half));
                let last = points.len().saturating_sub(1);
                // What is inside is nearer than any line.
                for i in 0..points.len() {
                    let (a, b) = (points[i], points[(i + 1).min(last)]);
                    let to = (distance_squared(a, b, point).sqrt() - half).max(0.0);
                    offer_at(to * to, 0);
                }
                1
            }
            Shape::Polyline => {
                points.windows(2).for_each(|w| offer(0, w[0], w[1]));
                1
            }
            Shape::Segments => {
                points.chunks_exact(2).enumerate().for_each(|(i, pair)| offer(i, pair[0], pair[1]));
                points.len() / 2
            }
        };
        *first += pieces;
    }
    found.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::describe::layers::{BEST, PARTICLES};

    #[test]
    fn the_nearest_piece_is_counted_within_its_layer() {
        let mut frame = Frame::default();
        frame.clear(10, [PARTICLES.key, BEST.key]);
        frame.begin(PARTICLES.key, Shape::Polyline);
        [[0.0, 0.0], [4.0, 0.0]].into_iter().for_each(|p| frame.push(p, 0.0));
        frame.begin(BEST.key, Shape::Polyline);
        [[0.0, 2.0], [4.0, 2.0]].into_iter().for_each(|p| frame.push(p, 0.0));
        frame.begin(PARTICLES.key, Shape::Polyline);
        [[0.0, 3.0], [4.0, 3.0]].into_iter().for_each(|p| frame.push(p, 0.0));
        let pick = |point, reach| nearest(&frame, &[PARTICLES.key], point, reach).map(|item| item.index);
        assert_eq!(pick([2.0, 0.5], 1.0), Some(0));
        assert_eq!(pick([2.0, 2.1], 1.0), Some(1), "the best is nearer but cannot be picked");
        assert_eq!(pick([2.0, 1.5], 1.0), None);
        frame.clear(10, [PARTICLES.key]);
        frame.begin(PARTICLES.key, Shape::Points);
        [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].into_iter().for_each(|p| frame.push(p, 0.0));
        assert_eq!(nearest(&frame, &[PARTICLES.key], [1.2, 0.1], 0.5).unwrap().index, 1);
    }
}
