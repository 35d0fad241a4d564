//! What trees look like: edges, nodes, the path, and what the last extension looked at.

use crate::{
    describe::{Layer, layers},
    kernel::{Frame, Shape},
};

use super::{
    forest::NONE,
    grow::{SampleOutcome, Source},
    method::Seen,
};

const BEST: Layer = layers::BEST.titled("Path", "The path along the tree.");
const FINISHED: Layer = layers::SMOOTHED.titled("Finished", "The path that is handed over: shortened, fitted and smoothed.");

/// Of one tree.
pub(super) const LAYERS: &[Layer] = &[
    layers::TREE,
    layers::NODES,
    layers::SAMPLES,
    BEST,
    FINISHED,
    layers::KEPT.inspection(),
    layers::CHOSEN,
    layers::WAY,
    layers::TO_GOAL,
    layers::BEFORE,
    layers::AFTER,
    layers::STEP,
    layers::SUPPOSED,
];
/// With the samples that were kept.
pub(super) const GUIDED_LAYERS: &[Layer] = &[
    layers::TREE,
    layers::NODES,
    layers::SAMPLES,
    layers::KEPT,
    BEST,
    FINISHED,
    layers::CHOSEN,
    layers::WAY,
    layers::TO_GOAL,
    layers::BEFORE,
    layers::AFTER,
    layers::STEP,
    layers::SUPPOSED,
];
/// Of two trees.
pub(super) const CONNECT_LAYERS: &[Layer] = &[
    layers::TREE,
    layers::GOAL_TREE,
    layers::NODES,
    layers::SAMPLES,
    BEST,
    FINISHED,
    layers::KEPT.inspection(),
    layers::CHOSEN,
    layers::WAY,
    layers::TO_GOAL,
    layers::BEFORE,
    layers::AFTER,
    layers::STEP,
    layers::SUPPOSED,
];

impl<const N: usize> Seen<'_, N> {
    pub(super) fn draw_layers(&self, frame: &mut Frame) {
        let place = |point: &[f64; N]| self.task.space.place(point);
        for (tree, layer) in self.forest.trees.iter().zip([layers::TREE.key, layers::GOAL_TREE.key]) {
            if tree.is_empty() {
                continue;
            }
            let every = frame.thin(tree.len(), 2, true);
            frame.begin(layer, Shape::Segments);
            for node in (0..tree.len()).step_by(every).filter(|&node| tree.parents[node] != NONE) {
                frame.push_in_space(place(&tree.points[tree.parents[node] as usize]), tree.costs[node]);
                frame.push_in_space(place(&tree.points[node]), tree.costs[node]);
            }
        }
        let every = frame.thin(self.forest.births.len(), 1, false);
        frame.begin(layers::NODES.key, Shape::Points);
        for birth in self.forest.births.iter().step_by(every) {
            let tree = &self.forest.trees[usize::from(birth.tree)];
            frame.push_in_space(place(&tree.points[birth.node as usize]), tree.costs[birth.node as usize]);
        }
        frame.begin(layers::SAMPLES.key, Shape::Points);
        self.forest.last.samples.iter().for_each(|sample| frame.push_in_space(place(&sample.point), 0.0));
        if matches!(self.forest.last.source, Source::Guided(_)) {
            frame.begin(layers::KEPT.key, Shape::Points);
            let kept = self.forest.last.samples.iter().filter(|sample| sample.outcome != SampleOutcome::NotKept && sample.share > 0.0);
            kept.for_each(|sample| frame.push_in_space(place(&sample.point), sample.share));
        }
        let Some(found) = &self.forest.found else { return };
        let mut line = |layer, path: &[[f64; N]]| {
            frame.begin(layer, Shape::Polyline);
            self.drawn(path).for_each(|place| frame.push_in_space(place, 0.0));
        };
        line(layers::BEST.key, &found.raw);
        if !self.task.finish.is_raw() {
            line(layers::SMOOTHED.key, &found.finished(self.task).path);
        }
    }

    /// A path as it is drawn: straight pieces are curves elsewhere.
    fn drawn<'a>(&'a self, path: &'a [[f64; N]]) -> impl Iterator<Item = [f64; 3]> + 'a {
        let curves = self.task.space.curves();
        let pieces = path.windows(2).flat_map(move |w| {
            let n = if curves { 8 } else { 1 };
            (1..=n).map(move |k| super::vector::between(&w[0], &w[1], f64::from(k) / f64::from(n)))
        });
        path.first().copied().into_iter().chain(pieces).map(|point| self.task.space.place(&point))
    }
}
