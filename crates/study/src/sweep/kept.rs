//! The file of a sweep's rows: where each one stands, and what the statistics need of it; the rows themselves stay on the disk.
//!
//! Rows are appended as runs finish, each in one write, so that whatever kills the program leaves whole lines and at most a
//! torn one at the end, which is dropped at the next start. When all are there the file is put in the order of the runs, in a
//! new one beside it that takes its place at once. Nobody else can write meanwhile: the file is locked.

use std::{
    fs::{self, File, OpenOptions},
    io::{self, BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write},
    path::{Path, PathBuf},
};

use forage::{
    kernel::{Error, Message},
    message,
    run::trial::Record,
};

use super::{
    super::{
        failure::{Failure, at},
        files::{damaged, is_same, locked, with_suffix},
    },
    line::{Format, RunStatistics, Wrong},
    plan::{Part, Sweep},
};

/// How many digits a hash has.
const HASH: usize = 16;

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

/// The rows of a sweep, or of a part of it.
#[derive(Debug)]
pub struct Kept<'a> {
    sweep: &'a Sweep,
    part: Part,
    format: Format,
    /// Where the rows go; first the file itself, then those whose rows are merged into it.
    files: Vec<PathBuf>,
    /// The first of them. The others are opened when they are read: there may be more than can be open at once.
    file: File,
    /// Where what is ours ends in the file.
    end: u64,
    rows: Vec<Where>,
    told: Vec<RunStatistics>,
    count: usize,
    /// Whether lines of the file were left out.
    damaged: bool,
    notes: Vec<String>,
}

fn told(note: &Message) -> String {
    note.to_string()
}

