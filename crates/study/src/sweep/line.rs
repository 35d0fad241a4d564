//! A row as a line: CSV or JSON Lines, with the same columns and the same digits.

use std::{io, path::Path, sync::Arc};

use serde_json::{Map, Value};

use forage::{
    Scene,
    kernel::{Error, Message, ReferenceOptimum},
    message,
    run::trial::Record,
};

use super::{
    super::{
        digest::{self, DIGITS},
        spreadsheet,
    },
    plan::Sweep,
    text::{number_text, value_text},
};

/// What is in front of the parameters,
const LEAD: [&str; 3] = ["scene", "planner", "seed"];
/// and what is behind them: a [`Record`]'s fields, and what counts as reached. No times: rows are the same everywhere.
const RESULTS: [&str; 20] = [
    "status",
    "limit",
    "iterations",
    "budget",
    "evaluations",
    "cost",
    "length",
    "value",
    "feasible",
    "clearance",
    "exact",
    "exact_by",
    "gap",
    "within",
    "reached",
    "reached_iteration",
    "settled",
    "turns",
    "deterministic",
    "hash",
];

/// What is last in a row: see [`digest`].
const DIGEST: &str = "digest";
/// What is in front of it, without the text itself, in a line of JSON.
const JSON_DIGEST: &[u8] = b",\"digest\":\"";

/// How rows are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// With a line of names above; nothing where there is nothing.
    Csv,
    /// An object a line; null where there is nothing.
    JsonLines,
}

