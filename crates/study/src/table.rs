//! Tables: as text, Markdown, CSV and JSON.

use forage::kernel::{Message, message::in_english};
use serde::{Serialize, Serializer, ser::SerializeMap};

use super::spreadsheet;

/// What stands in a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing.
    Empty,
    /// Words.
    Text(String),
    /// A number, shown with so many digits after the point.
    Number(f64, usize),
    /// A number, shown with so many digits from the first that is not 0.
    Significant(f64, usize),
}

/// A number with so many digits from the first that is not 0; very small and very large ones with a power of ten.
pub fn significant(number: f64, digits: usize) -> String {
    let scientific = format!("{number:.*e}", digits - 1);
    let exponent: i32 = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    match exponent {
        _ if number == 0.0 => "0".to_owned(),
        -4..7 => format!("{number:.*}", usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0)),
        _ => scientific,
    }
}

/// A p-value as a number: four digits after the point, or two from the first that is not 0.
pub fn probability(p: f64) -> String {
    match p {
        0.0 => "< 1e-300".to_owned(),
        1e-4.. => format!("{p:.4}"),
        _ => significant(p, 2),
    }
}

/// A p-value in a sentence.
pub fn p_is(p: f64) -> String {
    let number = probability(p);
    if number.starts_with('<') { format!("p {number}") } else { format!("p = {number}") }
}

impl Cell {
    /// A number that may be missing.
    pub fn maybe(number: Option<f64>, digits: usize) -> Self {
        number.map_or(Self::Empty, |number| Self::Number(number, digits))
    }

    /// A number that may be missing, to so many digits wherever they begin.
    pub fn significant(number: Option<f64>, digits: usize) -> Self {
        number.map_or(Self::Empty, |number| Self::Significant(number, digits))
    }

    /// A whole number.
    pub fn whole(number: u64) -> Self {
        Self::Number(number as f64, 0)
    }

    fn shown(&self) -> String {
        match self {
            Self::Empty => String::new(),
            Self::Text(text) => text.clone(),
            Self::Number(number, digits) => {
                let text = format!("{number:.digits$}");
                // Nothing is less than nothing.
                let zero = text.strip_prefix('-').filter(|rest| !rest.contains(|c: char| c.is_ascii_digit() && c != '0'));
                zero.map_or_else(|| text.clone(), str::to_owned)
            }
            Self::Significant(number, digits) => significant(*number, *digits),
        }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Empty => serializer.serialize_none(),
            Self::Text(text) => serializer.serialize_str(text),
            Self::Number(number, _) | Self::Significant(number, _) => serializer.serialize_f64(*number),
        }
    }
}

/// A number with all its digits and no more, as programs read it: very small and very large ones with a power of ten.
pub fn digits(number: f64) -> String {
    let text = format!("{number:?}");
    text.strip_suffix(".0").map_or_else(|| text.clone(), ToOwned::to_owned)
}

/// What a table shows: a message, or a text in English.
pub trait Title {
    /// It as a message.
    fn message(self) -> Message;
}

impl Title for Message {
    fn message(self) -> Message {
        self
    }
}

impl Title for String {
    fn message(self) -> Message {
        Message::verbatim(self)
    }
}

impl Title for &str {
    fn message(self) -> Message {
        Message::verbatim(self)
    }
}

/// How a text is said.
pub type Say<'a> = &'a dyn Fn(&str) -> String;

/// As it is, in English.
pub fn as_it_is(text: &str) -> String {
    text.to_owned()
}

/// How many columns of a terminal a text takes: Han takes two for each character.
fn wide(text: &str) -> usize {
    let han = |c: char| matches!(c, '\u{2e80}'..='\u{9fff}' | '\u{f900}'..='\u{faff}' | '\u{ff00}'..='\u{ff60}');
    text.chars().map(|c| if han(c) { 2 } else { 1 }).sum()
}

