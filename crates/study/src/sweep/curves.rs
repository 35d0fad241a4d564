//! Convergence curves: kept run by run in a file of their own, and written as one table, CSV or Parquet.

use std::{
    collections::BTreeMap,
    fs, io,
    path::{Path, PathBuf},
    sync::Arc,
};

use forage::{Value, kernel::Error, message, run::Improvement};
use parquet::{
    basic::{LogicalType, Repetition, Type as Physical},
    data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type},
    errors::ParquetError,
    file::{properties::WriterProperties, writer::SerializedFileWriter, writer::SerializedRowGroupWriter},
    schema::types::{Type, TypePtr},
};
use serde::{Deserialize, Serialize};

use super::{
    super::{
        disk::Replacement,
        failure::{Failure, at},
        rows::{KeyedRow, Rows, repair},
        spreadsheet,
    },
    kept::Kept,
    plan::{Part, Sweep},
    text::{number_text, value_text},
};

/// What is in front of the parameters.
const LEAD: [&str; 3] = ["scene", "planner", "seed"];
/// What is behind them.
const POINT: [&str; 3] = ["iteration", "evaluations", "value"];
/// So many points are written at once.
const AT_ONCE: usize = 1 << 20;

/// How the table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Csv,
    Parquet,
}

/// A run's curve, as it is kept.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct KeptCurve {
    run: String,
    /// The run's hash: that of its row.
    hash: String,
    /// `iteration:evaluations:value`, with blanks between.
    points: String,
}

impl KeyedRow for KeptCurve {
    fn key(&self) -> String {
        self.run.clone()
    }
}

impl KeptCurve {
    fn points(&self) -> impl Iterator<Item = (u64, u64, f64)> {
        self.points.split(' ').filter_map(|point| {
            let mut parts = point.split(':');
            Some((parts.next()?.parse().ok()?, parts.next()?.parse().ok()?, parts.next()?.parse().ok()?))
        })
    }
}

/// The curves of a sweep's runs.
pub struct Curves {
    path: PathBuf,
    format: Format,
    part: Part,
    /// What is kept is thrown away when the first run begins.
    fresh: bool,
    rows: Rows<KeptCurve>,
    known: BTreeMap<String, KeptCurve>,
    notes: Vec<String>,
}

impl Curves {
    /// Opens what is kept of each run, from which the table is written in the end; `fresh`: throws that away. Of parts
    /// there is no table; the whole takes what is kept of all of them.
    ///
    /// # Errors
    /// A file that ends in something else than `.csv` or `.parquet`; as [`Rows::open`].
    pub fn open(path: &Path, part: Part, fresh: bool) -> Result<Self, Failure> {
        let format = match path.extension().and_then(|ending| ending.to_str()) {
            Some("csv") => Format::Csv,
            Some("parquet") => Format::Parquet,
            _ => {
                let allowed = message!("study-curves-ending", "a file that ends in .csv or .parquet");
                return Err(Error::refused("--curves", path.display().to_string(), allowed).into());
            }
        };
        let mut notes = Vec::new();
        // Lines that were changed are those of runs that are carried out again.
        let mut open = |path: &Path| {
            if !fresh {
                notes.extend(repair::<KeptCurve>(path)?.as_ref().map(ToString::to_string));
            }
            if fresh { Rows::<KeptCurve>::open_to_clear(path) } else { Rows::open(path, false) }
        };
        let mut rows = open(&kept_at(path, part))?;
        let mut known: BTreeMap<String, KeptCurve> = BTreeMap::new();
        if part == Part::WHOLE && !fresh {
            for part in parts(path)? {
                known.extend(open(&part)?.take().into_iter().map(|curve| (curve.key(), curve)));
            }
        }
        let own = rows.take();
        if !fresh {
            known.extend(own.into_iter().map(|curve| (curve.key(), curve)));
        }
        Ok(Self { path: path.to_owned(), format, part, fresh, rows, known, notes })
    }

    /// What should be known about the files.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Throws away what was kept, if that is wanted: nothing was refused.
    pub(super) fn begin(&mut self) -> Result<(), Failure> {
        if std::mem::take(&mut self.fresh) { self.rows.clear() } else { Ok(()) }
    }

    /// Where the table goes.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The runs of a part whose curve is not there, or is not that of their row.
    pub(super) fn missing(&self, kept: &Kept) -> Result<Vec<usize>, Failure> {
        let mut missing = Vec::new();
        for job in kept.jobs() {
            let known = self.known.get(&name(kept.sweep(), job));
            if known.map(|known| &known.hash) != Some(&kept.hash(job)?) {
                missing.push(job);
            }
        }
        Ok(missing)
    }

