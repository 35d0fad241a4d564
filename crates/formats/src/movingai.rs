//! MovingAI's `.map` (a grid) and `.scen` (problems on it). The origin is at the upper left, lengths are in cells, and
//! steps don't cut corners: <https://movingai.com/benchmarks/formats.html>.

use std::{fmt::Write, sync::Arc};

use forage::{
    exact::shortest_over_cells,
    geometry::YAxis,
    kernel::{Error, Message, digits::Digits, json},
    message,
    scene::{GridScene, grid},
};

pub use super::report::Problem;

use super::{
    ends,
    file::{NamedFile, a_height, a_width},
    report::{Exported, Imported, lost, note_other_name, scene},
};

/// A scene of a map, with the ends of one of the problems if there are some.
pub(super) fn import(map: &NamedFile, scen: Option<&NamedFile>, problem: Option<usize>) -> Result<Imported, Error> {
    let mut notes = Vec::new();
    let mut grid = read_map(map, &mut notes)?;
    let mut problems = Vec::new();
    if let Some(scen) = scen {
        let (lines, named) = read_scen(scen, [grid.columns, grid.rows()])?;
        note_other_name(scen, named, map, &mut notes);
        let index = problem.unwrap_or(lines.len() - 1);
        let Some((line, chosen)) = lines.get(index) else {
            let (label, count) = (scen.label(), lines.len());
            let allowed = if count == 1 {
                message!("files-one-problem", "0: {file} has 1 problem, counted from 0", file = label)
            } else {
                message!(
                    "files-problems",
                    "from 0 to {last}: {file} has {count} problems, counted from 0",
                    last = count - 1,
                    file = label,
                    count
                )
            };
            return Err(Error::refused("problem", index, allowed));
        };
        let is_blocked = |[x, y]: [f64; 2]| grid.blocked[y as usize * grid.columns + x as usize];
        if is_blocked(chosen.start) {
            let problem = message!("files-start-blocked", "the start is in a blocked cell of {map}", map = map.label());
            return Err(scen.wrong(*line, &problem));
        }
        if is_blocked(chosen.goal) {
            let problem = message!("files-goal-blocked", "the goal is in a blocked cell of {map}", map = map.label());
            return Err(scen.wrong(*line, &problem));
        }
        (grid.start, grid.goal) = (Some(chosen.start), Some(chosen.goal));
        notes.push(message!(
            "files-problem",
            "Problem {index} of {count}, counted from 0; its optimum from cell to cell is given as {length}.",
            index,
            count = lines.len(),
            length = chosen.length
        ));
        problems = lines.into_iter().map(|(_, problem)| problem).collect();
    } else {
        notes.push(
            ends::choose(&mut grid)
                .ok_or_else(|| Error::malformed(map.label(), message!("files-no-free-cell", "no cell of the map is free")))?,
        );
    }
    Ok(Imported { scene: scene(map, "MovingAI map", None, grid::KIND.optimum, Arc::new(grid), &notes)?, notes, problems })
}