impl Format {
    /// By the file's ending; `field` names the option or the field that the file comes from.
    ///
    /// # Errors
    /// Any other ending than .csv, .jsonl and .ndjson.
    pub fn of(field: &str, path: &Path) -> Result<Self, Error> {
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("csv") => Ok(Self::Csv),
            Some("jsonl" | "ndjson") => Ok(Self::JsonLines),
            _ => Err(Error::refused(
                field,
                path.display().to_string(),
                message!("study-rows-ending", "a file that ends in .csv, .jsonl or .ndjson"),
            )),
        }
    }

    /// What is above the rows.
    pub(super) fn heading(self, sweep: &Sweep) -> io::Result<Vec<u8>> {
        match self {
            Self::Csv => csv_line(&columns(sweep)),
            Self::JsonLines => Ok(Vec::new()),
        }
    }

    /// What every file of this kind begins with, as far as it is known.
    pub(super) fn beginnings(self, sweep: &Sweep) -> io::Result<Vec<Vec<u8>>> {
        match self {
            Self::Csv => Ok(vec![self.heading(sweep)?]),
            Self::JsonLines => {
                let of_scene = |scene: &Arc<Scene>| format!("{{\"scene\":{},\"planner\":\"", Value::from(scene.name())).into_bytes();
                Ok(sweep.scenes.iter().map(of_scene).collect())
            }
        }
    }

    /// Whether a first line is, as far as it goes, that of some sweep's rows.
    pub(super) fn begins(self, line: &[u8]) -> bool {
        let (beginning, last): (&[u8], &[u8]) = match self {
            Self::Csv if line.ends_with(b",hash\n") => (b"scene,planner,seed,", b""),
            Self::Csv => (b"scene,planner,seed,", b",hash,digest\n"),
            Self::JsonLines => (b"{\"scene\":\"", b"\"}\n"),
        };
        let known = beginning.len().min(line.len());
        beginning[..known] == line[..known] && (!line.ends_with(b"\n") || line.ends_with(last))
    }

    /// Whether a first line is that of rows from before they had digests.
    pub(super) fn is_old(self, sweep: &Sweep, line: &[u8]) -> io::Result<bool> {
        Ok(match self {
            Self::Csv => {
                let columns = columns(sweep);
                line == csv_line(&columns[..columns.len() - 1])?
            }
            Self::JsonLines => serde_json::from_slice::<Map<String, Value>>(line)
                .is_ok_and(|fields| fields.contains_key("hash") && !fields.contains_key(DIGEST)),
        })
    }

    /// What is wrong with a first line that is not that of rows.
    pub(super) fn wrong_beginning(self, sweep: &Sweep, line: &[u8]) -> io::Result<Message> {
        if self.is_old(sweep, line)? {
            return Ok(digest::missing());
        }
        let heading = self.heading(sweep)?;
        let ends = line.strip_suffix(b"\r\n").is_some_and(|line| {
            self == Self::JsonLines && self.begins(&[line, b"\n"].concat()) || heading.strip_suffix(b"\n") == Some(line)
        });
        if ends {
            return Ok(message!(
                "study-line-ends",
                "its lines end with CR and LF, which another program has made of LF: convert them back"
            ));
        }
        Ok(if heading.is_empty() || !line.ends_with(b"\n") {
            message!("study-no-file-of-rows", "it does not begin like a file of rows")
        } else {
            let line = String::from_utf8_lossy(&heading).trim_end().to_owned();
            message!("study-first-line", "its first line is not {line}", line)
        })
    }

    /// A run's row.
    pub(super) fn line(self, sweep: &Sweep, job: usize, record: &Record) -> io::Result<Vec<u8>> {
        let setup = sweep.setup(job);
        let known = serde_json::to_value(record)?;
        let lead = LEAD.iter().map(|name| item(&known[name]));
        let parameters = sweep.parameters.iter().map(|name| match setup.params.get(name) {
            Some(forage::Value::Text(text)) => Item::Text(text.clone()),
            Some(other) => Item::Bare(value_text(other)),
            None => Item::Nothing,
        });
        let results = RESULTS.iter().map(|&name| match name {
            "within" => Item::Bare(number_text(sweep.within)),
            "budget" => sweep.allowance(job).map_or(Item::Nothing, |budget| Item::Bare(budget.to_string())),
            _ => item(&known[name]),
        });
        let items: Vec<Item> = lead.chain(parameters).chain(results).collect();
        let mut row = match self {
            Self::Csv => {
                let mut line = csv_line(&items.iter().map(|item| spreadsheet::safe(item.text()).into_owned()).collect::<Vec<_>>())?;
                line.pop();
                line
            }
            Self::JsonLines => {
                let fields: Vec<String> = columns(sweep)
                    .iter()
                    .zip(&items)
                    .map(|(name, item)| format!("{}:{}", Value::from(name.as_str()), item.json()))
                    .collect();
                format!("{{{}", fields.join(",")).into_bytes()
            }
        };
        let digest = digest::of(sweep.origin(job), &row);
        let [front, behind] = self.around_digest();
        row.extend([front, digest.as_bytes(), behind].concat());
        Ok(row)
    }

    /// What stands before and behind a row's digest.
    fn around_digest(self) -> [&'static [u8]; 2] {
        match self {
            Self::Csv => [b",", b"\n"],
            Self::JsonLines => [JSON_DIGEST, b"\"}\n"],
        }
    }

    /// What is in front of a line's digest, and the digest.
    fn parts(self, line: &[u8]) -> Option<(&[u8], &[u8])> {
        let [front, behind] = self.around_digest();
        let (rest, digest) = line.strip_suffix(behind)?.split_last_chunk::<DIGITS>()?;
        Some((rest.strip_suffix(front)?, digest))
    }

    /// The run's hash, which is in front of the digest.
    pub(super) fn hash_of(self, line: &[u8]) -> Option<String> {
        let (row, _) = self.parts(line)?;
        let row = match self {
            Self::Csv => row,
            Self::JsonLines => row.strip_suffix(b"\"")?,
        };
        let (_, hash) = row.split_last_chunk::<DIGITS>()?;
        str::from_utf8(hash).ok().map(str::to_owned)
    }

    /// The texts of a row without its digest, in the order of the columns.
    ///
    /// # Errors
    /// What is wrong with it.
    fn texts(self, sweep: &Sweep, line: &[u8]) -> Result<Vec<String>, Wrong> {
        let count = LEAD.len() + sweep.parameters.len() + RESULTS.len();
        let texts: Vec<String> = match self {
            // Where nothing is quoted commas are all there is: a reader of its own for each line would take most of the time.
            Self::Csv if !line.contains(&b'"') => {
                let text = str::from_utf8(line).map_err(|problem| unreadable(&problem))?;
                text.split(',').map(|text| spreadsheet::plain(text).to_owned()).collect()
            }
            Self::Csv => {
                let mut reader = csv::ReaderBuilder::new().has_headers(false).buffer_capacity(1 << 10).from_reader(line);
                let record = reader.records().next().ok_or_else(|| damaged(empty()))?.map_err(|problem| unreadable(&problem))?;
                record.iter().map(|text| spreadsheet::plain(text).to_owned()).collect()
            }
            Self::JsonLines => {
                let whole = [line, b"}"].concat();
                let mut fields: Map<String, Value> = serde_json::from_slice(&whole).map_err(|problem| unreadable(&problem))?;
                let mut columns = columns(sweep);
                columns.pop();
                let texts = columns.iter().map(|name| fields.remove(name).map(|value| item(&value).text().to_owned()));
                let texts = texts.collect::<Option<Vec<_>>>().ok_or_else(|| {
                    Wrong::Other(message!("study-other-fields", "its fields are not {names}", names = columns.join(", ")))
                })?;
                if let Some(name) = fields.keys().next() {
                    return Err(Wrong::Other(message!("study-more-fields", "it has a field `{name}`", name)));
                }
                texts
            }
        };
        if texts.len() == count {
            Ok(texts)
        } else {
            Err(damaged(message!("study-number-of-values", "it has {found} values, not {count}", found = texts.len(), count)))
        }
    }

    /// Which run a line tells of, and what of it.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn read(self, sweep: &Sweep, line: &[u8]) -> Result<(usize, RunStatistics), Wrong> {
        if line.trim_ascii().is_empty() {
            return Err(damaged(empty()));
        }
        let (row, digest) = self.parts(line).ok_or_else(|| damaged(message!("study-digest-missing", "it does not end with a digest")))?;
        let texts = self.texts(sweep, row)?;
        let (lead, rest) = texts.split_at(LEAD.len());
        let origin = sweep
            .origin_of(&lead[0])
            .ok_or_else(|| damaged(message!("study-no-such-scene", "the experiment has no scene {scene}", scene = lead[0])))?;
        if digest::of(origin, row).as_bytes() != digest {
            return Err(damaged(digest::differs()));
        }
        let (parameters, results) = rest.split_at(sweep.parameters.len());
        let parameters: Vec<&str> = parameters.iter().map(String::as_str).collect();
        let job = sweep.find(&lead[0], &lead[1], &lead[2], &parameters).ok_or_else(|| {
            let mut set = String::new();
            for (name, text) in sweep.parameters.iter().zip(&parameters).filter(|(_, text)| !text.is_empty()) {
                set.extend([" ", name, "=", text, ","]);
            }
            let (scene, planner, seed) = (&lead[0], &lead[1], &lead[2]);
            Wrong::Other(message!(
                "study-no-such-run",
                "there is no run of {planner} on {scene},{set} seed {seed}",
                planner,
                scene,
                set,
                seed
            ))
        })?;
        let result = |name: &str| RESULTS.iter().position(|known| *known == name).map_or("", |at| results[at].as_str());
        let (within, ours) = (result("within"), number_text(sweep.within));
        if within != ours {
            return Err(Wrong::Other(message!("study-within-differs", "its `within` is {within}, not {ours}", within, ours)));
        }
        let (budget, ours) = (result("budget"), sweep.allowance(job).map_or(String::new(), |budget| budget.to_string()));
        if budget != ours {
            return Err(Wrong::Other(message!(
                "study-budget-differs",
                "its `budget` is {found}, not {ours}",
                found = shown(budget),
                ours = shown(&ours)
            )));
        }
        let number = |name: &str| match result(name) {
            "" => Ok(None),
            text => text
                .parse::<f64>()
                .map(Some)
                .map_err(|_| damaged(message!("study-no-number", "{name} is `{text}`, which is no number", name, text))),
        };
        let flag = |name: &str| {
            let text = result(name);
            text.parse::<bool>().map_err(|_| damaged(message!("study-no-flag", "{name} is `{text}`; it must be true or false", name, text)))
        };
        let hash = result("hash");
        u64::from_str_radix(hash, 16)
            .map_err(|_| damaged(message!("study-no-hash", "hash is `{hash}`; it must be 16 hexadecimal digits", hash)))?;
        let by = match result("exact_by") {
            "cells" => ReferenceOptimum::Cells,
            "matrix" => ReferenceOptimum::Matrix,
            "stored" => ReferenceOptimum::Stored,
            "refuted" => ReferenceOptimum::Refuted,
            _ => ReferenceOptimum::AnyAngle,
        };
        let exact = number("exact")?;
        let (value, reached, deterministic) = (number("value")?, number("reached")?, flag("deterministic")?);
        let evaluations = number("evaluations")?.ok_or_else(|| damaged(message!("study-no-evaluations", "evaluations is missing")))?;
        Ok((job, RunStatistics { value, reached, evaluations, measured: exact.is_some(), zero: exact == Some(0.0), by, deterministic }))
    }
}