    /// Keeps a run's curve.
    pub(super) fn append(&mut self, sweep: &Sweep, job: usize, hash: &str, curve: &[Improvement]) -> Result<(), Failure> {
        let point = |point: &Improvement| format!("{}:{}:{}", point.iteration, point.evaluations, number_text(point.value));
        let points = curve.iter().map(point).collect::<Vec<_>>().join(" ");
        let curve = KeptCurve { run: name(sweep, job), hash: hash.to_owned(), points };
        self.rows.append(&curve)?;
        self.known.insert(curve.key(), curve);
        Ok(())
    }

    /// Writes the table of all runs, in their order; of a part nothing is left to write.
    pub(super) fn settle(&mut self, kept: &Kept) -> Result<(), Failure> {
        self.rows.sync()?;
        if self.part != Part::WHOLE {
            return Ok(());
        }
        let path = &self.path;
        let mut new = Replacement::of(path).map_err(at(path))?;
        let runs = kept.jobs().filter_map(|job| Some((job, self.known.get(&name(kept.sweep(), job))?)));
        match self.format {
            Format::Csv => write_csv(&mut new, kept.sweep(), runs).map_err(at(path))?,
            Format::Parquet => {
                let written = write_parquet(&mut new, kept.sweep(), runs);
                written.map_err(|problem| at(path)(io::Error::other(problem.to_string())))?;
            }
        }
        new.commit().map(drop).map_err(at(path))
    }
}

/// Behind the name of the table stands this in the name of what is kept of each run.
const KEPT: &str = ".runs.csv";

/// Where what is kept of each run is.
pub fn kept_at(path: &Path, part: Part) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    if part != Part::WHOLE {
        name.push(format!(".{}-of-{}", part.index, part.of));
    }
    name.push(KEPT);
    path.with_file_name(name)
}

/// What is kept of the runs of parts.
fn parts(path: &Path) -> Result<Vec<PathBuf>, Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let is_part = |found: &PathBuf| {
        let found = found.file_name().unwrap_or_default().to_string_lossy();
        found.strip_prefix(&name).and_then(|rest| rest.strip_suffix(KEPT)).is_some_and(|part| part.contains("-of-"))
    };
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>).map_err(at(folder))?;
    let mut all: Vec<PathBuf> = entries.iter().map(fs::DirEntry::path).filter(is_part).collect();
    all.sort();
    Ok(all)
}

/// What tells a run's curve from all others.
fn name(sweep: &Sweep, job: usize) -> String {
    let budget = sweep.allowance(job).map_or(String::new(), |budget| format!(", {budget} evaluations"));
    format!("{}{budget}", sweep.describe(job))
}

/// The columns' names. A parameter that is called as another column is `p.` and its name, as in rows.
fn columns(sweep: &Sweep) -> Vec<String> {
    let taken = |name: &str| LEAD.contains(&name) || POINT.contains(&name) || super::line::is_taken(name);
    let parameters = sweep.parameters.iter().map(|name| if taken(name) { format!("p.{name}") } else { name.clone() });
    LEAD.map(str::to_owned).into_iter().chain(parameters).chain(POINT.map(str::to_owned)).collect()
}

/// What is in front of each of a run's points.
fn lead(sweep: &Sweep, job: usize) -> Vec<String> {
    let setup = sweep.setup(job);
    let parameters = sweep.parameters.iter().map(|name| setup.params.get(name).map_or(String::new(), value_text));
    [setup.scene.name().to_owned(), setup.planner.clone(), setup.seed.to_string()].into_iter().chain(parameters).collect()
}

fn write_csv<'a>(new: &mut Replacement, sweep: &Sweep, runs: impl Iterator<Item = (usize, &'a KeptCurve)>) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(new);
    let failed = io::Error::from;
    writer.write_record(columns(sweep)).map_err(failed)?;
    for (job, curve) in runs {
        let lead = lead(sweep, job);
        for (iteration, evaluations, value) in curve.points() {
            let point = [iteration.to_string(), evaluations.to_string(), number_text(value)];
            writer.write_record(lead.iter().chain(&point).map(|text| spreadsheet::safe(text).into_owned())).map_err(failed)?;
        }
    }
    writer.flush()
}

/// What a column of the table holds; a parameter may be missing.
enum Column {
    Text(Vec<Option<ByteArray>>),
    Number(Vec<Option<f64>>),
    Whole(Vec<i64>),
}

