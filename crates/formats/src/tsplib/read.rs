//! Reading a `.tsp`.

use std::sync::Arc;

use forage::{
    exact::{Distances, LONGEST, MAX_MATRIX, Metric},
    kernel::{Error, Message},
    message,
    scene::{FARTHEST, MAX_STOPS, TourScene, tour},
};

use super::{
    super::{
        file::{NamedFile, number_up_to, stem},
        report::{Imported, scene_named},
    },
    words::Words,
};

/// What stands in a file.
#[derive(Default)]
struct Instance<'a> {
    name: &'a str,
    comments: Vec<Message>,
    notes: Vec<Message>,
    /// Keywords and sections with the lines where they stand: none may come twice.
    seen: Vec<(&'a str, usize)>,
    n: Option<usize>,
    measure: Option<Measure>,
    shape: Option<Shape>,
    coordinates: Vec<[f64; 2]>,
    places: Vec<[f64; 2]>,
    /// Row by row.
    weights: Vec<f64>,
    fixed: Vec<[usize; 2]>,
}

/// How far it is from one stop to another: by a formula, or as a matrix says.
#[derive(Clone, Copy, PartialEq)]
enum Measure {
    By(Metric),
    Explicit,
}

/// Which entries of a matrix a file lists, row by row. By columns it is the other half of a symmetric one by rows.
#[derive(Clone, Copy)]
enum Shape {
    Full,
    /// From this far right of the diagonal on.
    Upper(usize),
    /// To this far right of the diagonal, without that.
    Lower(usize),
}

/// The forms that are read, for a refusal.
fn forms() -> Message {
    message!(
        "files-forms",
        "for EDGE_WEIGHT_FORMAT FULL_MATRIX, or UPPER or LOWER with _ROW, _COL, _DIAG_ROW or _DIAG_COL: no other form is read"
    )
}

impl Shape {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "FULL_MATRIX" => Self::Full,
            "UPPER_ROW" | "LOWER_COL" => Self::Upper(1),
            "UPPER_DIAG_ROW" | "LOWER_DIAG_COL" => Self::Upper(0),
            "LOWER_ROW" | "UPPER_COL" => Self::Lower(0),
            "LOWER_DIAG_ROW" | "UPPER_DIAG_COL" => Self::Lower(1),
            _ => return None,
        })
    }

    /// The columns that row `i` of `n` lists.
    fn row(self, i: usize, n: usize) -> std::ops::Range<usize> {
        match self {
            Self::Full => 0..n,
            Self::Upper(from) => (i + from).min(n)..n,
            Self::Lower(to) => 0..i + to,
        }
    }
}

/// A scene of a TSPLIB instance.
pub(in super::super) fn import(file: &NamedFile) -> Result<Imported, Error> {
    let mut words = Words::new(file)?;
    let mut instance = Instance::default();
    while let Some((keyword, value)) = words.keyword() {
        instance.read(&mut words, keyword, value)?;
    }
    let body = Arc::new(instance.scene(file, words.line)?);
    // Some files have their own name there.
    let name = instance.name.strip_suffix(".tsp").unwrap_or(instance.name);
    let name = if name.is_empty() { stem(&file.name) } else { name };
    let note = [instance.comments, instance.notes.clone()].concat();
    Ok(Imported::new(scene_named(name, file, "TSPLIB file", None, tour::KIND.optimum, body, &note)?, instance.notes))
}

