//! What a search looks like: the cells it has settled, its frontier, and the path.

use crate::{
    describe::layers,
    kernel::{Frame, LayerKey, Shape},
};

use super::best_first::Search;

impl Search {
    pub(super) fn draw_layers(&self, frame: &mut Frame) {
        self.draw_closed(frame);
        self.draw_frontier(frame);
        if let Some(found) = &self.found {
            draw_path(frame, layers::BEST.key, &found.way.path);
            if self.task.smooth {
                draw_path(frame, layers::SMOOTHED.key, found.way.smooth(&self.task.grid));
            }
        }
    }

    /// The settled cells, shaded by their way from the start: all of them, or where they are too many, one of each square
    /// of cells.
    fn draw_closed(&self, frame: &mut Frame) {
        let cells = &self.task.cells;
        let (budget, mut side) = (frame.budget(), 1);
        while cells.columns.div_ceil(side) * cells.rows.div_ceil(side) > budget {
            side += 1;
        }
        frame.begin(layers::CLOSED.key, Shape::Field);
        let (width, spacing) = (cells.columns.div_ceil(side), side as f64 * cells.side);
        for (j, top) in (0..cells.rows).step_by(side).enumerate() {
            let row = (top + side / 2).min(cells.rows - 1);
            for (i, left) in (0..cells.columns).step_by(side).enumerate() {
                let cell = row * cells.columns + (left + side / 2).min(cells.columns - 1);
                let g = self.reached(cell).filter(|_| self.is_closed(cell)).map_or(-1.0, |g| self.task.length(g));
                frame.push_field([i, j].map(|k| (k as f64 + 0.5) * spacing), width, g);
            }
        }
    }

    fn draw_frontier(&self, frame: &mut Frame) {
        let every = frame.thin(self.frontier as usize, 1, false);
        frame.begin(layers::FRONTIER.key, Shape::Points);
        let open = (0..self.task.cells.len()).filter_map(|cell| Some((cell, self.reached(cell).filter(|_| !self.is_closed(cell))?)));
        for (cell, g) in open.step_by(every) {
            frame.push(self.task.cells.centre(cell), self.task.length(g));
        }
    }
}

fn draw_path(frame: &mut Frame, layer: LayerKey, path: &[[f64; 2]]) {
    frame.begin(layer, Shape::Polyline);
    path.iter().for_each(|&point| frame.push(point, 0.0));
}
