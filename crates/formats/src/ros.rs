//! The maps of ROS's map_server: a `.yaml` that says what the pixels of a `.pgm` mean,
//! <https://wiki.ros.org/map_server>. The origin is at the lower left, lengths are in metres.
//!
//! A pixel's occupancy is (white − value) / white, or value / white if `negate`. Below `free_thresh` a cell is free, above
//! `occupied_thresh` it is blocked, between them it is unknown (`mode: trinary`) or partly occupied (`mode: scale`). With
//! `mode: raw` the value itself, of 255, is the occupancy in percent; above 100 it is unknown. What is not free is blocked
//! in every mode, and a note counts the cells between.

use std::sync::Arc;

use forage::{
    geometry::YAxis,
    kernel::{Error, Message, digits::Digits, json},
    message,
    scene::{GridScene, LARGEST, grid},
};

use super::{
    ends,
    file::{NamedFile, for_number},
    pgm,
    report::{Exported, Imported, lost, note_other_name, scene},
};

/// A line `key: value`, or `key:` with a list below it.
struct Entry<'a> {
    line: usize,
    key: &'a str,
    /// One value, or a list's.
    values: Vec<&'a str>,
    listed: bool,
}

/// A map's description has about ten.
const MOST_KEYS: usize = 100;

/// What a file says, and who asks.
struct Yaml<'a> {
    file: &'a NamedFile,
    entries: Vec<Entry<'a>>,
}

/// A line without the comment at its end; a `#` counts only between quotes or inside a word.
fn without_comment(line: &str) -> &str {
    let (mut quote, mut before) = (None, b' ');
    for (i, byte) in line.bytes().enumerate() {
        match byte {
            b'"' | b'\'' if quote.is_none() => quote = Some(byte),
            _ if quote == Some(byte) => quote = None,
            b'#' if quote.is_none() && before.is_ascii_whitespace() => return line[..i].trim_end(),
            _ => {}
        }
        before = byte;
    }
    line
}

impl<'a> Yaml<'a> {
    /// Reads the part of YAML that such files use: keys with values, lists on one line or below their key, comments, quotes.
    fn read(file: &'a NamedFile) -> Result<Self, Error> {
        let mut entries: Vec<Entry> = Vec::new();
        for (line, whole) in file.lines()? {
            let text = without_comment(whole);
            if text.is_empty() || text == "---" {
                continue;
            }
            if let Some(item) = text.trim_start().strip_prefix("- ") {
                let Some(list) = entries.last_mut().filter(|entry| entry.listed) else {
                    return Err(file.unexpected(line, text, &message!("files-list-key", "a list's key before its items")));
                };
                list.values.push(unquoted(file, line, item)?);
                continue;
            }
            let Some((key, value)) = text.split_once(':').filter(|(key, _)| !key.starts_with([' ', '\t']) && !key.is_empty()) else {
                return Err(file.unexpected(line, text, &message!("files-key-value", "`key: value`, not indented")));
            };
            let (key, value) = (key.trim(), value.trim());
            if entries.len() == MOST_KEYS {
                return Err(
                    file.wrong(line, &message!("files-most-keys", "more than {most} keys: this describes no map", most = MOST_KEYS))
                );
            }
            if let Some(other) = entries.iter().find(|entry| entry.key == key) {
                return Err(file.again(line, key, other.line));
            }
            let (values, listed) = if let Some(list) = value.strip_prefix('[') {
                let open = || file.unexpected(line, value, &message!("files-list-end", "a list with `]` at its end"));
                let list = list.strip_suffix(']').ok_or_else(open)?;
                (list.split(',').map(|item| unquoted(file, line, item)).collect::<Result<_, _>>()?, false)
            } else if value.is_empty() {
                (Vec::new(), true)
            } else {
                (vec![unquoted(file, line, value)?], false)
            };
            entries.push(Entry { line, key, values, listed });
        }
        Ok(Self { file, entries })
    }