/// Named columns and rows of as many cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// An identifier.
    pub name: String,
    /// What it shows.
    pub title: Message,
    /// The columns' names.
    pub columns: Vec<String>,
    /// The rows.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// Without rows yet.
    pub fn new(name: impl Into<String>, title: impl Title, columns: &[&str]) -> Self {
        Self { name: name.into(), title: title.message(), columns: columns.iter().map(|&name| name.to_owned()).collect(), rows: Vec::new() }
    }

    fn widths(columns: &[String], shown: &[Vec<String>]) -> Vec<usize> {
        (0..columns.len()).map(|j| shown.iter().map(|row| wide(&row[j])).chain([wide(&columns[j])]).max().unwrap_or(0)).collect()
    }

    /// A line of cells: texts to the left, numbers to the right.
    fn line(&self, cells: &[String], widths: &[usize], between: &str) -> String {
        let number = |j: usize| self.rows.iter().any(|row| matches!(row[j], Cell::Number(..) | Cell::Significant(..)));
        let pad = |(j, text): (usize, &String)| {
            let padding = " ".repeat(widths[j].saturating_sub(wide(text)));
            if number(j) { padding + text } else { text.clone() + &padding }
        };
        cells.iter().enumerate().map(pad).collect::<Vec<_>>().join(between)
    }

    fn lines(&self, between: &str, say: Say<'_>) -> (String, Vec<usize>, Vec<String>) {
        let shown = |cell: &Cell| if matches!(cell, Cell::Text(_)) { say(&cell.shown()) } else { cell.shown() };
        let shown: Vec<Vec<String>> = self.rows.iter().map(|row| row.iter().map(shown).collect()).collect();
        let columns: Vec<String> = self.columns.iter().map(|column| say(column)).collect();
        let widths = Self::widths(&columns, &shown);
        let rows = shown.iter().map(|row| self.line(row, &widths, between)).collect();
        (self.line(&columns, &widths, between), widths, rows)
    }

    /// For a terminal, in the language that is spoken; `say`: how columns, words in cells and titles that are no messages are said.
    pub fn text(&self, say: Say<'_>) -> String {
        let (heading, _, rows) = self.lines("  ", say);
        let title = if self.title.key().is_empty() { say(&self.title.text()) } else { self.title.to_string() };
        let lines = [title, heading].into_iter().chain(rows);
        lines.flat_map(|line| [line.trim_end().to_owned(), "\n".to_owned()]).collect()
    }

    /// For a document, in English.
    pub fn markdown(&self) -> String {
        let (heading, widths, rows) = self.lines(" | ", &as_it_is);
        let rule = widths.iter().map(|&width| "-".repeat(width.max(3))).collect::<Vec<_>>().join(" | ");
        let body: String = [heading, rule].into_iter().chain(rows).flat_map(|line| ["| ".to_owned(), line, " |\n".to_owned()]).collect();
        in_english(|| format!("**{}**\n\n{body}", self.title))
    }

    /// For other programs, with all digits.
    ///
    /// # Errors
    /// None that is known: it is written to memory.
    pub fn csv(&self) -> Result<Vec<u8>, std::io::Error> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(&self.columns).map_err(std::io::Error::other)?;
        for row in &self.rows {
            let all_digits = row.iter().map(|cell| match cell {
                Cell::Number(number, _) | Cell::Significant(number, _) => digits(*number),
                other => other.shown(),
            });
            writer.write_record(all_digits.map(|cell| spreadsheet::safe(&cell).into_owned())).map_err(std::io::Error::other)?;
        }
        writer.into_inner().map_err(|error| std::io::Error::other(error.to_string()))
    }
}

/// A row as an object.
struct Named<'a>(&'a [String], &'a [Cell]);

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().zip(self.1))
    }
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_map(Some(3))?;
        out.serialize_entry("name", &self.name)?;
        out.serialize_entry("title", &self.title)?;
        out.serialize_entry("rows", &self.rows.iter().map(|row| Named(&self.columns, row)).collect::<Vec<_>>())?;
        out.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_less_than_nothing() {
        let text = |number, digits| Cell::Number(number, digits).shown();
        assert_eq!([text(-0.0004, 3), text(-0.0006, 3), text(-0.0, 0), text(0.0, 1)], ["0.000", "-0.001", "0", "0.0"]);
    }

    #[test]
    fn numbers_are_shown_with_their_first_digits_and_read_with_all() {
        let shown: Vec<_> = [0.0, 1.0, 12.141_59, 123_456.7, 88_817_842.0, 4.44e-16].map(|number| significant(number, 4)).into();
        assert_eq!(shown, ["0", "1.000", "12.14", "123457", "8.882e7", "4.440e-16"]);
        let read = [0.0, 8.0, -1.25, 1e-7, 3e-122, 1e22, 123_456_789.5];
        assert_eq!(read.map(digits), ["0", "8", "-1.25", "1e-7", "3e-122", "1e22", "123456789.5"]);
        assert!(read.iter().all(|number| digits(*number).parse() == Ok(*number)));
    }

    #[test]
    fn a_table_is_shown_four_ways() {
        let mut table = Table::new("t", "Title", &["who", "x", "y"]);
        table.rows =
            vec![vec!["a".into(), Cell::Number(1.25, 1), Cell::Empty], vec!["bcd, e".into(), Cell::Number(10.0, 1), Cell::whole(3)]];
        assert_eq!(table.text(&as_it_is), "Title\nwho        x  y\na        1.2\nbcd, e  10.0  3\n");
        assert_eq!(
            table.markdown(),
            "**Title**\n\n| who    |    x | y |\n| ------ | ---- | --- |\n| a      |  1.2 |   |\n| bcd, e | 10.0 | 3 |\n"
        );
        assert_eq!(String::from_utf8(table.csv().unwrap()).unwrap(), "who,x,y\na,1.25,\n\"bcd, e\",10,3\n");
        assert_eq!(
            serde_json::to_value(&table).unwrap()["rows"],
            serde_json::json!([{ "who": "a", "x": 1.25, "y": null }, { "who": "bcd, e", "x": 10.0, "y": 3.0 }])
        );
    }
}
