//! Looks through a file of rows: which are there, which lines are damaged, doubled or in another order.

use super::{
    super::line::Wrong, BufRead, BufReader, Error, Failure, File, Format, Kept, LONGEST_LINE, Path, Read, Seek, SeekFrom, Where, at, io,
    locked, message,
};
use forage::kernel::Message;

/// Lines of one kind: how many, and the first.
#[derive(Default)]
struct Lines {
    count: u64,
    first: Option<(u64, Message)>,
}

impl Lines {
    /// One more; what is said of the first is kept.
    fn add(&mut self, line: u64, said: Message) {
        self.count += 1;
        self.first.get_or_insert((line, said));
    }
}

/// What was found.
#[derive(Default)]
struct Found {
    /// Where the last whole line ends.
    end: u64,
    /// The rows that can be read.
    rows: usize,
    damaged: Lines,
    /// Rows that stood in the file before, the same.
    doubled: Lines,
    /// Rows in front of which stands one that belongs behind it.
    disordered: Lines,
    /// The last line, if it does not end.
    torn: Option<u64>,
    /// Some of the damaged lines are not just those that a disk lost.
    is_strange: bool,
    /// The first line, if it is not that of rows.
    beginning: Option<Vec<u8>>,
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

fn malformed(path: &Path, problem: Message) -> Failure {
    Error::malformed(&path.display().to_string(), problem).into()
}

impl Kept<'_> {
    /// Finds the rows of a file, and says where its last whole line ends.
    pub(super) fn look_through(&mut self, number: usize) -> Result<u64, Failure> {
        let path = self.files[number].clone();
        let file = if number == 0 { self.file.file().try_clone() } else { File::open(&path) }.map_err(at(&path))?;
        if number > 0 {
            // That there are no locks is noted when the file itself is opened.
            locked(file.try_lock_shared(), &path)?;
        }
        let found = self.scan(number, &path, file)?;
        let nothing = found.rows == 0;
        match found.beginning {
            // Without a single row of ours it is something else, and stays.
            Some(line) if nothing => {
                let problem = self.format.wrong_beginning(self.sweep, &line).map_err(at(&path))?;
                return Err(malformed(&path, elsewhere(&problem, self.format.begins(&line))));
            }
            _ if nothing && found.is_strange => {
                let (line, problem) = found.damaged.first.unwrap_or_default();
                return Err(malformed(&path, elsewhere(&in_line(line, &problem), true)));
            }
            _ => {}
        }
        self.say(&path, number, &found)?;
        self.damaged |= number == 0 && found.damaged.count + found.doubled.count > 0;
        Ok(found.end)
    }

    fn scan(&mut self, number: usize, path: &Path, file: File) -> Result<Found, Failure> {
        let mut reader = BufReader::with_capacity(1 << 16, file);
        reader.rewind().map_err(at(path))?;
        let heading = self.format.heading(self.sweep).map_err(at(path))?;
        let mut found = Found::default();
        let (mut line, mut count, mut last) = (Vec::new(), 0, None);
        loop {
            line.clear();
            let length = reader.by_ref().take(LONGEST_LINE + 1).read_until(b'\n', &mut line).map_err(at(path))?;
            count += 1;
            if length as u64 > LONGEST_LINE {
                if found.end == 0 && !heading.is_empty() {
                    found.beginning = Some(line);
                    return Ok(found);
                }
                let most = LONGEST_LINE >> 10;
                let problem =
                    message!("study-long-line", "line {count} has more than {most} KiB, so it is no row; --fresh starts over", count, most);
                return Err(malformed(path, problem));
            }
            if !line.ends_with(b"\n") {
                // What was torn in the heading or in the first row is ours if it begins like ours.
                if found.end == 0 && !self.is_torn_beginning(&line).map_err(at(path))? {
                    found.beginning = Some(line);
                } else if !line.is_empty() {
                    found.torn = Some(count);
                }
                return Ok(found);
            }
            let here = Where { offset: found.end, length: length as u32, file: number as u32 };
            if count == 1 && !heading.is_empty() {
                if line != heading {
                    let problem = self.format.wrong_beginning(self.sweep, &line).map_err(at(path))?;
                    found.damaged.add(count, problem);
                    found.beginning = Some(line.clone());
                }
            } else {
                match self.format.read(self.sweep, &line) {
                    Ok((job, statistics)) => {
                        let slot = self.part.find(job).ok_or_else(|| {
                            let (run, part) = (self.sweep.describe(job), self.part.to_string());
                            let problem =
                                message!("study-not-in-part", "line {count}: the run of {run} is not in part {part}", count, run, part);
                            malformed(path, elsewhere(&problem, true))
                        })?;
                        found.rows += 1;
                        if last.is_some_and(|last| slot < last) {
                            found.disordered.add(count, Message::verbatim(self.sweep.describe(job)));
                        }
                        last = Some(slot);
                        if self.rows[slot].length == 0 {
                            self.hold(slot, here, statistics);
                        } else {
                            let before = self.rows[slot];
                            let same = self.bytes(before)? == line;
                            // Reading the row moved the place in the file, which the reader shares.
                            reader.seek(SeekFrom::Start(here.offset + length as u64)).map_err(at(path))?;
                            let run = self.sweep.describe(job);
                            if !same {
                                let problem =
                                    message!("study-run-differs", "line {count}: the run of {run} came out otherwise before", count, run);
                                return Err(malformed(path, problem));
                            }
                            if before.file == number as u32 {
                                found.doubled.add(count, Message::verbatim(run));
                            }
                        }
                    }
                    Err(Wrong::Damaged(problem)) => {
                        found.is_strange |= !line.contains(&0);
                        if count == 1 && !self.format.begins(&line) && !line.contains(&0)
                            || self.format.is_old(self.sweep, &line).map_err(at(path))?
                        {
                            found.beginning = Some(line.clone());
                        }
                        found.damaged.add(count, problem);
                    }
                    Err(Wrong::Other(problem)) => return Err(malformed(path, elsewhere(&in_line(count, &problem), true))),
                }
            }
            found.end += length as u64;
        }
    }