fn shown(budget: &str) -> Message {
    if budget.is_empty() { message!("study-own-budget", "that of its own iterations") } else { Message::verbatim(budget) }
}

/// What is wrong with a line.
#[derive(Debug)]
pub(super) enum Wrong {
    /// It is no row.
    Damaged(Message),
    /// It is a row of something else.
    Other(Message),
}

fn empty() -> Message {
    message!("study-it-is-empty", "it is empty")
}

/// What a reader says.
fn unreadable(problem: &impl ToString) -> Wrong {
    Wrong::Damaged(Message::verbatim(problem.to_string()))
}

fn damaged(problem: Message) -> Wrong {
    Wrong::Damaged(problem)
}

/// What the statistics need of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct RunStatistics {
    pub(super) value: Option<f64>,
    /// Evaluations after which it came near enough to the optimum.
    pub(super) reached: Option<f64>,
    /// How many evaluations there were.
    pub(super) evaluations: f64,
    /// There is an optimum to measure it by.
    pub(super) measured: bool,
    /// It is 0.
    pub(super) zero: bool,
    /// Which one.
    pub(super) by: ReferenceOptimum,
    /// No random number has a part in it.
    pub(super) deterministic: bool,
}

impl From<&Record> for RunStatistics {
    fn from(record: &Record) -> Self {
        // What is no number is not written, either.
        let value = record.value.filter(|value| value.is_finite());
        let reached = record.reached.map(|evaluations| evaluations as f64);
        let (evaluations, deterministic) = (record.evaluations as f64, record.deterministic);
        Self {
            value,
            reached,
            evaluations,
            measured: record.exact.is_some(),
            zero: record.exact == Some(0.0),
            by: record.exact_by,
            deterministic,
        }
    }
}