impl Column {
    /// As of the first run that sets a parameter: all its values are of one kind.
    fn of_parameter(sweep: &Sweep, name: &str) -> Self {
        let mut values = (0..sweep.groups()).filter_map(|group| sweep.group(group).1.into_iter().find(|(known, _)| *known == name));
        match values.next() {
            Some((_, Value::Number(_))) => Self::Number(Vec::new()),
            _ => Self::Text(Vec::new()),
        }
    }

    fn physical(&self) -> Physical {
        match self {
            Self::Text(_) => Physical::BYTE_ARRAY,
            Self::Number(_) => Physical::DOUBLE,
            Self::Whole(_) => Physical::INT64,
        }
    }

    fn push(&mut self, value: Option<&Value>) {
        match self {
            Self::Text(texts) => texts.push(value.map(|value| ByteArray::from(value_text(value).as_str()))),
            Self::Number(numbers) => {
                numbers.push(value.and_then(number));
            }
            Self::Whole(_) => {}
        }
    }

    fn clear(&mut self) {
        match self {
            Self::Text(texts) => texts.clear(),
            Self::Number(numbers) => numbers.clear(),
            Self::Whole(numbers) => numbers.clear(),
        }
    }

    fn write<W: io::Write + Send>(&self, group: &mut SerializedRowGroupWriter<'_, W>) -> Result<(), ParquetError> {
        match self {
            Self::Text(texts) => write_column::<ByteArrayType, W>(group, texts),
            Self::Number(numbers) => write_column::<DoubleType, W>(group, numbers),
            Self::Whole(numbers) => write_column::<Int64Type, W>(group, &numbers.iter().copied().map(Some).collect::<Vec<_>>()),
        }
    }
}

fn number(value: &Value) -> Option<f64> {
    if let Value::Number(number) = value { Some(*number) } else { None }
}

fn write_column<T: DataType, W: io::Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[Option<T::T>],
) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
    let there: Vec<T::T> = values.iter().flatten().cloned().collect();
    column.typed::<T>().write_batch(&there, Some(&levels), None)?;
    column.close()
}

fn write_parquet<'a>(new: &mut Replacement, sweep: &Sweep, runs: impl Iterator<Item = (usize, &'a KeptCurve)>) -> Result<(), ParquetError> {
    let whole = || Column::Whole(Vec::new());
    let texts = || Column::Text(Vec::new());
    let parameters = sweep.parameters.iter().map(|name| Column::of_parameter(sweep, name));
    let mut table: Vec<Column> = [texts(), texts(), whole()].into_iter().chain(parameters).collect();
    table.extend([whole(), whole(), Column::Number(Vec::new())]);
    let mut fields: Vec<TypePtr> = Vec::with_capacity(table.len());
    for (name, column) in columns(sweep).iter().zip(&table) {
        let logical = matches!(column, Column::Text(_)).then_some(LogicalType::String);
        let field = Type::primitive_type_builder(name, column.physical()).with_repetition(Repetition::OPTIONAL).with_logical_type(logical);
        fields.push(Arc::new(field.build()?));
    }
    let schema = Arc::new(Type::group_type_builder("curves").with_fields(fields).build()?);
    let properties = Arc::new(WriterProperties::builder().set_created_by("forage".to_owned()).build());
    let mut writer = SerializedFileWriter::new(new, schema, properties)?;
    let mut count = 0;
    for (job, curve) in runs {
        let setup = sweep.setup(job);
        let last = table.len() - POINT.len();
        for (iteration, evaluations, value) in curve.points() {
            for (at, column) in table.iter_mut().enumerate() {
                match (at, column) {
                    (0, column) => column.push(Some(&Value::Text(setup.scene.name().to_owned()))),
                    (1, column) => column.push(Some(&Value::Text(setup.planner.clone()))),
                    (2, Column::Whole(seeds)) => seeds.push(setup.seed as i64),
                    (at, Column::Whole(numbers)) => numbers.push(if at == last { iteration } else { evaluations } as i64),
                    (at, Column::Number(numbers)) if at == last + 2 => numbers.push(Some(value)),
                    (at, column) => column.push(setup.params.get(&sweep.parameters[at - LEAD.len()])),
                }
            }
            count += 1;
        }
        if count >= AT_ONCE {
            flush(&mut writer, &mut table)?;
            count = 0;
        }
    }
    flush(&mut writer, &mut table)?;
    writer.close()?;
    Ok(())
}

fn flush<W: io::Write + Send>(writer: &mut SerializedFileWriter<W>, table: &mut [Column]) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    table.iter().try_for_each(|column| column.write(&mut group))?;
    group.close()?;
    table.iter_mut().for_each(Column::clear);
    Ok(())
}
