//! Grey pictures: PGM as text (P2) and as bytes (P5).

use forage::{
    kernel::{Error, Message},
    message,
    scene::MAX_SIDE,
};

use super::file::{NamedFile, a_height, a_width};

/// A grey picture, top row first.
#[derive(Debug)]
pub(super) struct Image {
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// The value of white.
    pub(super) white: u16,
    pub(super) values: Vec<u16>,
    /// The bytes after the picture.
    pub(super) rest: usize,
}

/// The place up to which a file was read.
struct Reader<'a> {
    file: &'a NamedFile,
    left: &'a [u8],
    line: usize,
}

impl<'a> Reader<'a> {
    fn advance(&mut self, count: usize) -> &'a [u8] {
        let (skipped, left) = self.left.split_at(count);
        self.left = left;
        self.line += skipped.split(|&byte| byte == b'\n').count() - 1;
        skipped
    }

    /// Skips spaces and comments.
    fn space(&mut self) {
        while let Some(&byte) = self.left.first() {
            let count = match byte {
                b'#' => self.left.iter().position(|&byte| byte == b'\n').unwrap_or(self.left.len()),
                _ if byte.is_ascii_whitespace() => 1,
                _ => break,
            };
            self.advance(count);
        }
    }

    /// The next word, after spaces and comments.
    fn word(&mut self) -> &'a [u8] {
        self.space();
        let count = self.left.iter().position(u8::is_ascii_whitespace).unwrap_or(self.left.len());
        self.advance(count)
    }

    fn number(&mut self, least: usize, most: usize, expected: fn(usize) -> Message) -> Result<usize, Error> {
        let word = self.word();
        let number = str::from_utf8(word).ok().and_then(|text| text.parse().ok()).filter(|number| (least..=most).contains(number));
        number.ok_or_else(|| {
            if word.is_empty() {
                return self.file.ends(self.line, &expected(most));
            }
            self.file.unexpected(self.line, &String::from_utf8_lossy(word), &expected(most))
        })
    }
}

/// Reads a picture.
pub(super) fn read(file: &NamedFile) -> Result<Image, Error> {
    let mut reader = Reader { file, left: &file.bytes, line: 1 };
    let magic = reader.word();
    if !matches!(magic, b"P2" | b"P5") {
        let expected = message!("files-grey", "P2 or P5, a grey picture");
        return Err(file.unexpected(1, &String::from_utf8_lossy(magic), &expected));
    }
    let columns = reader.number(1, MAX_SIDE, a_width)?;
    let rows = reader.number(1, MAX_SIDE, a_height)?;
    let white = |most| message!("files-white", "the value of white from 1 to {most}", most);
    let most = reader.number(1, usize::from(u16::MAX), white)?;
    let mut values = Vec::with_capacity(columns * rows);
    if magic == b"P2" {
        let pixel = |most| message!("files-pixel", "a pixel from 0 to {most}", most);
        for _ in 0..columns * rows {
            values.push(reader.number(0, most, pixel)? as u16);
        }
        reader.space();
    } else {
        let width = if most > 255 { 2 } else { 1 };
        let needed = columns * rows * width;
        // One space, whatever it is, ends the heading; a line's end of two bytes only where that leaves all pixels.
        let ending = if reader.left.starts_with(b"\r\n") && reader.left.len() == needed + 2 { 2 } else { 1 };
        reader.advance(reader.left.len().min(ending));
        let Some((pixels, rest)) = reader.left.split_at_checked(needed) else {
            let n = reader.left.len();
            let problem = message!("files-pixels", "found {n} bytes of pixels, expected {expected}", n, expected = needed);
            return Err(file.wrong(reader.line, &problem));
        };
        for (i, pixel) in pixels.chunks(width).enumerate() {
            let value = pixel.iter().fold(0, |value, &byte| value << 8 | u16::from(byte));
            if usize::from(value) > most {
                let expected = message!(
                    "files-pixel-at",
                    "a pixel from 0 to {most} in row {row}, column {column} of the picture",
                    most,
                    row = i / columns + 1,
                    column = i % columns + 1
                );
                return Err(file.unexpected(reader.line, &value.to_string(), &expected));
            }
            values.push(value);
        }
        reader.left = rest;
    }
    Ok(Image { columns, rows, white: most as u16, values, rest: reader.left.len() })
}

/// A picture as bytes, of the values' rows from the top.
pub(super) fn write(columns: usize, values: &[u8]) -> Vec<u8> {
    let mut bytes = format!("P5\n{columns} {}\n255\n", values.len() / columns.max(1)).into_bytes();
    bytes.extend(values);
    bytes
}
