//! The file of a sweep's rows: where each one stands, and what the statistics need of it; the rows themselves stay on the disk.
//!
//! Rows are appended as runs finish, each in one write, so that whatever kills the program leaves whole lines and at most a
//! torn one at the end, which is dropped at the next start. Damaged lines are taken out then, and their runs are carried out again.
//! When all are there the file is put in the order of the runs, in a new one beside it that takes its place at once. Nobody else can write meanwhile: the file is locked.

#[cfg(test)]
mod changed;
#[cfg(test)]
mod faulty;
mod handle;
mod scan;

use std::{
    fs::File,
    io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write},
    mem::size_of,
    path::{Path, PathBuf},
};

use forage::{
    kernel::{Error, Message, ReferenceOptimum},
    message,
    run::trial::Record,
};

use self::handle::Handle;
use super::{
    super::{
        disk::{self, Out, Replacement},
        failure::{Failure, at},
        files::{damaged, is_same, locked, place},
    },
    line::{Format, RunStatistics},
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

/// So many rows are put in order at a time, each of the files opened once for them.
const BLOCK: usize = 1 << 16;

/// The longest line in bytes, far more than a row has: so much of a file without line breaks is in memory.
const LONGEST_LINE: u64 = 1 << 20;

/// So many bytes of memory each run takes: where its row stands, and what the statistics need of it.
pub const BYTES_PER_RUN: usize = size_of::<Where>() + size_of::<Compact>();

/// The rows of a sweep, or of a part of it.
#[derive(Debug)]
pub struct Kept<'a> {
    sweep: &'a Sweep,
    part: Part,
    format: Format,
    /// Where the rows go; first the file itself, then those whose rows are merged into it.
    files: Vec<PathBuf>,
    /// The first of them. The others are opened when they are read: there may be more than can be open at once.
    file: Handle,
    /// Where what is ours ends in the file.
    end: u64,
    rows: Vec<Where>,
    statistics: Vec<Compact>,
    count: usize,
    /// Whether lines of the file were left out.
    damaged: bool,
    notes: Vec<String>,
}

impl<'a> Kept<'a> {
    /// Opens the file, made if need be, and looks through what is there; `fresh`: does without that. What is there stays as it
    /// is until [`Self::begin`].
    ///
    /// # Errors
    /// A file that cannot be read or written, that another program is writing, or that belongs to something else.
    pub fn open(sweep: &'a Sweep, part: Part, path: &Path, fresh: bool) -> Result<Self, Failure> {
        let format = Format::of("--out", path)?;
        if part.of > sweep.len() {
            return Err(Error::refused(
                "--shard",
                part.to_string(),
                message!("study-most-parts", "one of at most {runs} parts, as many as there are runs", runs = sweep.len()),
            )
            .into());
        }
        if let Some(folder) = path.parent() {
            disk::make_folder(folder).map_err(at(folder))?;
        }
        let (file, note) = Handle::open_locked(path)?;
        let notes = note.iter().map(ToString::to_string).collect();
        let all = part.len(sweep.len());
        let (rows, statistics) = (vec![NOWHERE; all], vec![Compact::default(); all]);
        let files = vec![path.to_owned()];
        let mut kept = Self { sweep, part, format, files, file, end: 0, rows, statistics, count: 0, damaged: false, notes };
        if !fresh {
            kept.end = kept.look_through(0)?;
        } else if !kept.begins_like_rows(kept.file.file())? {
            let allowed = message!("study-file-of-rows", "a file of rows: it does not begin like one, and stays as it is");
            return Err(Error::refused("--fresh", path.display().to_string(), allowed).into());
        }
        Ok(kept)
    }

    fn begins_like_rows(&self, mut file: &File) -> Result<bool, Failure> {
        let mut line = Vec::new();
        file.rewind().map_err(at(self.path()))?;
        BufReader::new(file.take(LONGEST_LINE)).read_until(b'\n', &mut line).map_err(at(self.path()))?;
        Ok(self.format.begins(&line))
    }

