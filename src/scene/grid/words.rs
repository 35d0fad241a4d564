//! What people call cells and directions.

use crate::{geometry::Cells, kernel::Message, message};

/// A cell by its column and row.
pub(crate) fn cell(cells: &Cells, cell: usize) -> Message {
    let [column, row] = cells.counted_place(cell);
    message!("scene-cell", "Column {column}, row {row}", column, row)
}

/// A direction as it looks in pictures.
pub(crate) fn compass(cells: &Cells, direction: usize) -> Message {
    match cells.eighths(direction) {
        0 => message!("scene-east", "east"),
        1 => message!("scene-north-east", "north-east"),
        2 => message!("scene-north", "north"),
        3 => message!("scene-north-west", "north-west"),
        4 => message!("scene-west", "west"),
        5 => message!("scene-south-west", "south-west"),
        6 => message!("scene-south", "south"),
        _ => message!("scene-south-east", "south-east"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Plan, YAxis};

    #[test]
    fn north_is_up_whichever_way_y_grows() {
        let said = |y_axis| {
            let plan = Plan { side: 1.0, columns: 1, blocked: &[false], corner_cutting: false, y_axis };
            let cells = Cells::new(&plan, None);
            [0, 1, 2, 7].map(|d| compass(&cells, d).to_string())
        };
        assert_eq!(said(YAxis::Up), ["east", "north-east", "north", "south-east"]);
        assert_eq!(said(YAxis::Down), ["east", "south-east", "south", "north-east"]);
    }
}
