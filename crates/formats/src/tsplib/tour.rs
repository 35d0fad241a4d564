//! Reading and writing a `.tour`.

use std::fmt::Write;

use serde_json::{Map, Value};

use forage::{
    kernel::{Error, Message},
    message,
    scene::TourScene,
};

use super::{
    super::{
        file::{NamedFile, is_optimal},
        report::Imported,
    },
    words::Words,
};

/// A scene that was read, with a tour for it. The tour is measured; if its file says that it is the shortest one it is
/// kept as the scene's optimum, and what it measures as the length: no file's own number is trusted.
pub(in super::super) fn with_tour(read: Imported, file: &NamedFile) -> Result<Imported, Error> {
    let Imported { scene, mut notes, problems } = read;
    let tour = scene.get::<TourScene>()?;
    if !tour.closed {
        let problem = message!("files-tour-closed", "its tour is closed, those of the scene are open");
        return Err(Error::malformed(file.label(), problem));
    }
    let order = order(file, tour.len())?;
    let length = tour.distances().length(&order, true);
    let label = file.label();
    if !is_optimal(label) {
        notes.push(message!("files-tour", "The tour in {file} has the length {length}; the scene is as it was.", file = label, length));
        return Ok(Imported { scene, notes, problems });
    }
    notes.push(message!(
        "files-shortest-tour",
        "The tour in {file} has the length {length}. That none is shorter is what the file’s name says.",
        file = label,
        length
    ));
    let mut exact = Map::new();
    exact.insert("length".to_owned(), Value::from(length));
    exact.insert("order".to_owned(), Value::Array(order.into_iter().map(Value::from).collect()));
    let mut header = scene.header().clone();
    header.exact = Some(Value::Object(exact));
    Ok(Imported { scene: scene.with_header(header)?, notes, problems })
}

/// The order of `n` stops, from 0.
fn order(file: &NamedFile, n: usize) -> Result<Vec<usize>, Error> {
    let mut words = Words::new(file)?;
    let mut order: Option<Vec<usize>> = None;
    while let Some((keyword, value)) = words.keyword() {
        let line = words.line;
        let expect = |fits: bool, expected: Message| if fits { Ok(()) } else { Err(file.unexpected(line, value, &expected)) };
        match keyword {
            "TYPE" => expect(value.split_whitespace().next() == Some("TOUR"), message!("files-for-type", "for TYPE TOUR"))?,
            "DIMENSION" => {
                let expected = message!("files-for-dimension", "for DIMENSION {n}, as many as the scene has stops", n);
                expect(value.parse() == Ok(n), expected)?;
            }
            "TOUR_SECTION" if order.is_none() => order = Some(section(&mut words, n)?),
            // The end of a list of tours, of which there is one.
            "-1" if order.is_some() => {}
            _ if keyword.bytes().all(|c| c.is_ascii_uppercase() || c == b'_') && !keyword.ends_with("_SECTION") => {}
            _ if order.is_some() => {
                let expected = message!("files-one-tour", "the end of the file: one tour at a time");
                return Err(file.unexpected(line, keyword, &expected));
            }
            _ => return Err(file.unexpected(line, keyword, &message!("files-tour-section", "a keyword or TOUR_SECTION"))),
        }
    }
    order.ok_or_else(|| file.ends_without(words.line.max(1), "TOUR_SECTION"))
}

fn section(words: &mut Words, n: usize) -> Result<Vec<usize>, Error> {
    let mut called = vec![false; n];
    let order: Vec<_> = (0..n).map(|_| words.stop(n, &mut called)).collect::<Result<_, _>>()?;
    // Some programs leave out the −1.
    match words.word() {
        None | Some("-1" | "EOF") => Ok(order),
        other => Err(words.refuse(other, &message!("files-tour-end", "-1 after {n} stops", n))),
    }
}

/// A tour as a TSPLIB file with this name. `order` counts stops from 0, the file from 1.
///
/// ```
/// let file = forage_formats::tour_file("a.tour", &[1, 0, 2]);
/// assert_eq!(file.bytes, b"NAME : a.tour\nTYPE : TOUR\nDIMENSION : 3\nTOUR_SECTION\n2\n1\n3\n-1\nEOF\n");
/// ```
pub fn tour_file(name: &str, order: &[usize]) -> NamedFile {
    let mut text = format!("NAME : {name}\nTYPE : TOUR\nDIMENSION : {}\nTOUR_SECTION\n", order.len());
    for stop in order {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", stop + 1);
    }
    text.push_str("-1\nEOF\n");
    NamedFile::new(name, text)
}
