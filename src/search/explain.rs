//! Why a cell has the number it has.

use crate::{
    describe::layers,
    kernel::{Column, Inspection, Item, Mark, Quantity, Shape},
};

use super::{
    best_first::Search,
    open::{apart, place},
    rules::Heuristic,
};

/// The TeX strings that inspections use.
pub(super) const SYMBOLS: &[&str] = &["g", "h", "f", "w", "l", "g(p)", "c", "\\Delta x", "\\Delta y"];

const COLUMNS: [Column; 3] = [
    Column { name: "g", symbol: "g", title: "way from the start" },
    Column { name: "h", symbol: "h", title: "way to the goal, at least" },
    Column { name: "f", symbol: "f", title: "together, as the queue is ordered" },
];

fn quantity(name: &'static str, symbol: &'static str, title: &'static str, value: f64) -> Quantity {
    Quantity { name, symbol, title, value }
}

impl Search {
    /// A cell's numbers and whose child it is; nothing is said about a blocked cell.
    pub(super) fn explain(&self, item: Item) -> Option<Inspection> {
        let (cells, cell) = (&self.task.cells, item.index);
        if item.layer != layers::CLOSED.key || cell >= cells.len() || !cells.is_free(cell) {
            return None;
        }
        let [column, row] = cells.told(cell);
        let mut told = Inspection {
            item,
            title: format!("Column {column}, row {row}"),
            event: "unreached",
            summary: "The cell has not been reached yet.".to_owned(),
            values: self.ahead_of(cell),
            formulas: self.heuristic().into_iter().collect(),
            columns: COLUMNS.to_vec(),
            labels: Vec::new(),
            rows: Vec::new(),
            marks: vec![Mark::plane(layers::AFTER.key, Shape::Points, vec![cells.centre(cell)])],
        };
        if let Some(g) = self.reached(cell) {
            self.tell_way(cell, g, &mut told);
        }
        for d in (0..8).filter(|d| cells.moves(cell) >> d & 1 != 0) {
            let next = cells.next(cell, d);
            if let Some(g) = self.reached(next) {
                let h = self.ahead(next);
                told.labels.push(cells.compass()[d].to_owned());
                told.rows.push(vec![self.task.length(g), h, self.task.length(g) + self.task.guess.weight * h]);
            }
        }
        Some(told)
    }

    /// Adds what is known of the way to a cell that was reached.
    fn tell_way(&self, cell: usize, g: f64, told: &mut Inspection) {
        let task = &self.task;
        let (g, h) = (task.length(g), self.ahead(cell));
        let parent = self.parent(cell);
        let closed = self.is_closed(cell);
        told.event = if closed { "settled" } else { "frontier" };
        told.summary = match (parent, closed) {
            (None, _) => "The way begins here.".to_owned(),
            (Some(parent), true) => format!("The cell is settled, as the child of {}.", self.name(parent)),
            (Some(parent), false) => format!("The cell is on the frontier, so far as the child of {}.", self.name(parent)),
        };
        told.values.extend([
            quantity("g", "g", "way from the start", g),
            quantity("f", "f", "together, as the queue is ordered", g + task.guess.weight * h),
        ]);
        told.formulas.insert(0, "f");
        if let Some(parent) = parent {
            let step = task.length(task.between(parent, cell));
            told.values.extend([
                quantity("g_parent", "g(p)", "the parent’s way from the start", self.reached(parent).map_or(0.0, |g| task.length(g))),
                quantity("c", "c", "from the parent to the cell", step),
            ]);
            told.formulas.insert(1, "g");
            let mut vertices: Vec<_> = self.way(cell).into_iter().map(|cell| task.cells.centre(cell)).collect();
            if vertices[0] != task.endpoints.ends[0] {
                vertices.insert(0, task.endpoints.ends[0]);
            }
            told.marks.insert(0, Mark::plane(layers::BEFORE.key, Shape::Polyline, vertices));
        }
    }

    /// The heuristic in the scene's unit, without its weight.
    fn ahead(&self, cell: usize) -> f64 {
        self.task.length(self.task.rules.heuristic.ahead(self.goal_from(cell)))
    }

    /// The heuristic's formula, where it is known.
    fn heuristic(&self) -> Option<&'static str> {
        matches!(self.task.rules.heuristic, Heuristic::Octile | Heuristic::Straight).then_some("h")
    }

    /// Columns and rows between a cell and the goal.
    fn goal_from(&self, cell: usize) -> [i32; 2] {
        let [[x, y], [goal_x, goal_y]] = [cell, self.task.endpoints.goal].map(|cell| apart(place(self.task.cells.place(cell))));
        [(goal_x - x).abs(), (goal_y - y).abs()]
    }

    fn ahead_of(&self, cell: usize) -> Vec<Quantity> {
        let [dx, dy] = self.goal_from(cell).map(f64::from);
        vec![
            quantity("h", "h", "way to the goal, at least", self.ahead(cell)),
            quantity("w", "w", "weight of the heuristic", self.task.guess.weight),
            quantity("side", "l", "side of a cell", self.task.cells.side),
            quantity("dx", "\\Delta x", "columns to the goal", dx),
            quantity("dy", "\\Delta y", "rows to the goal", dy),
        ]
    }

    fn name(&self, cell: usize) -> String {
        let [column, row] = self.task.cells.told(cell);
        format!("column {column}, row {row}")
    }
}
