//! The file that an experiment's rows are kept in: CSV, one line a finished job, written at once.
//!
//! Whatever kills the program leaves whole lines and at most one torn one at the end, which is dropped at the next
//! start. Nobody else can write meanwhile: the file is locked.

use std::{
    fs::File,
    io::{self, BufRead, BufReader, Read, Seek, Write},
    path::{Path, PathBuf},
};

use csv::StringRecord;
use serde::{Serialize, de::DeserializeOwned};

use forage::{
    kernel::{Error, Message},
    message,
};

use super::{
    digest,
    disk::{self, Out},
    failure::{Failure, at},
    files::{damaged, locked},
    spreadsheet,
};

/// The largest file of rows: it is read as a whole.
const LARGEST: u64 = 1 << 30;
/// More than this the names of columns do not take.
const LONGEST_HEADING: u64 = 1 << 16;

/// What a job finds out. Its fields become columns, in their order.
pub trait KeyedRow: Clone + PartialEq + Serialize + DeserializeOwned + Send + Sync {
    /// What tells it from all other rows of the file; the key of the job that made it.
    fn key(&self) -> String;
    /// The row without what is measured, such as times: what the job gives whenever it is run.
    #[must_use]
    fn computed(&self) -> Self {
        self.clone()
    }
}

/// A file of rows, open for more.
#[derive(Debug)]
pub struct Rows<R> {
    path: PathBuf,
    file: Out,
    /// Whether the line with the columns' names is there.
    headed: bool,
    /// The rows that were there when it was opened.
    kept: Vec<R>,
}

impl<R: KeyedRow> Rows<R> {
    /// Opens the file, made if need be, and reads what is there; `fresh`: throws it away.
    ///
    /// # Errors
    /// A file that cannot be read or written, that another program is writing, or whose rows are not of this kind.
    pub fn open(path: &Path, fresh: bool) -> Result<Self, Failure> {
        if let Some(folder) = path.parent() {
            disk::make_folder(folder).map_err(at(folder))?;
        }
        let mut file = Out::append(path).map_err(at(path))?;
        // Where files cannot be locked at all, nothing is lost but the warning.
        locked(file.file().try_lock(), path)?;
        refuse_others(path, file.file())?;
        if fresh {
            file.set_len(0).map_err(at(path))?;
        }
        let size = file.file().metadata().map_err(at(path))?.len();
        if size > LARGEST {
            let [found, most] = [size, LARGEST].map(|bytes| bytes as f64 / f64::from(1 << 30));
            let problem = message!(
                "study-rows-too-large",
                "it has {found:.1} GiB; a file of rows may have at most {most} GiB; --fresh starts over",
                found,
                most
            );
            return Err(Error::malformed(&path.display().to_string(), problem).into());
        }
        let mut bytes = Vec::new();
        file.file().take(LARGEST).read_to_end(&mut bytes).map_err(at(path))?;
        let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |last| last + 1);
        let kept = read(&bytes[..whole]).collect::<Result<Vec<R>, _>>().map_err(|problem| {
            Error::malformed(&path.display().to_string(), message!("study-fresh", "{problem}; --fresh starts over", problem))
        })?;
        if whole < bytes.len() {
            file.set_len(whole as u64).map_err(at(path))?;
        }
        Ok(Self { path: path.to_owned(), file, headed: whole > 0, kept })
    }

    /// Opens the file to throw away what is there, with [`Self::clear`]; it is not read.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_to_clear(path: &Path) -> Result<Self, Failure> {
        if let Some(folder) = path.parent() {
            disk::make_folder(folder).map_err(at(folder))?;
        }
        let file = Out::append(path).map_err(at(path))?;
        locked(file.file().try_lock(), path)?;
        refuse_others(path, file.file())?;
        Ok(Self { path: path.to_owned(), file, headed: true, kept: Vec::new() })
    }

    /// Puts all rows on the disk.
    ///
    /// # Errors
    /// As the system says.
    pub fn sync(&mut self) -> Result<(), Failure> {
        self.file.sync().map_err(at(&self.path))
    }

    /// Throws away all rows.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn clear(&mut self) -> Result<(), Failure> {
        self.headed = false;
        self.file.set_len(0).map_err(at(&self.path))
    }

    /// Takes the rows that were there.
    pub fn take(&mut self) -> Vec<R> {
        std::mem::take(&mut self.kept)
    }

    /// Adds a row, in one write, so that it is there whatever happens next.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn append(&mut self, row: &R) -> Result<(), Failure> {
        let line = lines([row], !self.headed).map_err(at(&self.path))?;
        self.headed = true;
        self.file.write_all(&line).and_then(|()| self.file.flush()).map_err(at(&self.path))
    }

    /// Replaces the file by these rows in this order, in one go: until then the old one stays.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn settle<'a>(self, rows: impl IntoIterator<Item = &'a R>) -> Result<(), Failure>
    where
        R: 'a,
    {
        lines(rows, true).and_then(|text| disk::write(&self.path, text)).map_err(at(&self.path))
    }
}

