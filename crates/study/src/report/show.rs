//! A report for a terminal, and as files.

use std::fmt::Write;

use forage::{
    kernel::{Message, message::in_english},
    message,
};

use super::{
    super::{
        claims, disk,
        escape::path_text,
        failure::{Failure, at},
        findings,
        options::Options,
        papers,
        table::{Say, as_it_is},
    },
    Report, figures,
};

impl Report {
    /// Writes each table as CSV and the whole as Markdown.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&mut self, options: &Options) -> Result<(), Failure> {
        findings::attach(&mut self.figures, papers::tag(self.source))?;
        disk::make_folder(&options.out).map_err(at(&options.out))?;
        for table in &self.tables {
            let path = options.out.join(format!("{}-{}.csv", self.name, table.name));
            table.csv().and_then(|text| disk::write(&path, text)).map_err(at(&path))?;
            self.files.push(path);
        }
        let path = options.out.join(format!("{}.md", self.name));
        disk::write(&path, self.markdown()).map_err(at(&path))?;
        self.files.push(path);
        Ok(())
    }

    fn heading(&self) -> String {
        in_english(|| self.message(&as_it_is).to_string())
    }

    fn message(&self, say: Say<'_>) -> Message {
        let (name, title, source) = (self.name, say(self.title), say(self.source));
        if let Some(how) = &self.shortened {
            message!("study-shortened", "{name}: {title}, {source} ({how})", name, title, source, how = say(how))
        } else {
            message!("study-report", "{name}: {title}, {source}", name, title, source)
        }
    }

    /// For a terminal; `say`: how texts in English are said.
    pub fn text(&self, say: Say<'_>) -> String {
        let mut text = format!("{}\n\n", self.message(say));
        figures::tables(&self.figures).iter().for_each(|table| text += &(table.text(say) + "\n"));
        self.tables.iter().for_each(|table| text += &(table.text(say) + "\n"));
        text += &claims::text(&self.claims, say);
        let notes = self.notes.iter().map(|note| say(note)).collect();
        let files = self.files.iter().map(|path| path_text(path)).collect();
        let sections = [
            (message!("study-notes", "Notes"), notes),
            (message!("study-to-repeat", "To repeat a run"), self.commands.clone()),
            (message!("study-written", "Written"), files),
        ];
        for (title, items) in sections {
            if items.is_empty() {
                continue;
            }
            let _ = writeln!(text, "\n{title}");
            items.iter().for_each(|item| text.extend(["  ", item, "\n"]));
        }
        text
    }

    fn markdown(&self) -> String {
        let mut text = format!("## {}\n\n{}", self.heading(), figures::figures(self));
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
