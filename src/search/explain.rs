//! Why a cell has the number it has.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Mark, Quantity, Shape},
    label, message,
    scene::grid::words,
};

use super::{
    best_first::Search,
    open::{apart, place},
    rules::{Heuristic, Relaxation},
};

const COLUMNS: [Label; 3] = [
    label!("search-from-start", "g", "g", "way from the start"),
    label!("search-to-goal", "h", "h", "way to the goal, at least"),
    label!("search-together", "f", "f", "together, as the queue is ordered"),
];

/// Larger searches are not repeated to suppose something: that would take long, and as much memory again.
const MOST_CELLS: usize = 1 << 21;

/// What can be supposed of a search that guesses, and of one that does not.
const UNGUIDED: Label = label!("search-without-heuristic", "unguided", "h = 0", "without the heuristic");
const DOUBLED: Label = label!("search-twice-the-heuristic", "doubled", "2 w", "with twice its weight");
const GUIDED: Label = label!("search-with-heuristic", "guided", "w = 1", "with the distance to the goal as heuristic");

impl Search {
    /// A cell's numbers and whose child it is; nothing is said about a blocked cell.
    pub(super) fn explain(&self, item: Item) -> Option<Inspection> {
        let (cells, cell) = (&self.task.cells, item.index);
        if item.layer != layers::CLOSED.key || cell >= cells.len() || !cells.is_free(cell) {
            return None;
        }
        let unreached = message!("search-unreached", "The cell has not been reached yet.");
        let mut inspection = Inspection {
            values: self.ahead_of(cell),
            formulas: self.heuristic().into_iter().collect(),
            columns: COLUMNS.to_vec(),
            marks: vec![Mark::plane(layers::AFTER.key, Shape::Points, vec![cells.centre(cell)])],
            ..Inspection::new(item, words::cell(cells, cell), "unreached", unreached)
        };
        if let Some(g) = self.reached(cell) {
            self.describe_way(cell, g, &mut inspection);
        }
        if self.ahead(cell) > 0.0 {
            inspection.marks.insert(0, Mark::plane(layers::TO_GOAL.key, Shape::Polyline, self.guessed_way(cell)));
        }
        if self.expanded > 0 && cells.len() <= MOST_CELLS {
            inspection.suppositions = if self.guesses() { vec![UNGUIDED, DOUBLED] } else { vec![GUIDED] };
        }
        for d in (0..8).filter(|d| cells.moves(cell) >> d & 1 != 0) {
            let next = cells.next(cell, d);
            if let Some(g) = self.reached(next) {
                let h = self.ahead(next);
                inspection.labels.push(words::compass(cells, d));
                inspection.rows.push(vec![self.task.length(g), h, self.task.length(g) + self.task.guess.weight * h]);
            }
        }
        Some(inspection)
    }

    /// Adds what is known of the way to a cell that was reached.
    fn describe_way(&self, cell: usize, g: f64, inspection: &mut Inspection) {
        let task = &self.task;
        let (g, h) = (task.length(g), self.ahead(cell));
        let parent = self.parent(cell);
        let closed = self.is_closed(cell);
        inspection.event = if closed { "settled" } else { "frontier" };
        inspection.summary = match parent.map(|parent| task.cells.counted_place(parent)) {
            None => message!("search-start", "The way begins here."),
            Some([column, row]) if closed => {
                message!("search-settled", "The cell is settled, as the child of column {column}, row {row}.", column, row)
            }
            Some([column, row]) => {
                message!("search-frontier", "The cell is on the frontier, so far as the child of column {column}, row {row}.", column, row)
            }
        };
        inspection.values.extend([
            label!("search-from-start", "g", "g", "way from the start").is(g),
            label!("search-together", "f", "f", "together, as the queue is ordered").is(g + task.guess.weight * h),
        ]);
        inspection.formulas.insert(0, "f");
        if let Some(parent) = parent {
            let step = task.length(task.between(parent, cell));
            inspection.values.extend([
                label!("search-parent-from-start", "g_parent", "g(p)", "the parent’s way from the start")
                    .is(self.reached(parent).map_or(0.0, |g| task.length(g))),
                label!("search-from-parent", "c", "c", "from the parent to the cell").is(step),
            ]);
            inspection.formulas.insert(1, "g");
            let mut vertices: Vec<_> = self.way(cell).into_iter().map(|cell| task.cells.centre(cell)).collect();
            if vertices[0] != task.endpoints.ends[0] {
                vertices.insert(0, task.endpoints.ends[0]);
            }
            let step = vertices[vertices.len() - 2..].to_vec();
            inspection.marks.insert(0, Mark::plane(layers::STEP.key, Shape::Segments, step));
            inspection.marks.insert(0, Mark::plane(layers::WAY.key, Shape::Polyline, vertices));
        }
    }