/// A map, with notes on how its cells were taken.
///
/// # Errors
/// What is no such map, with the line.
pub fn read_map(file: &NamedFile, notes: &mut Vec<Message>) -> Result<GridScene, Error> {
    let mut lines = file.lines()?;
    let (mut octile, mut height, mut width) = (false, None, None);
    let mut last = 0;
    let (columns, rows) = loop {
        let Some((line, found)) = lines.next() else {
            return Err(file.wrong(last + 1, &message!("files-ends-before-map", "the file ends before the line `map`")));
        };
        last = line;
        let mut words = found.split_ascii_whitespace();
        match (words.next().unwrap_or(""), words.next(), words.next()) {
            ("", ..) => {}
            ("type", Some("octile"), None) => octile = true,
            ("height", Some(n), None) => height = Some(file.side(line, n, a_height)?),
            ("width", Some(n), None) => width = Some(file.side(line, n, a_width)?),
            ("map", None, _) => match (width, height) {
                (Some(columns), Some(rows)) if octile => break (columns, rows),
                _ => {
                    let problem = message!("files-map-before", "`map` before all of `type octile`, `height` and `width`");
                    return Err(file.wrong(line, &problem));
                }
            },
            _ => {
                let expected = message!("files-map-heading", "`type octile`, `height N`, `width N` or `map`");
                return Err(file.unexpected(line, found, &expected));
            }
        }
    };
    let mut blocked = Vec::with_capacity(columns * rows);
    let (mut swamp, mut water) = (0_usize, 0_usize);
    for row in 0..rows {
        let Some((line, cells)) = lines.next() else {
            let problem = message!("files-few-rows", "the file ends after {n} rows, expected {expected}", n = row, expected = rows);
            return Err(file.wrong(last + 1, &problem));
        };
        last = line;
        for (column, cell) in cells.chars().enumerate() {
            blocked.push(match cell {
                '.' | 'G' | 'S' => false,
                '@' | 'O' | 'T' | 'W' => true,
                _ => {
                    let expected = message!("files-cell", "one of . G S @ O T W in column {column}", column = column + 1);
                    return Err(file.unexpected(line, cell.encode_utf8(&mut [0; 4]), &expected));
                }
            });
            swamp += usize::from(cell == 'S');
            water += usize::from(cell == 'W');
        }
        if blocked.len() != (row + 1) * columns {
            let problem = message!("files-cells", "found {n} cells, expected {expected}", n = cells.len(), expected = columns);
            return Err(file.wrong(line, &problem));
        }
    }
    if let Some((line, found)) = lines.find(|(_, line)| !line.is_empty()) {
        return Err(file.unexpected(line, found, &message!("files-end-of-rows", "the end of the file after {n} rows", n = rows)));
    }
    if swamp > 0 {
        notes.push(message!("files-swamp", "{count} cells are swamp (S), free like the others.", count = swamp));
    }
    if water > 0 {
        notes.push(message!("files-water", "{count} cells are water (W), taken as blocked.", count = water));
    }
    Ok(GridScene::new(1.0, columns, blocked))
}

/// A problem with the number of its line.
type Numbered = (usize, Problem);

/// The problems of a file on a map with these columns and rows (at least one), each with its line, and the map's name.
///
/// # Errors
/// A line that is no problem of this map.
pub fn read_scen(file: &NamedFile, [columns, rows]: [usize; 2]) -> Result<(Vec<Numbered>, &str), Error> {
    let named = map_of(file)?;
    let mut problems = Vec::new();
    let mut lines = file.lines()?;
    lines.next();
    for (line, found) in lines.filter(|(_, line)| !line.is_empty()) {
        let [_, map, width, height, ax, ay, bx, by, length] = fields(file, line, found)?;
        if map != named {
            return Err(file.unexpected(line, map, &message!("files-one-map", "{map}, as above: one map at a time", map = named)));
        }
        if width.parse() != Ok(columns) {
            return Err(file.unexpected(line, width, &message!("files-map-width", "{width}, the map's width", width = columns)));
        }
        if height.parse() != Ok(rows) {
            return Err(file.unexpected(line, height, &message!("files-map-height", "{height}, the map's height", height = rows)));
        }
        let centre = |text: &str, side: usize, expected: fn(usize) -> Message| {
            let cell: Option<usize> = text.parse().ok().filter(|&cell| cell < side);
            let cell = cell.ok_or_else(|| file.unexpected(line, text, &expected(side - 1)))?;
            Ok(cell as f64 + 0.5)
        };
        let start = [
            centre(ax, columns, |last| message!("files-start-column", "a start's column from 0 to {last}", last))?,
            centre(ay, rows, |last| message!("files-start-row", "a start's row from 0 to {last}", last))?,
        ];
        let goal = [
            centre(bx, columns, |last| message!("files-goal-column", "a goal's column from 0 to {last}", last))?,
            centre(by, rows, |last| message!("files-goal-row", "a goal's row from 0 to {last}", last))?,
        ];
        let length = json::number(length)
            .filter(|length| length.is_finite() && *length >= 0.0)
            .ok_or_else(|| file.unexpected(line, length, &message!("files-length", "a length in cells")))?;
        problems.push((line, Problem { start, goal, length }));
    }
    Ok((problems, named))
}

