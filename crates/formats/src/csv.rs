//! Tables of points: a line for each stop of a tour, with commas, semicolons or tabs between.

use std::{fmt::Write, sync::Arc};

use forage::{
    exact::Metric,
    kernel::{Error, allowed::nothing, digits::Digits},
    message,
    scene::{FARTHEST, MAX_STOPS, Scene, TourScene, tour},
};

use super::{
    file::{NamedFile, for_number, number_up_to},
    report::{Exported, Imported, not_kept, scene},
};

/// A scene of the points in a table: its columns `x` and `y`, or its only two.
pub(super) fn import(file: &NamedFile) -> Result<Imported, Error> {
    let mut lines = file.lines()?.filter(|(_, line)| !line.trim().is_empty()).peekable();
    let Some(&(line, first)) = lines.peek() else {
        return Err(file.wrong(1, &message!("files-empty-table", "the file is empty, expected a line for each stop, with x and y")));
    };
    let between = [';', '\t'].into_iter().find(|&c| first.contains(c)).unwrap_or(',');
    let heading = fields(first, between);
    let mut notes = Vec::new();
    let mut columns = [0, 1];
    if heading.iter().any(|name| number_up_to(f64::INFINITY, name).is_none()) {
        lines.next();
        for (column, name) in columns.iter_mut().zip(["x", "y"]) {
            let mut named = (0..heading.len()).filter(|&i| heading[i].eq_ignore_ascii_case(name));
            let (Some(at), None) = (named.next(), named.next()) else {
                let expected = message!("files-x-and-y", "x and y, or names of columns, one of them x and one y");
                return Err(file.unexpected(line, first, &expected));
            };
            *column = at;
        }
        let others: Vec<_> = (0..heading.len()).filter(|i| !columns.contains(i)).map(|i| heading[i]).collect();
        if !others.is_empty() {
            notes.push(message!("files-columns", "Columns that were not read: {names}.", names = others.join(", ")));
        }
    } else if heading.len() != 2 {
        let problem = message!("files-no-names", "found {n} fields and no names of columns, expected 2: x and y", n = heading.len());
        return Err(file.wrong(line, &problem));
    }
    let mut points = Vec::new();
    let mut last = line;
    for (line, found) in lines {
        let fields = fields(found, between);
        if fields.len() != heading.len() {
            let problem = message!("files-fields", "found {n} fields, expected {expected}", n = fields.len(), expected = heading.len());
            return Err(file.wrong(line, &problem));
        }
        let mut point = [0.0; 2];
        for (axis, c) in point.iter_mut().enumerate() {
            let word = fields[columns[axis]];
            let expected = || for_number(["x", "y"][axis], -FARTHEST, FARTHEST);
            *c = number_up_to(FARTHEST, word).ok_or_else(|| file.unexpected(line, word, &expected()))?;
        }
        if points.len() == MAX_STOPS {
            return Err(file.wrong(line, &message!("files-most-stops", "more than {most} stops", most = MAX_STOPS)));
        }
        points.push(point);
        last = line;
    }
    if points.len() < 2 {
        let problem = message!("files-few-stops", "the file ends after {n} stops, expected 2 at least", n = points.len());
        return Err(file.wrong(last, &problem));
    }
    let body = Arc::new(TourScene::through(points, Metric::Euclidean));
    Ok(Imported::new(scene(file, "CSV of points", None, tour::KIND.optimum, body, &notes)?, notes))
}

/// A line's fields without spaces and quotes around them; between quotes the separator is a character like others.
fn fields(line: &str, between: char) -> Vec<&str> {
    let mut quoted = false;
    line.split(|c| {
        quoted ^= c == '"';
        c == between && !quoted
    })
    .map(|field| field.trim().trim_matches('"').trim())
    .collect()
}

/// The points of a tour's stops.
pub(super) fn export(scene: &Scene, stem: &str) -> Result<Exported, Error> {
    let tour = scene.get::<TourScene>()?;
    if tour.points.is_empty() {
        let allowed = message!("files-no-points", "a point for each stop: the scene has only their distances");
        return Err(Error::refused("points", nothing(), allowed));
    }
    let mut text = String::from("x,y\n");
    for [x, y] in &tour.points {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{},{}", Digits(*x), Digits(*y));
    }
    let mut notes = Vec::new();
    for (there, what) in [
        (tour.matrix.is_some(), message!("files-distances", "the distances")),
        (tour.matrix.is_none() && tour.metric != Metric::Euclidean, message!("files-metric", "how distances are measured")),
        (!tour.closed, message!("files-open", "that tours are open")),
        (!tour.fixed.is_empty(), message!("files-fixed", "the fixed edges")),
        (scene.header().exact.is_some(), message!("files-shortest", "the shortest tour")),
    ] {
        if there {
            not_kept(&what, &mut notes);
        }
    }
    Ok(Exported { files: vec![NamedFile::new(format!("{stem}.csv"), text)], notes })
}