    /// Whether the heuristic counts.
    fn guesses(&self) -> bool {
        self.task.guess.weight > 0.0 && !matches!(self.task.rules.heuristic, Heuristic::Nothing)
    }

    /// The way that the heuristic measures: diagonally and then straight, or straight at once.
    fn guessed_way(&self, cell: usize) -> Vec<[f64; 2]> {
        let (cells, goal) = (&self.task.cells, self.task.endpoints.goal);
        let mut way = vec![cells.centre(cell), cells.centre(goal)];
        if matches!(self.task.rules.heuristic, Heuristic::Octile) {
            let [[x, y], [goal_x, goal_y]] = [cell, goal].map(|cell| apart(place(cells.place(cell))));
            let diagonal = (goal_x - x).abs().min((goal_y - y).abs());
            let turn = [x + diagonal * (goal_x - x).signum(), y + diagonal * (goal_y - y).signum()];
            way.insert(1, cells.centre(turn[1] as usize * cells.columns + turn[0] as usize));
        }
        way
    }

    /// Where the search would be if it had settled as many cells by another guess.
    pub(super) fn suppose(&self, item: Item, supposition: &str) -> Inspection {
        let (task, cell) = (&self.task, item.index);
        let mut guess = task.guess;
        guess.weight *= if supposition == DOUBLED.name { 2.0 } else { 0.0 };
        if supposition == GUIDED.name {
            guess.weight = 1.0;
            guess.heuristic = if task.rules.relaxation == Relaxation::Step { Heuristic::Octile } else { Heuristic::Straight };
        }
        let other = self.guessing(guess);
        let n = other.expanded;
        let (event, summary) = match (&other.found, other.reached(cell)) {
            (Some(found), _) => {
                let length = found.cost;
                (
                    "solved",
                    message!("search-supposed-found", "With {n} cells settled the goal would be reached, in {length:.4}.", n, length),
                )
            }
            (None, None) => {
                ("unreached", message!("search-supposed-unreached", "With {n} cells settled this one would not be reached yet.", n))
            }
            (None, Some(_)) if other.is_closed(cell) => {
                ("settled", message!("search-supposed-settled", "With {n} cells settled this one would be among them.", n))
            }
            (None, Some(_)) => {
                ("frontier", message!("search-supposed-frontier", "With {n} cells settled this one would be on the frontier.", n))
            }
        };
        let path = |cells: Vec<usize>| cells.into_iter().map(|cell| task.cells.centre(cell)).collect();
        let mut marks = vec![Mark::plane(layers::AFTER.key, Shape::Points, path(other.on_the_frontier().collect()))];
        if other.reached(cell).is_some() {
            marks.push(Mark::plane(layers::JUMP.key, Shape::Polyline, path(other.way(cell))));
        }
        Inspection { marks, ..Inspection::new(item, words::cell(&task.cells, cell), event, summary) }
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
            label!("search-to-goal", "h", "h", "way to the goal, at least").is(self.ahead(cell)),
            label!("search-weight", "w", "w", "weight of the heuristic").is(self.task.guess.weight),
            label!("search-side", "side", "l", "side of a cell").is(self.task.cells.side),
            label!("search-columns", "dx", "\\Delta x", "columns to the goal").is(dx),
            label!("search-rows", "dy", "\\Delta y", "rows to the goal").is(dy),
        ]
    }
}