    fn take(&mut self, key: &str) -> Option<Entry<'a>> {
        let at = self.entries.iter().position(|entry| entry.key == key)?;
        Some(self.entries.remove(at))
    }

    /// A key's only value, with its line.
    fn one(&mut self, key: &str, expected: &Message) -> Result<Option<(usize, &'a str)>, Error> {
        let Some(Entry { line, values, .. }) = self.take(key) else {
            return Ok(None);
        };
        let [value] = values[..] else {
            let n = values.len();
            let problem = message!("files-values", "`{key}` has {n} values, expected {expected}", key, n, expected);
            return Err(self.file.wrong(line, &problem));
        };
        Ok(Some((line, value)))
    }

    /// A key's number, if it is given.
    fn number(&mut self, key: &str, least: f64, most: f64) -> Result<Option<(usize, f64)>, Error> {
        let expected = for_number(key, least, most);
        let Some((line, text)) = self.one(key, &expected)? else {
            return Ok(None);
        };
        let number = json::number(text).filter(|number| (least..=most).contains(number));
        number.map(|number| Some((line, number))).ok_or_else(|| self.file.unexpected(line, text, &expected))
    }

    fn missing(&self, key: &str) -> Error {
        let line = 1 + self.entries.iter().map(|entry| entry.line).max().unwrap_or(0);
        self.file.ends_without(line, &format!("{key}:"))
    }
}

/// A value without its spaces and quotes.
fn unquoted<'a>(file: &NamedFile, line: usize, text: &'a str) -> Result<&'a str, Error> {
    let text = text.trim();
    let Some(quote) = text.chars().next().filter(|c| matches!(c, '"' | '\'')) else {
        return Ok(text);
    };
    let inside = text[1..].strip_suffix(quote).filter(|inside| !inside.contains(quote));
    inside.ok_or_else(|| file.unexpected(line, text, &message!("files-quotes", "a text between two quotes")))
}

fn image(yaml: &mut Yaml) -> Result<String, Error> {
    let expected = message!("files-image", "the name of a .pgm file");
    match yaml.one("image", &expected)? {
        Some((line, "")) => Err(yaml.file.unexpected(line, "", &expected)),
        Some((_, name)) => Ok(name.to_owned()),
        None => Err(yaml.missing("image")),
    }
}

/// The picture that a file names.
pub(super) fn image_of(file: &NamedFile) -> Result<String, Error> {
    image(&mut Yaml::read(file)?)
}

/// What is to be done with a pixel's value.
struct Rule {
    free: f64,
    occupied: f64,
    negate: bool,
    raw: bool,
}

impl Rule {
    /// A pixel's occupancy; `None` if it says that it is unknown.
    fn occupancy(&self, value: u16, white: u16) -> Option<f64> {
        let (value, white) = (f64::from(value), f64::from(white));
        if self.raw {
            let percent = (value / white * 255.0).round();
            return (percent <= 100.0).then_some(percent / 100.0);
        }
        Some(if self.negate { value } else { white - value } / white)
    }
}

/// What is said of cells between free and blocked: how many of all they are.
type Unclear = fn(usize, usize) -> Message;

fn rule(yaml: &mut Yaml) -> Result<(Rule, Unclear), Error> {
    let occupied = yaml.number("occupied_thresh", 0.0, 1.0)?;
    let free = yaml.number("free_thresh", 0.0, 1.0)?;
    let line = free.or(occupied).map_or(1, |(line, _)| line);
    let (occupied, free) = (occupied.map_or(0.65, |(_, value)| value), free.map_or(0.196, |(_, value)| value));
    if free > occupied {
        let problem = message!("files-thresholds", "free_thresh is {free}, expected at most occupied_thresh, {occupied}", free, occupied);
        return Err(yaml.file.wrong(line, &problem));
    }
    let negate = match yaml.one("negate", &message!("files-negate", "0 or 1"))? {
        None => false,
        // Python writes its flags with capitals.
        Some((_, text)) if ["0", "false"].iter().any(|no| text.eq_ignore_ascii_case(no)) => false,
        Some((_, text)) if ["1", "true"].iter().any(|yes| text.eq_ignore_ascii_case(yes)) => true,
        Some((line, text)) => return Err(yaml.file.unexpected(line, text, &message!("files-for-negate", "for negate 0 or 1"))),
    };
    let unknown: Unclear = |n, all| message!("files-unknown-cells", "{n} of {all} cells are unknown, taken as blocked.", n, all);
    let partly: Unclear = |n, all| message!("files-partly-cells", "{n} of {all} cells are partly occupied, taken as blocked.", n, all);
    let either: Unclear =
        |n, all| message!("files-unclear-cells", "{n} of {all} cells are unknown or partly occupied, taken as blocked.", n, all);
    let (raw, unclear) = match yaml.one("mode", &message!("files-mode", "trinary, scale or raw"))? {
        None | Some((_, "trinary")) => (false, unknown),
        Some((_, "scale")) => (false, partly),
        Some((_, "raw")) => (true, either),
        Some((line, text)) => {
            return Err(yaml.file.unexpected(line, text, &message!("files-for-mode", "for mode trinary, scale or raw")));
        }
    };
    Ok((Rule { free, occupied, negate, raw }, unclear))
}