    /// Whether a first line that was torn off is that of our rows.
    fn is_torn_beginning(&self, line: &[u8]) -> io::Result<bool> {
        let beginnings = self.format.beginnings(self.sweep)?;
        // Where the power failed a disk may have zeros, which no text has.
        let text = line.split(|&byte| byte == 0).next().unwrap_or_default();
        if text.is_empty() {
            return Ok(line.iter().all(|&byte| byte == 0));
        }
        Ok(beginnings
            .iter()
            .any(|beginning| beginning.starts_with(text) || self.format == Format::JsonLines && text.starts_with(beginning)))
    }

    /// Says what is wrong with a file of ours; that of somebody else is refused then.
    fn say(&mut self, path: &Path, number: usize, found: &Found) -> Result<(), Failure> {
        let file = || path.display().to_string();
        let of_another = number > 0;
        if let Some((first, problem)) = &found.damaged.first {
            if of_another {
                return Err(malformed(path, in_line(*first, problem)));
            }
            let (more, problem) = (found.damaged.count - 1, problem.clone());
            let note = if more > 0 {
                message!(
                    "study-lines-damaged",
                    "{file}: line {first} is damaged ({problem}), and {more} more; missing runs are repeated",
                    file = file(),
                    first,
                    problem,
                    more
                )
            } else {
                message!(
                    "study-line-damaged",
                    "{file}: line {first} is damaged ({problem}); missing runs are repeated",
                    file = file(),
                    first,
                    problem
                )
            };
            self.notes.push(note.to_string());
        }
        if let Some((first, run)) = &found.doubled.first {
            let (more, run) = (found.doubled.count - 1, run.clone());
            let problem =
                message!("study-doubled", "line {first}: the run of {run} stands there twice, and so do {more} more", first, run, more);
            if of_another {
                return Err(malformed(path, problem));
            }
            self.notes
                .push(message!("study-doubled-removed", "{file}: {problem}; one of each is kept", file = file(), problem).to_string());
        }
        if let Some(line) = found.torn {
            let problem = message!("study-torn", "line {line}, the last one, is incomplete", line);
            if of_another {
                return Err(malformed(path, problem));
            }
            self.notes.push(message!("study-torn-removed", "{file}: {problem}; its run is repeated", file = file(), problem).to_string());
        }
        // While runs finish they are in any order; a file with all of them was put in order.
        let all = self.rows.len();
        if let (Some((first, run)), true) = (&found.disordered.first, found.rows >= all) {
            let run = run.clone();
            let problem =
                message!("study-disordered", "line {first}: the run of {run} is behind one that it should be in front of", first, run);
            if of_another {
                return Err(malformed(path, problem));
            }
            self.notes.push(message!("study-put-in-order", "{file}: {problem}; it is put in order", file = file(), problem).to_string());
        }
        Ok(())
    }
}

fn in_line(line: u64, problem: &Message) -> Message {
    message!("study-in-line", "line {count}: {problem}", count = line, problem)
}