/// Refuses a file that does not begin as files of rows do, with names of columns; what a loss of power leaves may.
fn refuse_others(path: &Path, mut file: &File) -> Result<(), Failure> {
    let mut line = Vec::new();
    file.rewind().map_err(at(path))?;
    BufReader::new(file.take(LONGEST_HEADING)).read_until(b'\n', &mut line).map_err(at(path))?;
    file.rewind().map_err(at(path))?;
    let names = line.strip_suffix(b"\n").unwrap_or(&line).split(|&byte| byte == 0).next().unwrap_or_default();
    let is_name = |byte: &u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || *byte == b'_' || *byte == b',';
    let is_ours = names.iter().all(is_name)
        && (!line.ends_with(b"\n") || names.contains(&b','))
        && (!names.is_empty() || line.iter().all(|&byte| byte == 0));
    if is_ours {
        return Ok(());
    }
    let problem = message!("study-no-file-of-rows", "it does not begin like a file of rows");
    Err(Error::malformed(&path.display().to_string(), message!("study-elsewhere", "{problem}; choose another --out", problem)).into())
}

/// Takes damaged lines out of a file of rows, so that their runs are repeated; the file as it was is kept under the name that
/// [`damaged`] gives. Returns what was done. Nothing is done where no line can be read: that is no such file.
///
/// # Errors
/// A file that cannot be read or written, or that another program is writing.
pub fn repair<R: KeyedRow>(path: &Path) -> Result<Option<Message>, Failure> {
    let Ok(mut file) = File::open(path) else { return Ok(None) };
    locked(file.try_lock(), path)?;
    // What is too large is refused as a whole.
    if file.metadata().map_err(at(path))?.len() > LARGEST {
        return Ok(None);
    }
    let mut bytes = Vec::new();
    Read::by_ref(&mut file).take(LARGEST).read_to_end(&mut bytes).map_err(at(path))?;
    let mut lines_read = 0;
    let mut rows: Vec<R> = Vec::new();
    // A torn last line is dropped when the file is opened.
    let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |last| last + 1);
    for row in read(&bytes[..whole]) {
        lines_read += 1;
        rows.extend(row.ok());
    }
    if rows.is_empty() || rows.len() == lines_read {
        return Ok(None);
    }
    let bad = damaged(path);
    disk::write(&bad, &bytes).map_err(at(&bad))?;
    lines(&rows, true).and_then(|text| disk::write(path, text)).map_err(at(path))?;
    let [path, bad] = [path, &bad].map(|path| path.display().to_string());
    let lines = lines_read - rows.len();
    Ok(Some(message!(
        "study-damaged-lines",
        "damaged lines in {path}: {lines}; their runs are repeated, and the file as it was is {bad}",
        path,
        lines,
        bad
    )))
}

/// What a row says, as a line: that of the file without its digest.
///
/// # Errors
/// None that is known: it is written to memory.
pub fn line<R: KeyedRow>(row: &R) -> Result<Vec<u8>, io::Error> {
    serialized([row], false)
}

/// Rows as CSV, with their columns' names above them if they are `headed`.
fn serialized<'a, R: KeyedRow + 'a>(rows: impl IntoIterator<Item = &'a R>, headed: bool) -> Result<Vec<u8>, io::Error> {
    let mut writer = csv::WriterBuilder::new().has_headers(headed).from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}

/// The column of the rows' digests, the last one.
const DIGEST: &str = "digest";

fn lines<'a, R: KeyedRow + 'a>(rows: impl IntoIterator<Item = &'a R>, headed: bool) -> Result<Vec<u8>, io::Error> {
    let plain = serialized(rows, true)?;
    let mut writer = csv::Writer::from_writer(Vec::with_capacity(2 * plain.len()));
    let mut reader = csv::Reader::from_reader(&*plain);
    let names = reader.headers()?.clone();
    if headed {
        writer.write_record(names.iter().chain([DIGEST]))?;
    }
    for cells in reader.records() {
        let mut cells: StringRecord = cells?.iter().map(spreadsheet::safe).collect();
        let digest = digest::of_cells(&names, &cells);
        cells.push_field(&digest);
        writer.write_record(&cells)?;
    }
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}

/// The rows of a file, whose first line has their names; or what is wrong with them.
fn read<R: KeyedRow>(text: &[u8]) -> impl Iterator<Item = Result<R, Message>> {
    let mut reader = csv::Reader::from_reader(text);
    let columns = reader.headers().map(|columns| columns.iter().map(str::to_owned).collect::<Vec<_>>());
    // The digests' own column is none of a row's.
    let names = columns.map_err(|problem| problem.to_string()).map(|mut columns| {
        let last = columns.pop();
        (last.as_deref() == Some(DIGEST)).then(|| columns.into_iter().collect::<StringRecord>())
    });
    reader.into_records().zip(2_u64..).map(move |(record, number)| {
        let said = |problem: Message| message!("study-in-line", "line {count}: {problem}", count = number, problem);
        let unreadable = |problem: csv::Error| Message::verbatim(problem.to_string());
        let names = names.as_ref().map_err(|problem| Message::verbatim(problem.as_str()))?.as_ref().ok_or_else(digest::missing)?;
        let record = record.map_err(unreadable)?;
        let cells: Vec<&str> = record.iter().take(names.len()).collect();
        if record.iter().nth(names.len()) != Some(&*digest::of_cells(names, cells.iter().copied())) {
            return Err(said(digest::differs()));
        }
        let plain: StringRecord = cells.into_iter().map(spreadsheet::plain).collect();
        plain.deserialize(Some(names)).map_err(unreadable)
    })
}
