//! What a reproduction has to say: tables, claims, what was chosen where the paper is silent, and how to repeat it.

use std::{fmt::Write, fs, path::PathBuf};

use serde::Serialize;

use super::{
    Failure, Options, Study, at,
    claims::{self, Judged},
    compared::ComparedFigure,
    document,
    escape::{path_text, serialize_paths},
    forensics,
    table::Table,
};

/// A reproduction's result.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// The reproduction's name.
    pub name: &'static str,
    /// A line for people.
    pub title: &'static str,
    /// Where it was published.
    pub source: &'static str,
    /// Whether all of it comes out the same again.
    pub repeatable: bool,
    /// Runs a cell, where they are fewer or more than published.
    pub shortened: Option<String>,
    /// The published figures and the computed ones.
    #[serde(serialize_with = "document::serialize_figures")]
    pub figures: Vec<ComparedFigure>,
    /// The tables.
    pub tables: Vec<Table>,
    /// What the paper claims, and whether it holds.
    pub claims: Vec<Judged>,
    /// What was chosen where the paper is silent, and what should be known when reading the tables.
    pub notes: Vec<String>,
    /// Command lines that repeat single runs.
    pub commands: Vec<String>,
    /// What was written.
    #[serde(serialize_with = "serialize_paths")]
    pub files: Vec<PathBuf>,
}

impl Report {
    /// Nothing to say yet.
    pub fn new(reproduction: &Study, runs: u64, published: u64) -> Self {
        let shortened = (runs != published).then(|| format!("{runs} runs a cell, published: {published}"));
        let Study { name, title, source, repeatable, .. } = *reproduction;
        let (figures, tables, claims, notes, commands, files) = Default::default();
        Self { name, title, source, repeatable, shortened, figures, tables, claims, notes, commands, files }
    }

    /// Writes each table as CSV and the whole as Markdown.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&mut self, options: &Options) -> Result<(), Failure> {
        forensics::attach(&mut self.figures, document::paper(self.source))?;
        fs::create_dir_all(&options.out).map_err(at(&options.out))?;
        for table in &self.tables {
            let path = options.out.join(format!("{}-{}.csv", self.name, table.name));
            table.csv().and_then(|text| fs::write(&path, text)).map_err(at(&path))?;
            self.files.push(path);
        }
        let path = options.out.join(format!("{}.md", self.name));
        fs::write(&path, self.markdown()).map_err(at(&path))?;
        self.files.push(path);
        Ok(())
    }

    /// The tag of its paper: `WCPSO` of `[WCPSO] Table 2`.
    pub fn paper(&self) -> &'static str {
        document::paper(self.source)
    }

    fn heading(&self) -> String {
        let shortened = self.shortened.as_ref().map_or(String::new(), |text| format!(" ({text})"));
        format!("{}: {}, {}{shortened}", self.name, self.title, self.source)
    }

    /// For a terminal.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.heading());
        document::tables(&self.figures).iter().for_each(|table| text += &(table.text() + "\n"));
        self.tables.iter().for_each(|table| text += &(table.text() + "\n"));
        text += &claims::text(&self.claims);
        let files = self.files.iter().map(|path| path_text(path));
        for (title, items) in [("Notes", self.notes.clone()), ("To repeat a run", self.commands.clone()), ("Written", files.collect())] {
            if items.is_empty() {
                continue;
            }
            let _ = writeln!(text, "\n{title}");
            items.iter().for_each(|item| text.extend(["  ", item, "\n"]));
        }
        text
    }

    fn markdown(&self) -> String {
        let mut text = format!("## {}\n\n{}", self.heading(), document::figures(self));
        self.tables.iter().for_each(|table| text += &(table.markdown() + "\n"));
        text += &claims::markdown(&self.claims);
        if !self.notes.is_empty() {
            text += "\n";
        }
        self.notes.iter().for_each(|note| text.extend(["- ", note, "\n"]));
        if !self.commands.is_empty() {
            text += "\nTo repeat a run:\n\n";
        }
        self.commands.iter().for_each(|command| text.extend(["    ", command, "\n"]));
        text
    }
}
