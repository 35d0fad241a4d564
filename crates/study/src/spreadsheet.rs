//! Cells of CSV files that spreadsheets would take for formulas and carry out.

use std::{borrow::Cow, io};

/// What a cell begins with that spreadsheets carry out, and the mark itself, so that it can be taken away again.
const RISKY: [char; 7] = ['=', '+', '-', '@', '\t', '\r', MARK];
/// Spreadsheets show a cell behind it as text.
const MARK: char = '\'';

/// The text as it stands in a cell. Numbers stay numbers.
pub fn safe(text: &str) -> Cow<'_, str> {
    if text.starts_with(RISKY) && text.parse::<f64>().is_err() {
        let mut cell = String::with_capacity(text.len() + 1);
        cell.push(MARK);
        cell.push_str(text);
        Cow::Owned(cell)
    } else {
        Cow::Borrowed(text)
    }
}

/// The text that stands in a cell.
pub fn plain(cell: &str) -> &str {
    cell.strip_prefix(MARK).unwrap_or(cell)
}

/// A table whose cells are [`safe`].
///
/// # Errors
/// What is no table.
pub fn safe_table(text: &[u8]) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::with_capacity(text.len()));
    for record in csv::ReaderBuilder::new().has_headers(false).from_reader(text).records() {
        writer.write_record(record?.iter().map(|cell| safe(cell).into_owned()))?;
    }
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_texts_numbers_stay_and_all_comes_back() {
        for (text, cell) in [
            ("=1+1", "'=1+1"),
            ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
            ("-2+3", "'-2+3"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("\t=1", "'\t=1"),
            ("'quoted", "''quoted"),
            ("-1.5", "-1.5"),
            ("+7", "+7"),
            ("-1e-9", "-1e-9"),
            ("plain", "plain"),
            ("", ""),
        ] {
            assert_eq!(safe(text), cell);
            assert_eq!(plain(cell), text);
        }
    }
}