    /// Makes the file ready for rows: what is not ours in it goes. Nothing is written where nothing is to be done.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn begin(&mut self) -> Result<(), Failure> {
        let path = self.files[0].clone();
        if self.damaged {
            let bad = damaged(&path);
            let mut copy = Out::create_new(&bad).map_err(at(&bad))?;
            let mut file = self.file.file();
            file.rewind().and_then(|()| io::copy(&mut file, &mut copy)).and_then(|_| copy.sync()).map_err(at(&bad))?;
            let (file, bad) = (path.display().to_string(), bad.display().to_string());
            self.notes.push(message!("study-kept-as", "{file}: as it was it is kept as {bad}", file, bad).to_string());
            self.rewrite(0)?;
            self.damaged = false;
        }
        if self.end == 0 {
            let heading = self.format.heading(self.sweep).map_err(at(&path))?;
            let out = self.file.out().map_err(at(&path))?;
            // Without its heading nobody would know a file by what a loss of power leaves.
            out.set_len(0).and_then(|()| out.write_all(&heading)).and_then(|()| out.sync()).map_err(at(&path))?;
            self.end = heading.len() as u64;
        } else if self.file.file().metadata().map_err(at(&path))?.len() > self.end {
            // A torn line.
            let end = self.end;
            self.file.out().and_then(|out| out.set_len(end)).map_err(at(&path))?;
        }
        Ok(())
    }

    /// Takes the rows of parts. What is there already counts, too.
    ///
    /// # Errors
    /// A file that cannot be read, that somebody is still writing, or that belongs to something else; runs that are missing.
    pub fn gather(&mut self, parts: &[PathBuf]) -> Result<(), Failure> {
        parts.iter().try_for_each(|path| self.add(path))?;
        Ok(self.check_complete()?)
    }

    /// Removes a file with nothing in it.
    pub(super) fn leave(&self) {
        let is_new = matches!(&self.file, Handle::Writable(out) if out.is_new());
        if is_new && self.file.file().metadata().is_ok_and(|file| file.len() == 0) {
            // It says nothing, and so it does no harm if it stays.
            let _ = place(self.path()).map(|path| disk::remove(&path));
        }
    }

    /// What should be known about the files.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Says which run is missing among those that are kept.
    pub(super) fn say_missing(&mut self) {
        let (done, total) = self.counts();
        let first = self.missing().next().filter(|_| done > 0);
        if let Some(first) = first {
            let (file, run) = (self.path().display().to_string(), self.sweep.describe(first));
            self.note(&message!(
                "study-some-missing",
                "{file}: {done} of {total} rows were there; the first that was missing is that of {run}",
                file,
                done,
                total,
                run
            ));
        }
    }

    /// Says something of the files.
    pub(super) fn note(&mut self, note: &Message) {
        self.notes.push(note.to_string());
    }

    /// Takes the rows of another file, too.
    fn add(&mut self, path: &Path) -> Result<(), Failure> {
        if is_same(path, self.path()) {
            return Ok(());
        }
        if Format::of("--merge", path)? != self.format {
            let file = self.path().display().to_string();
            let allowed = message!("study-same-ending", "a file with the ending of {file}", file);
            return Err(Error::refused("--merge", path.display().to_string(), allowed).into());
        }
        self.files.push(path.to_owned());
        self.look_through(self.files.len() - 1).map(|_| ())
    }

    /// Looks through the file again, in which somebody else wrote.
    fn look_again(&mut self) -> Result<(), Failure> {
        for row in self.rows.iter_mut().filter(|row| row.file == 0) {
            *row = NOWHERE;
        }
        self.count = self.rows.iter().filter(|row| row.length > 0).count();
        self.end = self.look_through(0)?;
        if self.count < self.rows.len() {
            return Err(self.disturbed());
        }
        let file = self.path().display().to_string();
        let note = message!("study-looked-again", "{file}: another program wrote in it; what it wrote was looked through, too", file);
        self.notes.push(note.to_string());
        Ok(())
    }

    fn disturbed(&self) -> Failure {
        at(self.path())(io::Error::other(
            message!("study-disturbed", "another program wrote over rows in it; when that has ended the same command goes on").to_string(),
        ))
    }

    fn hold(&mut self, slot: usize, here: Where, statistics: RunStatistics) {
        self.rows[slot] = here;
        self.statistics[slot] = statistics.into();
        self.count += 1;
    }

    fn bytes(&self, row: Where) -> Result<Vec<u8>, Failure> {
        let mut bytes = vec![0; row.length as usize];
        if row.file == 0 {
            read_at(self.file.file(), row.offset, &mut bytes).map_err(at(self.path()))?;
        } else {
            let path = &self.files[row.file as usize];
            File::open(path).and_then(|file| read_at(&file, row.offset, &mut bytes)).map_err(at(path))?;
        }
        Ok(bytes)
    }

    /// The hash in a run's row.
    pub(super) fn hash(&self, job: usize) -> Result<String, Failure> {
        let Some(row) = self.part.find(job).map(|slot| self.rows[slot]).filter(|row| row.length > 0) else { return Ok(String::new()) };
        Ok(self.format.hash_of(&self.bytes(row)?).unwrap_or_default())
    }

    /// Where the rows go.
    pub fn path(&self) -> &Path {
        &self.files[0]
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
    pub(super) fn statistics_of(&self, job: usize) -> Option<RunStatistics> {
        let slot = self.part.find(job)?;
        (self.rows[slot].length > 0).then(|| self.statistics[slot].into())
    }

    /// That not all was carried out.
    pub(super) fn interrupted(&self) -> Failure {
        let (done, total) = self.counts();
        Failure::Interrupted { done, total, rows: self.path().to_owned() }
    }

    /// Whether a run's row is there.
    pub(super) fn has(&self, job: usize) -> bool {
        self.part.find(job).is_some_and(|slot| self.rows[slot].length > 0)
    }

    /// Refuses a row that the run does not give now.
    pub(super) fn compare(&self, job: usize, again: &Record) -> Result<(), Failure> {
        let Some(slot) = self.part.find(job) else { return Ok(()) };
        let line = self.format.line(self.sweep, job, again).map_err(at(self.path()))?;
        if self.bytes(self.rows[slot])? == line {
            return Ok(());
        }
        let problem = message!(
            "study-another-row",
            "the run of {run} now gives another row: it was made up, or this machine computes otherwise; --fresh starts over",
            run = self.sweep.describe(job)
        );
        let file = &self.files[self.rows[slot].file as usize];
        Err(Error::malformed(&file.display().to_string(), problem).into())
    }

    /// Adds a row, in one write, so that it is there whatever happens next.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn append(&mut self, job: usize, record: &Record) -> Result<(), Failure> {
        let Some(slot) = self.part.find(job) else { return Ok(()) };
        let path = &self.files[0];
        let line = self.format.line(self.sweep, job, record).map_err(at(path))?;
        let out = self.file.out().map_err(at(path))?;
        out.write_all(&line).and_then(|()| out.flush()).map_err(at(path))?;
        self.hold(slot, Where { offset: self.end, length: line.len() as u32, file: 0 }, record.into());
        self.end += line.len() as u64;
        Ok(())
    }

    /// Says how many runs are missing, and which is the first.
    fn check_complete(&self) -> Result<(), Error> {
        let Some(first) = self.missing().next() else { return Ok(()) };
        let (done, total) = self.counts();
        let found = message!("study-parts-with", "parts with {done} of {total} runs", done, total);
        let allowed = message!(
            "study-all-parts",
            "all parts, complete: {missing} are missing, the first is that of {run}",
            missing = total - done,
            run = self.sweep.describe(first)
        );
        Err(Error::refused("--merge", found, allowed))
    }

    /// Puts the file in the order of the runs, in one go: until then the old one stays. All of it is on the disk then.
    ///
    /// # Errors
    /// A disk that is full, and the like; a file in which somebody else writes.
    pub fn settle(&mut self) -> Result<(), Failure> {
        if self.file.file().metadata().map_err(at(self.path()))?.len() != self.end {
            self.look_again()?;
        }
        let first = self.format.heading(self.sweep).map_err(at(self.path()))?.len() as u64;
        if !self.is_in_order(first) {
            self.rewrite(self.rows.len())
        } else if let Handle::Writable(out) = &mut self.file {
            out.sync().map_err(at(&self.files[0]))
        } else {
            Ok(())
        }
    }

    /// Whether all rows stand in the file in their order, and nothing else does.
    fn is_in_order(&self, first: u64) -> bool {
        let mut next = first;
        let in_order = self.rows.iter().all(|row| {
            let here = row.file == 0 && row.offset == next;
            next += u64::from(row.length);
            here
        });
        in_order && next == self.end
    }

    /// Replaces the file by its rows in their order, at least so many.
    fn rewrite(&mut self, least: usize) -> Result<(), Failure> {
        let path = self.files[0].clone();
        self.file.out().map_err(at(&path))?;
        let mut new = Replacement::of(&path).map_err(at(&path))?;
        // Another process that waits for the file finds the new one locked, too.
        locked(new.file().map_err(at(&path))?.try_lock(), new.beside())?;
        let (rows, end) = self.write_ordered(&mut new, least)?;
        self.file = Handle::Writable(new.commit().map_err(at(&path))?);
        (self.rows, self.end) = (rows, end);
        self.files.truncate(1);
        Ok(())
    }

    /// Writes the rows in their order; returns where they stand, and where the last one ends.
    fn write_ordered(&self, out: &mut Replacement, least: usize) -> Result<(Vec<Where>, u64), Failure> {
        let new = out.beside().to_owned();
        let heading = self.format.heading(self.sweep).map_err(at(&new))?;
        out.write_all(&heading).map_err(at(&new))?;
        let mut end = heading.len() as u64;
        let mut places = vec![NOWHERE; self.rows.len()];
        let there: Vec<usize> = (0..self.rows.len()).filter(|&slot| self.rows[slot].length > 0).collect();
        if there.len() < least {
            return Err(self.disturbed());
        }
        for slots in there.chunks(BLOCK) {
            let rows: Vec<Where> = slots.iter().map(|&slot| self.rows[slot]).collect();
            for (&slot, line) in slots.iter().zip(&self.block(&rows)?) {
                // Nothing takes the place of the file that is not the row it should be.
                let statistics = self.format.read(self.sweep, line).ok().filter(|_| line.ends_with(b"\n"));
                if statistics.is_none_or(|(job, _)| job != self.part.job(slot)) {
                    return Err(self.disturbed());
                }
                out.write_all(line).map_err(at(&new))?;
                places[slot] = Where { offset: end, length: line.len() as u32, file: 0 };
                end += line.len() as u64;
            }
        }
        Ok((places, end))
    }

    /// The bytes of some rows, read one file after the other.
    fn block(&self, rows: &[Where]) -> Result<Vec<Vec<u8>>, Failure> {
        let mut order: Vec<usize> = (0..rows.len()).collect();
        order.sort_by_key(|&k| (rows[k].file, rows[k].offset));
        let mut lines = vec![Vec::new(); rows.len()];
        for of_file in order.chunk_by(|&a, &b| rows[a].file == rows[b].file) {
            let number = rows[of_file[0]].file as usize;
            let path = &self.files[number];
            let part = if number == 0 { None } else { Some(File::open(path).map_err(at(path))?) };
            let file = part.as_ref().unwrap_or(self.file.file());
            for &k in of_file {
                lines[k] = vec![0; rows[k].length as usize];
                read_at(file, rows[k].offset, &mut lines[k]).map_err(at(path))?;
            }
        }
        Ok(lines)
    }
}