impl<'a> Instance<'a> {
    fn read(&mut self, words: &mut Words<'a>, keyword: &'a str, value: &'a str) -> Result<(), Error> {
        let line = words.line;
        let expect = |fits: bool, expected: Message| if fits { Ok(()) } else { Err(words.file.unexpected(line, value, &expected)) };
        if let Some(before) = self.line_of(keyword).filter(|_| keyword != "COMMENT") {
            return Err(words.file.again(line, keyword, before));
        }
        self.seen.push((keyword, line));
        match keyword {
            "NAME" => self.name = value,
            "COMMENT" => self.comments.extend((!value.is_empty()).then(|| Message::verbatim(value))),
            // Some files have a name behind it.
            "TYPE" => {
                let expected = message!("files-type", "for TYPE TSP: no other problem is read");
                expect(value.split_whitespace().next() == Some("TSP"), expected)?;
            }
            "DIMENSION" => {
                self.n = value.parse().ok().filter(|n| (2..=MAX_STOPS).contains(n));
                expect(self.n.is_some(), stops_up_to(MAX_STOPS))?;
            }
            "EDGE_WEIGHT_TYPE" => {
                self.measure = match value {
                    "EUC_2D" => Some(Measure::By(Metric::Euc2d)),
                    "CEIL_2D" => Some(Measure::By(Metric::Ceil2d)),
                    "ATT" => Some(Measure::By(Metric::Att)),
                    "GEO" => Some(Measure::By(Metric::Geo)),
                    "EXPLICIT" => Some(Measure::Explicit),
                    _ => None,
                };
                let expected = message!(
                    "files-weight-type",
                    "for EDGE_WEIGHT_TYPE EUC_2D, CEIL_2D, ATT, GEO or EXPLICIT: no other distances are read"
                );
                expect(self.measure.is_some(), expected)?;
            }
            "EDGE_WEIGHT_FORMAT" => {
                self.shape = Shape::named(value);
                // Files with a formula may say so; where there is none it is refused below.
                expect(self.shape.is_some() || value == "FUNCTION", forms())?;
            }
            "NODE_COORD_TYPE" => {
                let expected = message!("files-coord-type", "for NODE_COORD_TYPE TWOD_COORDS or NO_COORDS");
                expect(["TWOD_COORDS", "NO_COORDS"].contains(&value), expected)?;
            }
            "DISPLAY_DATA_TYPE" => {
                let expected = message!("files-display", "for DISPLAY_DATA_TYPE COORD_DISPLAY, TWOD_DISPLAY or NO_DISPLAY");
                expect(["COORD_DISPLAY", "TWOD_DISPLAY", "NO_DISPLAY"].contains(&value), expected)?;
            }
            "NODE_COORD_SECTION" => self.coordinates = self.points(words, keyword)?,
            "DISPLAY_DATA_SECTION" => self.places = self.points(words, keyword)?,
            "EDGE_WEIGHT_SECTION" => self.matrix(words)?,
            "FIXED_EDGES_SECTION" => self.fixed(words, keyword)?,
            _ if keyword.ends_with("_SECTION") => {
                let expected = message!(
                    "files-sections",
                    "NODE_COORD_SECTION, EDGE_WEIGHT_SECTION, FIXED_EDGES_SECTION or DISPLAY_DATA_SECTION: other sections change the problem"
                );
                return Err(words.file.unexpected(line, keyword, &expected));
            }
            _ if keyword.bytes().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == b'_') && keyword.len() > 3 => {
                self.notes.push(message!(
                    "files-keyword-not-read",
                    "Line {line} of {file}, `{keyword}`, is not known and was not read.",
                    line,
                    file = words.file.label(),
                    keyword
                ));
            }
            _ => return Err(words.file.unexpected(line, keyword, &message!("files-keyword", "a keyword, a section or EOF"))),
        }
        Ok(())
    }

    /// Where a keyword stands.
    fn line_of(&self, keyword: &str) -> Option<usize> {
        self.seen.iter().find(|(seen, _)| *seen == keyword).map(|(_, line)| *line)
    }

    /// How many stops there are, where a section needs to know it.
    fn count(&self, words: &Words, section: &str) -> Result<usize, Error> {
        self.n.ok_or_else(|| words.file.wrong(words.line, &too_early(section, "DIMENSION")))
    }

    /// A point for each stop, in the order of their numbers.
    fn points(&self, words: &mut Words, section: &str) -> Result<Vec<[f64; 2]>, Error> {
        let n = self.count(words, section)?;
        let (mut points, mut called) = (vec![[0.0; 2]; n], vec![false; n]);
        for _ in 0..n {
            let stop = words.stop(n, &mut called)?;
            for (axis, c) in points[stop].iter_mut().enumerate() {
                let expected = || {
                    message!(
                        "files-coordinate",
                        "for stop {stop} coordinate {axis} a number from {least} to {most}",
                        stop = stop + 1,
                        axis = axis + 1,
                        least = -FARTHEST,
                        most = FARTHEST
                    )
                };
                *c = words.take(|word| number_up_to(FARTHEST, word), &expected)?;
            }
        }
        words.end_of_line(&|| message!("files-end-of-stops", "the end of the line after {n} stops", n))?;
        Ok(points)
    }

    /// Pairs of stops, up to -1.
    fn fixed(&mut self, words: &mut Words, section: &str) -> Result<(), Error> {
        let n = self.count(words, section)?;
        let mut called = vec![false; n];
        while !words.skip("-1") {
            let pair = [words.stop(n, &mut called)?, words.stop(n, &mut called)?];
            pair.iter().for_each(|&stop| called[stop] = false);
            self.fixed.push(pair);
        }
        Ok(())
    }

    fn matrix(&mut self, words: &mut Words) -> Result<(), Error> {
        let n = self.count(words, "EDGE_WEIGHT_SECTION")?;
        let shape = self.shape.ok_or_else(|| match self.line_of("EDGE_WEIGHT_FORMAT") {
            Some(line) => words.file.unexpected(line, "FUNCTION", &forms()),
            None => words.file.wrong(words.line, &too_early("EDGE_WEIGHT_SECTION", "EDGE_WEIGHT_FORMAT")),
        })?;
        if n > MAX_MATRIX {
            return Err(words.file.unexpected(words.line, "EDGE_WEIGHT_SECTION", &stops_up_to(MAX_MATRIX)));
        }
        self.weights = vec![f64::NAN; n * n];
        let mut diagonal = 0;
        for i in 0..n {
            for j in shape.row(i, n) {
                let expected = || {
                    message!(
                        "files-distance",
                        "a distance from 0 to {most} between stops {i} and {j}",
                        most = LONGEST,
                        i = i + 1,
                        j = j + 1
                    )
                };
                let word = words.word();
                let read = word.and_then(|word| number_up_to(LONGEST, word)).filter(|d| *d >= 0.0 || i == j);
                let d = read.ok_or_else(|| words.refuse(word, &expected()))?;
                let back = self.weights[j * n + i];
                if i == j {
                    diagonal += usize::from(d != 0.0);
                } else if d != back && !back.is_nan() {
                    let expected = message!(
                        "files-symmetric",
                        "{back} from stop {i} to {j}, as in the other direction: distances are symmetric",
                        back,
                        i = i + 1,
                        j = j + 1
                    );
                    return Err(words.refuse(word, &expected));
                }
                (self.weights[i * n + j], self.weights[j * n + i]) = (d, d);
            }
        }
        if diagonal > 0 {
            self.notes.push(message!(
                "files-diagonal",
                "{n} distances from a stop to itself are not 0; no tour goes there, and they were left out.",
                n = diagonal
            ));
        }
        words.end_of_line(&|| message!("files-end-of-distances", "the end of the line after the distances of {n} stops", n))
    }

    /// The stops, once all is read; the file ends in line `end`.
    fn scene(&mut self, file: &NamedFile, end: usize) -> Result<TourScene, Error> {
        let missing = |what: &str| file.ends_without(end.max(1), what);
        for keyword in ["TYPE", "DIMENSION", "EDGE_WEIGHT_TYPE"] {
            self.line_of(keyword).ok_or_else(|| missing(keyword))?;
        }
        let n = self.n.unwrap_or_default();
        let mut scene = match self.measure {
            Some(Measure::By(metric)) => {
                if let Some(line) = self.line_of("EDGE_WEIGHT_SECTION") {
                    let problem = message!("files-not-explicit", "`EDGE_WEIGHT_SECTION`, but `EDGE_WEIGHT_TYPE` is not EXPLICIT");
                    return Err(file.wrong(line, &problem));
                }
                if self.coordinates.is_empty() {
                    return Err(missing("NODE_COORD_SECTION"));
                }
                if !self.places.is_empty() {
                    self.notes.push(message!(
                        "files-display-left-out",
                        "The places in `DISPLAY_DATA_SECTION` were left out: stops are drawn where they are."
                    ));
                }
                let mut points = std::mem::take(&mut self.coordinates);
                if metric == Metric::Geo {
                    // Latitude first, as people say it; y grows to the north.
                    points.iter_mut().for_each(|point| point.swap(0, 1));
                }
                TourScene::through(points, metric)
            }
            _ if self.weights.is_empty() => return Err(missing("EDGE_WEIGHT_SECTION")),
            _ => {
                let places = if self.places.is_empty() { &mut self.coordinates } else { &mut self.places };
                TourScene::by(Distances::of(n, |i, j| self.weights[i * n + j]), std::mem::take(places))
            }
        };
        scene.fixed = std::mem::take(&mut self.fixed);
        Ok(scene)
    }
}

/// How many stops there may be.
fn stops_up_to(most: usize) -> Message {
    message!("files-dimension", "for DIMENSION a number of stops from 2 to {most}", most)
}

/// What is wrong with a section that needs a keyword before it.
fn too_early(section: &str, keyword: &str) -> Message {
    message!("files-too-early", "`{section}` before `{keyword}`", section, keyword)
}