/// The map that a file's problems are on.
///
/// # Errors
/// A file that is not of this format, or without a problem.
pub fn map_of(file: &NamedFile) -> Result<&str, Error> {
    let mut lines = file.lines()?;
    let (_, first) = lines.next().unwrap_or((1, ""));
    let mut words = first.split_ascii_whitespace();
    let number = if words.next() == Some("version") { words.next().and_then(json::number) } else { None };
    if number != Some(1.0) || words.next().is_some() {
        return Err(file.unexpected(1, first, &message!("files-version", "`version 1`")));
    }
    let (line, problem) = lines
        .find(|(_, line)| !line.is_empty())
        .ok_or_else(|| file.wrong(2, &message!("files-no-problem", "the file ends before the first problem")))?;
    Ok(fields(file, line, problem)?[1])
}

/// A problem's fields: bucket, map, width, height, start x, start y, goal x, goal y, length.
fn fields<'a>(file: &NamedFile, line: usize, found: &'a str) -> Result<[&'a str; 9], Error> {
    // Between tabs, so that a map's name may hold spaces; some files have spaces only.
    let all: Vec<_> = if found.contains('\t') { found.split('\t').map(str::trim).collect() } else { found.split_whitespace().collect() };
    let count = all.len();
    all.try_into().map_err(|_| {
        let problem = message!(
            "files-problem-fields",
            "found {n} fields, expected 9: bucket, map, width, height, start x, start y, goal x, goal y, length",
            n = count
        );
        file.wrong(line, &problem)
    })
}

/// A `.map`, and a `.scen` if there is a way from start to goal.
pub(super) fn export(grid: &GridScene, stem: &str) -> Result<Exported, Error> {
    let mut notes = Vec::new();
    lost(grid, &mut notes);
    let (columns, rows) = (grid.columns, grid.rows());
    let mut map = format!("type octile\nheight {rows}\nwidth {columns}\nmap\n");
    for line in grid.lines() {
        map.extend(line.chars().map(|c| if c == '#' { '@' } else { c }));
        map.push('\n');
    }
    let mut files = vec![NamedFile::new(format!("{stem}.map"), map)];
    if grid.start.is_none() || grid.goal.is_none() {
        notes.push(message!("files-scen-no-ends", "There is no .scen: the scene has no start and goal."));
    } else {
        // As the format has it: a point that goes from centre to centre and cuts no corners.
        let mut point = grid.clone();
        point.robot = None;
        let endpoints = point.endpoints()?;
        let mut plain = GridScene::new(1.0, columns, grid.blocked.clone());
        let centre = |cell| [cell % columns, cell / columns].map(|i| i as f64 + 0.5);
        (plain.start, plain.goal) = (Some(centre(endpoints.start)), Some(centre(endpoints.goal)));
        if endpoints.stubs > 0.0 {
            notes.push(message!("files-moved-ends", "Start and goal were moved to the centres of their cells."));
        }
        if let Some(exact) = shortest_over_cells(plain.cells(), &plain.endpoints()?) {
            let place = |cell: usize| {
                let row = cell / columns;
                [cell % columns, if grid.y_axis == YAxis::Up { rows - 1 - row } else { row }]
            };
            let ([ax, ay], [bx, by]) = (place(endpoints.start), place(endpoints.goal));
            let (bucket, length) = ((exact.length / 4.0) as u64, exact.length);
            let mut scen = String::from("version 1\n");
            // Writing to a string cannot fail.
            let _ = writeln!(scen, "{bucket}\t{stem}.map\t{columns}\t{rows}\t{ax}\t{ay}\t{bx}\t{by}\t{}", Digits(length));
            files.push(NamedFile::new(format!("{stem}.scen"), scen));
        } else {
            notes.push(message!("files-scen-no-way", "There is no .scen: without cutting corners there is no way from start to goal."));
        }
    }
    if grid.cell != 1.0 {
        notes.push(message!("files-cell-side", "Lengths are in cells there; a cell is {side} here.", side = grid.cell));
    }
    Ok(Exported { files, notes })
}