#[cfg(test)]
mod tests {
    use crate::{Format, export as write, import as read};

    use super::*;
    use forage::standard;

    fn table(text: &str) -> Result<Imported, Error> {
        read(standard(), &[NamedFile::new("folder/a.csv", text)], None)
    }

    #[test]
    fn points_are_read_whatever_is_between_them() {
        for (text, notes) in [
            ("x,y\n1,2\n-3.5,4e1\n", 0),
            ("1,2\n-3.5,4e1", 0),
            ("\u{feff}X;Y\r\n1;2\r\n\r\n-3.5;4e1\r\n", 0),
            ("x\ty\n1\t2\n-3.5\t4e1\n", 0),
            ("name, y , x\n\"Rome, Italy\",2,1\n\"b\", \"4e1\" ,-3.5\n", 1),
            ("id,X,Y\n7,1,2\n7,-3.5,40\n", 1),
        ] {
            let read = table(text).unwrap();
            let tour = read.scene.get::<TourScene>().unwrap();
            assert_eq!((tour.points.as_slice(), tour.metric), (&[[1.0, 2.0], [-3.5, 40.0]][..], Metric::Euclidean), "{text}");
            assert_eq!((read.scene.name(), read.notes.len()), ("a", notes));
        }
        assert_eq!(read(standard(), &[NamedFile::new("points", "x,y\n1,2\n3,4\n")], None).unwrap().scene.stops().len(), 2);
    }

    #[test]
    fn what_is_no_table_of_points_is_refused_with_its_line() {
        for (text, part) in [
            ("", "line 1: the file is empty"),
            ("\n\n", "line 1: the file is empty"),
            ("x,y\n", "line 1: the file ends after 0 stops, expected 2 at least"),
            ("x,y\n1,2\n", "line 2: the file ends after 1 stops"),
            ("1,2,3\n4,5,6\n", "line 1: found 3 fields and no names of columns, expected 2: x and y"),
            ("1\n2\n", "line 1: found 1 fields"),
            ("a,b\n1,2\n", "line 1: found `a,b`, expected x and y, or names of columns, one of them x and one y"),
            ("x,y,x\n1,2,3\n", "line 1: found `x,y,x`"),
            ("x,y\n1,2\n3\n", "line 3: found 1 fields, expected 2"),
            ("x,y\n1,2\n3,\n", "line 3: found ``, expected for y a number from -1000000000 to 1000000000"),
            ("x,y\n1,2\n1e10,3\n", "line 3: found `1e10`, expected for x"),
            ("x;y\n1,5;2\n", "line 2: found `1,5`, expected for x"),
            ("x,y\n1,inf\n", "line 2: found `inf`, expected for y"),
            (&"1,2\n".repeat(100_001), "line 100001: more than 100000 stops"),
        ] {
            let error = table(text).unwrap_err();
            assert_eq!(error.field(), "a.csv");
            assert!(error.to_string().contains(part), "{error}\nshould say\n{part}");
        }
    }

    #[test]
    fn points_are_written_and_what_is_lost_is_said() {
        let scene = table("x,y\n1,2\n-3.5,40\n").unwrap().scene;
        let written = write(&scene, Format::Csv, "b").unwrap();
        assert_eq!((written.files[0].name.as_str(), written.files[0].bytes.as_slice()), ("b.csv", &b"x,y\n1,2\n-3.5,40\n"[..]));
        assert!(written.notes.is_empty());
        let text = scene.to_json().replace("\"points\"", "\"metric\": \"att\", \"closed\": false, \"exact\": 3, \"points\"");
        assert_eq!(write(&standard().read_scene(&text).unwrap(), Format::Csv, "b").unwrap().notes.len(), 3);
        let matrix = text.split("\"metric\"").next().unwrap().to_owned() + "\"matrix\": [[0, 1], [1, 0]]}";
        assert_eq!(write(&standard().read_scene(&matrix).unwrap(), Format::Csv, "b").unwrap_err().field(), "points");
    }
}