/// What is wrong with a file that has the rows of something else, and what helps; `fresh`: whether it may be thrown away.
fn elsewhere(problem: &Message, fresh: bool) -> Message {
    if fresh {
        message!(
            "study-another-experiment-fresh",
            "{problem}: it belongs to another experiment; --out writes elsewhere, --fresh starts over",
            problem
        )
    } else {
        message!("study-another-experiment", "{problem}: it belongs to another experiment; --out writes elsewhere", problem)
    }
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
            fs::create_dir_all(folder).map_err(at(folder))?;
        }
        let file = OpenOptions::new().read(true).append(true).create(true).open(path).map_err(at(path))?;
        let notes = locked(file.try_lock(), path)?.iter().map(ToString::to_string).collect();
        let all = part.len(sweep.len());
        let (rows, told) = (vec![NOWHERE; all], vec![RunStatistics::default(); all]);
        let files = vec![path.to_owned()];
        let mut kept = Self { sweep, part, format, files, file, end: 0, rows, told, count: 0, damaged: false, notes };
        if !fresh {
            kept.end = kept.look_through(0)?;
        } else if !kept.begins_like_rows(&kept.file)? {
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

    /// Makes the file ready for rows: what is not ours in it goes.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn begin(&mut self) -> Result<(), Failure> {
        let path = &self.files[0];
        if self.damaged {
            let bad = damaged(path);
            let mut copy = File::create_new(&bad).map_err(at(&bad))?;
            File::open(path).and_then(|mut file| io::copy(&mut file, &mut copy)).map_err(at(&bad))?;
            let (file, bad) = (path.display().to_string(), bad.display().to_string());
            self.notes.push(told(&message!("study-kept-as", "{file}: as it was it is kept as {bad}", file, bad)));
        }
        self.file.set_len(self.end).map_err(at(path))?;
        if self.end == 0 {
            let heading = self.format.heading(self.sweep).map_err(at(path))?;
            self.file.write_all(&heading).map_err(at(path))?;
            self.end = heading.len() as u64;
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
        if self.file.metadata().is_ok_and(|file| file.len() == 0) {
            // It says nothing, and so it does no harm if it stays.
            let _ = fs::remove_file(self.path());
        }
    }

    /// What should be known about the files.
    pub fn notes(&self) -> &[String] {
        &self.notes
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

    /// Finds the rows of a file, and says where its last whole line ends.
    fn look_through(&mut self, number: usize) -> Result<u64, Failure> {
        let path = self.files[number].clone();
        let file = if number == 0 { self.file.try_clone() } else { File::open(&path) }.map_err(at(&path))?;
        if number > 0 {
            // Where there are no locks, that is told of the file itself.
            locked(file.try_lock_shared(), &path)?;
        }
        let other =
            |problem: Message, fresh: bool| Failure::from(Error::malformed(&path.display().to_string(), elsewhere(&problem, fresh)));
        let mut reader = BufReader::with_capacity(1 << 16, file);
        reader.rewind().map_err(at(&path))?;
        let heading = self.format.heading(self.sweep).map_err(at(&path))?;
        let beginning = self.format.beginning(self.sweep).map_err(at(&path))?;
        let (mut line, mut end, mut count) = (Vec::new(), 0_u64, 0);
        // The first one and how many there are: there may be more than fit in memory.
        let (mut damaged, mut first_damaged) = (0_u64, None);
        loop {
            line.clear();
            let length = reader.by_ref().take(LONGEST_LINE + 1).read_until(b'\n', &mut line).map_err(at(&path))?;
            count += 1;
            // What was torn in the middle is ours if it begins like ours.
            let torn = !line.ends_with(b"\n");
            let ours = end > 0 || line.starts_with(&beginning) || torn && beginning.starts_with(&line);
            if !ours {
                let problem = if torn || heading.is_empty() {
                    message!("study-no-file-of-rows", "it does not begin like a file of rows")
                } else {
                    let line = String::from_utf8_lossy(&heading).trim_end().to_owned();
                    message!("study-first-line", "its first line is not {line}", line)
                };
                return Err(other(problem, self.format.begins(&line)));
            }
            if length as u64 > LONGEST_LINE {
                let most = LONGEST_LINE >> 10;
                let problem =
                    message!("study-long-line", "line {count} has more than {most} KiB, so it is no row; --fresh starts over", count, most);
                return Err(Error::malformed(&path.display().to_string(), problem).into());
            }
            if torn {
                break;
            }
            if end > 0 || heading.is_empty() {
                match self.format.read(self.sweep, &line) {
                    Ok((job, told)) => {
                        let not_here = || {
                            let (run, part) = (self.sweep.describe(job), self.part.to_string());
                            message!("study-not-in-part", "line {count}: the run of {run} is not in part {part}", count, run, part)
                        };
                        let slot = self.part.find(job).ok_or_else(|| other(not_here(), true))?;
                        if self.rows[slot].length == 0 {
                            self.hold(slot, Where { offset: end, length: length as u32, file: number as u32 }, told);
                        } else {
                            let before = self.bytes(self.rows[slot])?;
                            // Reading the row moved the place in the file, which the reader shares.
                            reader.seek(SeekFrom::Start(end + length as u64)).map_err(at(&path))?;
                            if before != line {
                                let run = self.sweep.describe(job);
                                let problem =
                                    message!("study-run-differs", "line {count}: the run of {run} came out otherwise before", count, run);
                                return Err(Error::malformed(&path.display().to_string(), problem).into());
                            }
                        }
                    }
                    Err(Wrong::Damaged(problem)) => {
                        damaged += 1;
                        first_damaged.get_or_insert((count, problem));
                    }
                    Err(Wrong::Other(problem)) => {
                        return Err(other(message!("study-in-line", "line {count}: {problem}", count, problem), true));
                    }
                }
            }
            end += length as u64;
        }
        if let Some((first, problem)) = first_damaged {
            let (file, more) = (path.display().to_string(), damaged - 1);
            self.notes.push(told(&if more > 0 {
                message!(
                    "study-lines-damaged",
                    "{file}: line {first} is damaged ({problem}), and {more} more; missing runs are repeated",
                    file,
                    first,
                    problem,
                    more
                )
            } else {
                message!(
                    "study-line-damaged",
                    "{file}: line {first} is damaged ({problem}); missing runs are repeated",
                    file,
                    first,
                    problem
                )
            }));
            self.damaged |= number == 0;
        }
        Ok(end)
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
        self.notes.push(told(&message!(
            "study-looked-again",
            "{file}: another program wrote in it; what it wrote was looked through, too",
            file
        )));
        Ok(())
    }

    fn disturbed(&self) -> Failure {
        at(self.path())(io::Error::other(
            message!("study-disturbed", "another program wrote over rows in it; when that has ended the same command goes on").to_string(),
        ))
    }

    fn hold(&mut self, slot: usize, here: Where, told: RunStatistics) {
        self.rows[slot] = here;
        self.told[slot] = told;
        self.count += 1;
    }

    fn bytes(&self, row: Where) -> Result<Vec<u8>, Failure> {
        let mut bytes = vec![0; row.length as usize];
        if row.file == 0 {
            read_at(&self.file, row.offset, &mut bytes).map_err(at(self.path()))?;
        } else {
            let path = &self.files[row.file as usize];
            File::open(path).and_then(|file| read_at(&file, row.offset, &mut bytes)).map_err(at(path))?;
        }
        Ok(bytes)
    }

    /// The hash in a run's row: what is last in it.
    pub(super) fn hash(&self, job: usize) -> Result<String, Failure> {
        let Some(row) = self.part.find(job).map(|slot| self.rows[slot]).filter(|row| row.length > 0) else { return Ok(String::new()) };
        let line = String::from_utf8_lossy(&self.bytes(row)?).into_owned();
        let end = line.trim_end().trim_end_matches(['"', '}']);
        Ok(end.get(end.len().saturating_sub(HASH)..).unwrap_or_default().to_owned())
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
        (self.rows[slot].length > 0).then(|| self.told[slot])
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
            "the run of {run} now gives another row: another version of forage, another scene or another `within`; --fresh starts over",
            run = self.sweep.describe(job)
        );
        Err(Error::malformed(&self.path().display().to_string(), problem).into())
    }

    /// Adds a row, in one write, so that it is there whatever happens next.
    ///
    /// # Errors
    /// A disk that is full, and the like.
    pub fn append(&mut self, job: usize, record: &Record) -> Result<(), Failure> {
        let Some(slot) = self.part.find(job) else { return Ok(()) };
        let path = &self.files[0];
        let line = self.format.line(self.sweep, job, record).map_err(at(path))?;
        self.file.write_all(&line).and_then(|()| self.file.flush()).map_err(at(path))?;
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

    /// Puts the file in the order of the runs, in one go: until then the old one stays.
    ///
    /// # Errors
    /// A disk that is full, and the like; a file in which somebody else writes.
    pub fn settle(&mut self) -> Result<(), Failure> {
        if self.file.metadata().map_err(at(self.path()))?.len() != self.end {
            self.look_again()?;
        }
        let mut next = self.format.heading(self.sweep).map_err(at(self.path()))?.len() as u64;
        let in_order = self.rows.iter().all(|row| {
            let here = row.file == 0 && row.offset == next;
            next += u64::from(row.length);
            here
        });
        if in_order && next == self.end {
            return Ok(());
        }
        // Behind a link is the file that is replaced.
        let target = fs::canonicalize(self.path()).map_err(at(self.path()))?;
        let new = with_suffix(&target, ".new");
        self.write_ordered(&new)?;
        fs::rename(&new, &target).map_err(at(&target))
    }

    fn write_ordered(&self, new: &Path) -> Result<(), Failure> {
        let wrong = |error: io::Error| Failure::File(new.to_owned(), error);
        let mut out = BufWriter::with_capacity(1 << 16, File::create(new).map_err(wrong)?);
        out.write_all(&self.format.heading(self.sweep).map_err(wrong)?).map_err(wrong)?;
        for (block, rows) in self.rows.chunks(BLOCK).enumerate() {
            for (k, line) in self.block(rows)?.iter().enumerate() {
                // Nothing takes the place of the file that is not the row it should be.
                let told = self.format.read(self.sweep, line).ok().filter(|_| line.ends_with(b"\n"));
                if told.is_none_or(|(job, _)| job != self.part.job(block * BLOCK + k)) {
                    return Err(self.disturbed());
                }
                out.write_all(line).map_err(wrong)?;
            }
        }
        let file = out.into_inner().map_err(|error| wrong(error.into_error()))?;
        file.sync_all().map_err(wrong)
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
            let file = part.as_ref().unwrap_or(&self.file);
            for &k in of_file {
                lines[k] = vec![0; rows[k].length as usize];
                read_at(file, rows[k].offset, &mut lines[k]).map_err(at(path))?;
            }
        }
        Ok(lines)
    }
}

fn read_at(mut file: &File, offset: u64, bytes: &mut [u8]) -> io::Result<()> {
    file.seek(SeekFrom::Start(offset)).and_then(|_| file.read_exact(bytes))
}