/// Where the lower left corner is in the robot's world: a scene begins at (0, 0), so a note keeps it.
fn note_origin(yaml: &mut Yaml, notes: &mut Vec<Message>) -> Result<(), Error> {
    let Some(Entry { line, values, .. }) = yaml.take("origin") else {
        return Ok(());
    };
    let numbers: Option<Vec<_>> = values.iter().map(|text| json::number(text).filter(|number| number.is_finite())).collect();
    let Some(&[x, y, yaw]) = numbers.as_deref() else {
        let expected = message!("files-for-origin", "for origin three numbers, [x, y, yaw]");
        return Err(yaml.file.unexpected(line, &values.join(", "), &expected));
    };
    if yaw != 0.0 {
        notes.push(message!(
            "files-turned-origin",
            "The lower left corner, (0, 0) here, is the file's origin ({x}, {y}), turned by {yaw} rad (it is not turned here).",
            x,
            y,
            yaw
        ));
    } else if [x, y] != [0.0; 2] {
        notes.push(message!("files-origin", "The lower left corner, (0, 0) here, is the file's origin ({x}, {y}).", x, y));
    }
    Ok(())
}

/// A scene of a map's two files.
pub(super) fn import(file: &NamedFile, picture: &NamedFile) -> Result<Imported, Error> {
    let mut yaml = Yaml::read(file)?;
    let mut notes = Vec::new();
    note_other_name(file, &image(&mut yaml)?, picture, &mut notes);
    let (line, resolution) = yaml.number("resolution", 1e-6, LARGEST)?.ok_or_else(|| yaml.missing("resolution"))?;
    note_origin(&mut yaml, &mut notes)?;
    let (rule, are_unclear) = rule(&mut yaml)?;
    for Entry { line, key, .. } in &yaml.entries {
        notes.push(message!("files-line-not-read", "Line {line} of {file}, `{key}`, was not read.", line, file = file.label(), key));
    }
    let image = pgm::read(picture)?;
    if image.rest > 0 {
        notes.push(message!(
            "files-rest",
            "The last {n} bytes of {file} were not read: its pixels end before.",
            n = image.rest,
            file = picture.label()
        ));
    }
    let longest = LARGEST / image.columns.max(image.rows) as f64;
    if resolution > longest {
        let problem = message!(
            "files-resolution",
            "resolution is {resolution}, expected at most {most} for a picture of this size",
            resolution,
            most = longest
        );
        return Err(file.wrong(line, &problem));
    }
    let (mut blocked, mut unclear) = (Vec::with_capacity(image.values.len()), 0_usize);
    // The picture has its top row first; rows of a scene go by growing y.
    for row in image.values.chunks(image.columns).rev() {
        for &value in row {
            let occupancy = rule.occupancy(value, image.white);
            blocked.push(occupancy.is_none_or(|occupancy| occupancy >= rule.free));
            unclear += usize::from(occupancy.is_none_or(|occupancy| occupancy >= rule.free && occupancy <= rule.occupied));
        }
    }
    if unclear > 0 {
        notes.push(are_unclear(unclear, image.columns * image.rows));
    }
    let mut grid = GridScene::new(resolution, image.columns, blocked);
    grid.y_axis = YAxis::Up;
    notes.push(
        ends::choose(&mut grid)
            .ok_or_else(|| Error::malformed(picture.label(), message!("files-no-free-cell", "no cell of the map is free")))?,
    );
    Ok(Imported::new(scene(file, "ROS map", Some("m"), grid::KIND.optimum, Arc::new(grid), &notes)?, notes))
}

/// A map's two files.
pub(super) fn export(grid: &GridScene, stem: &str) -> Exported {
    let mut notes = Vec::new();
    lost(grid, &mut notes);
    if grid.start.is_some() {
        notes.push(message!("files-ends-not-kept", "Not kept, as the format has no place for them: start and goal."));
    }
    let values: Vec<u8> = grid.lines().iter().flat_map(|line| line.bytes().map(|cell| if cell == b'#' { 0 } else { 254 })).collect();
    let yaml = format!(
        "image: \"{stem}.pgm\"\nmode: trinary\nresolution: {}\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
        Digits(grid.cell)
    );
    let files =
        vec![NamedFile::new(format!("{stem}.yaml"), yaml), NamedFile::new(format!("{stem}.pgm"), pgm::write(grid.columns, &values))];
    Exported { files, notes }
}
