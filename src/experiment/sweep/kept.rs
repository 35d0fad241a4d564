//! The file of a sweep's rows: where each one stands, and what the statistics need of it; the rows themselves stay on the disk.
//!
//! Rows are appended as runs finish, each in one write, so that whatever kills the program leaves whole lines and at most a
//! torn one at the end, which is dropped at the next start. When all are there the file is put in the order of the runs, in a
//! new one beside it that takes its place at once. Nobody else can write meanwhile: the file is locked.

use std::{
    ffi::OsString,
    fs::{self, File, OpenOptions, TryLockError},
    io::{self, BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write},
    path::{Path, PathBuf},
};

use crate::{error::Error, trial::Record};

use super::{
    super::{Failure, at},
    line::{Format, Told},
    plan::{Part, Sweep},
};

/// Where a row stands.
#[derive(Debug, Clone, Copy)]
struct Where {
    offset: u64,
    /// 0: there is none.
    length: u32,
    /// Which of the files.
    file: u32,
}

const NOWHERE: Where = Where { offset: 0, length: 0, file: 0 };

/// The rows of a sweep, or of a part of it.
#[derive(Debug)]
pub struct Kept<'a> {
    sweep: &'a Sweep,
    part: Part,
    format: Format,
    /// Where the rows go; first the file itself, then those whose rows are merged into it.
    files: Vec<(PathBuf, File)>,
    /// Where the file ends.
    end: u64,
    rows: Vec<Where>,
    told: Vec<Told>,
    count: usize,
}