/// What the statistics need of a run, in as little memory as they can.
#[derive(Debug, Clone, Copy, Default)]
struct Compact {
    /// NaN: there is none.
    value: f64,
    /// NaN: it was not.
    reached: f64,
    evaluations: f64,
    measured: bool,
    zero: bool,
    by: ReferenceOptimum,
    deterministic: bool,
}

impl From<RunStatistics> for Compact {
    fn from(statistics: RunStatistics) -> Self {
        let RunStatistics { value, reached, evaluations, measured, zero, by, deterministic } = statistics;
        let [value, reached] = [value, reached].map(|number| number.unwrap_or(f64::NAN));
        Self { value, reached, evaluations, measured, zero, by, deterministic }
    }
}

impl From<Compact> for RunStatistics {
    fn from(statistics: Compact) -> Self {
        let Compact { value, reached, evaluations, measured, zero, by, deterministic } = statistics;
        let [value, reached] = [value, reached].map(|number| Some(number).filter(|number| !number.is_nan()));
        Self { value, reached, evaluations, measured, zero, by, deterministic }
    }
}

fn read_at(mut file: &File, offset: u64, bytes: &mut [u8]) -> io::Result<()> {
    file.seek(SeekFrom::Start(offset)).and_then(|_| file.read_exact(bytes))
}