/// Whether a column that is no parameter has this name.
pub(super) fn is_taken(name: &str) -> bool {
    LEAD.contains(&name) || RESULTS.contains(&name) || name == DIGEST
}

/// The columns' names. A parameter that is called as something else is, is written as in links: `p.iterations`.
pub(super) fn columns(sweep: &Sweep) -> Vec<String> {
    let parameters = sweep.parameters.iter().map(|name| if is_taken(name) { format!("p.{name}") } else { name.clone() });
    let results = RESULTS.into_iter().chain([DIGEST]).map(str::to_owned);
    LEAD.map(str::to_owned).into_iter().chain(parameters).chain(results).collect()
}

/// What stands at one place of a row.
enum Item {
    Nothing,
    /// A number, true or false.
    Bare(String),
    Text(String),
}

impl Item {
    fn text(&self) -> &str {
        match self {
            Self::Nothing => "",
            Self::Bare(text) | Self::Text(text) => text,
        }
    }

    fn json(&self) -> String {
        match self {
            Self::Nothing => "null".to_owned(),
            Self::Bare(text) => text.clone(),
            Self::Text(text) => Value::from(text.as_str()).to_string(),
        }
    }
}

fn item(value: &Value) -> Item {
    match value {
        Value::Null => Item::Nothing,
        Value::Number(number) => Item::Bare(match (number.as_u64(), number.as_f64()) {
            (None, Some(float)) => number_text(float),
            _ => number.to_string(),
        }),
        Value::String(text) => Item::Text(text.clone()),
        other => Item::Bare(other.to_string()),
    }
}

fn csv_line<T: AsRef<[u8]>>(texts: &[T]) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(texts).map_err(io::Error::other)?;
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}