impl<'a> Kept<'a> {
    /// Opens the file, made if need be, and looks through what is there; `fresh`: throws it away, whatever it is.
    ///
    /// # Errors
    /// A file that cannot be read or written, that another program is writing, or that belongs to something else.
    pub fn open(sweep: &'a Sweep, part: Part, path: &Path, fresh: bool) -> Result<Self, Failure> {
        let format = Format::of(path)?;
        if part.of > sweep.len() {
            return Err(Error::refused("--shard", part, format!("one of at most {} parts, as many as there are runs", sweep.len())).into());
        }
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(at(folder))?;
        }
        let file = OpenOptions::new().read(true).append(true).create(true).open(path).map_err(at(path))?;
        // Where files cannot be locked at all, nothing is lost but the warning.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(Error::refused("out", path.display(), "a file that no other `forage` is writing").into());
        }
        if fresh {
            file.set_len(0).map_err(at(path))?;
        }
        let all = part.len(sweep.len());
        let (rows, told) = (vec![NOWHERE; all], vec![Told::default(); all]);
        let mut kept = Self { sweep, part, format, files: vec![(path.to_owned(), file)], end: 0, rows, told, count: 0 };
        kept.end = kept.look_through(0)?;
        let file = &mut kept.files[0].1;
        file.set_len(kept.end).map_err(at(path))?;
        if kept.end == 0 {
            let heading = format.heading(sweep).map_err(at(path))?;
            file.write_all(&heading).map_err(at(path))?;
            kept.end = heading.len() as u64;
        }
        Ok(kept)
    }

    /// Takes the rows of parts, and makes one file of all. What is there already counts, too.
    ///
    /// # Errors
    /// A file that cannot be read, that somebody is still writing, or that belongs to something else; runs that are missing.
    pub fn merge(&mut self, parts: &[PathBuf]) -> Result<(), Failure> {
        let merged = parts.iter().try_for_each(|path| self.add(path)).and_then(|()| Ok(self.check_complete()?));
        if merged.is_err() && self.rows.iter().all(|row| row.length == 0 || row.file > 0) {
            // There was nothing in it before.
            fs::remove_file(self.path()).map_err(at(self.path()))?;
        }
        merged?;
        self.settle()
    }

    /// Takes the rows of another file, too.
    fn add(&mut self, path: &Path) -> Result<(), Failure> {
        if fs::canonicalize(path).ok() == fs::canonicalize(self.path()).ok() {
            return Ok(());
        }
        if Format::of(path)? != self.format {
            let allowed = format!("a file with the ending of {}", self.files[0].0.display());
            return Err(Error::refused("--merge", path.display(), allowed).into());
        }
        let file = File::open(path).map_err(at(path))?;
        if let Err(TryLockError::WouldBlock) = file.try_lock_shared() {
            return Err(Error::refused("--merge", path.display(), "a file that no `forage` is writing").into());
        }
        self.files.push((path.to_owned(), file));
        self.look_through(self.files.len() - 1).map(|_| ())
    }

    /// Finds the rows of a file, and says where its last whole line ends.
    fn look_through(&mut self, number: usize) -> Result<u64, Failure> {
        let (path, file) = &self.files[number];
        let path = path.clone();
        let other = |problem: String| {
            let advice = "it belongs to another experiment; --out writes elsewhere, --fresh begins anew";
            Failure::from(Error::malformed(&path.display().to_string(), format!("{problem}: {advice}")))
        };
        let mut reader = BufReader::with_capacity(1 << 16, file.try_clone().map_err(at(&path))?);
        reader.rewind().map_err(at(&path))?;
        let heading = self.format.heading(self.sweep).map_err(at(&path))?;
        let beginning = self.format.beginning(self.sweep).map_err(at(&path))?;
        let (mut line, mut end, mut count) = (Vec::new(), 0_u64, 0);
        loop {
            line.clear();
            let length = reader.read_until(b'\n', &mut line).map_err(at(&path))?;
            count += 1;
            if !line.ends_with(b"\n") {
                // What was torn in the middle is ours if it begins like ours.
                let ours = end > 0 || line.starts_with(&beginning) || beginning.starts_with(&line);
                return if ours { Ok(end) } else { Err(other("it does not begin like a file of rows".to_owned())) };
            }
            if end == 0 && !heading.is_empty() {
                if line != heading {
                    let columns = String::from_utf8_lossy(&heading);
                    return Err(other(format!("its first line is not {}", columns.trim_end())));
                }
            } else {
                let (job, told) = self.format.read(self.sweep, &line).map_err(|problem| other(format!("line {count}: {problem}")))?;
                let slot = self
                    .part
                    .find(job)
                    .ok_or_else(|| other(format!("line {count}: the run of {} is not in part {}", self.sweep.describe(job), self.part)))?;
                let here = Where { offset: end, length: length as u32, file: number as u32 };
                if self.rows[slot].length == 0 {
                    self.hold(slot, here, told);
                } else if self.bytes(self.rows[slot])? != line {
                    let problem = format!("line {count}: the run of {} came out otherwise before", self.sweep.describe(job));
                    return Err(Error::malformed(&path.display().to_string(), problem).into());
                }
            }
            end += length as u64;
        }
    }

    fn hold(&mut self, slot: usize, here: Where, told: Told) {
        self.rows[slot] = here;
        self.told[slot] = told;
        self.count += 1;
    }

    fn bytes(&self, row: Where) -> Result<Vec<u8>, Failure> {
        let (path, file) = &self.files[row.file as usize];
        let mut bytes = vec![0; row.length as usize];
        let mut file = file;
        file.seek(SeekFrom::Start(row.offset)).and_then(|_| file.read_exact(&mut bytes)).map_err(at(path))?;
        Ok(bytes)
    }

    /// Where the rows go.
    pub fn path(&self) -> &Path {
        &self.files[0].0
    }

    /// What is run.
    pub fn sweep(&self) -> &'a Sweep {
        self.sweep
    }

    /// Which part of the sweep this is.
    pub fn part(&self) -> Part {
        self.part
    }

    /// How many runs are kept, and how many there are.
    pub fn counts(&self) -> (usize, usize) {
        (self.count, self.rows.len())
    }

    /// The runs whose rows are there.
    pub fn jobs(&self) -> impl Iterator<Item = usize> {
        self.slots(true)
    }

    /// The runs whose rows are not.
    pub fn missing(&self) -> impl Iterator<Item = usize> {
        self.slots(false)
    }

    fn slots(&self, there: bool) -> impl Iterator<Item = usize> {
        self.rows.iter().enumerate().filter(move |(_, row)| (row.length > 0) == there).map(|(slot, _)| self.part.job(slot))
    }

    /// What came of a run, if its row is there.
    pub(super) fn told(&self, job: usize) -> Option<Told> {
        let slot = self.part.find(job)?;
        (self.rows[slot].length > 0).then(|| self.told[slot])
    }

    /// That it was stopped before all were there; `None` if all are.
    pub(super) fn unfinished(&self) -> Option<Failure> {
        let (done, total) = self.counts();
        (done < total).then(|| Failure::Interrupted { done, total, rows: self.path().to_owned() })
    }

    /// Refuses a row that the run does not give now.
    pub(super) fn compare(&self, job: usize, again: &Record) -> Result<(), Failure> {
        let Some(slot) = self.part.find(job) else { return Ok(()) };
        let line = self.format.line(self.sweep, job, again).map_err(at(self.path()))?;
        if self.bytes(self.rows[slot])? == line {
            return Ok(());
        }
        let problem = format!(
            "the run of {} now gives another row: another version of forage, another scene or another `within`; --fresh begins anew",
            self.sweep.describe(job)
        );
        Err(Error::malformed(&self.path().display().to_string(), problem).into())
    }

    /// Adds a row, in one write, so that it is there whatever happens next.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn append(&mut self, job: usize, record: &Record) -> Result<(), Failure> {
        let Some(slot) = self.part.find(job) else { return Ok(()) };
        let (path, file) = &mut self.files[0];
        let line = self.format.line(self.sweep, job, record).map_err(at(path))?;
        file.write_all(&line).and_then(|()| file.flush()).map_err(at(path))?;
        self.hold(slot, Where { offset: self.end, length: line.len() as u32, file: 0 }, record.into());
        self.end += line.len() as u64;
        Ok(())
    }

    /// Says how many runs are missing, and which is the first.
    fn check_complete(&self) -> Result<(), Error> {
        let Some(first) = self.missing().next() else { return Ok(()) };
        let (done, total) = self.counts();
        let found = format!("parts with {done} of {total} runs");
        let allowed = format!("all parts, complete: {} are missing, the first is that of {}", total - done, self.sweep.describe(first));
        Err(Error::refused("--merge", found, allowed))
    }

    /// Puts the file in the order of the runs, in one go: until then the old one stays.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn settle(&mut self) -> Result<(), Failure> {
        let mut next = self.format.heading(self.sweep).map_err(at(self.path()))?.len() as u64;
        let in_order = self.rows.iter().all(|row| {
            let here = row.file == 0 && row.offset == next;
            next += u64::from(row.length);
            here
        });
        if in_order && next == self.end {
            return Ok(());
        }
        let mut name = OsString::from(self.path());
        name.push(".new");
        let beside = PathBuf::from(name);
        self.write_ordered(&beside)?;
        fs::rename(&beside, self.path()).map_err(at(self.path()))
    }

    fn write_ordered(&self, beside: &Path) -> Result<(), Failure> {
        let wrong = |error: io::Error| Failure::File(beside.to_owned(), error);
        let mut out = BufWriter::with_capacity(1 << 16, File::create(beside).map_err(wrong)?);
        out.write_all(&self.format.heading(self.sweep).map_err(wrong)?).map_err(wrong)?;
        for &row in &self.rows {
            out.write_all(&self.bytes(row)?).map_err(wrong)?;
        }
        let file = out.into_inner().map_err(|error| wrong(error.into_error()))?;
        file.sync_all().map_err(wrong)
    }
}
