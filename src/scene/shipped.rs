//! Texts of scene files without the spaces that are for people: they are in the download.

/// The text of a scene file, whose path is relative to the file that asks for it.
macro_rules! shipped {
    ($path:literal) => {{
        const TEXT: &[u8] = include_bytes!($path);
        const SHORT: [u8; $crate::scene::shipped::without_spaces::<{ TEXT.len() }>(TEXT).1] =
            *$crate::scene::shipped::without_spaces::<{ TEXT.len() }>(TEXT).0.first_chunk().expect("it is not longer");
        match str::from_utf8(&SHORT) {
            Ok(text) => text,
            Err(_) => panic!("a scene file is text"),
        }
    }};
}

pub(super) use shipped;

/// A text of JSON without spaces between its parts, at the beginning of an array, and how long it is.
pub(super) const fn without_spaces<const N: usize>(text: &[u8]) -> ([u8; N], usize) {
    let (mut out, mut length) = ([0; N], 0);
    let (mut within, mut escaped, mut i) = (false, false, 0);
    while i < N {
        let byte = text[i];
        if within || !byte.is_ascii_whitespace() {
            out[length] = byte;
            length += 1;
        }
        if byte == b'"' && !escaped {
            within = !within;
        }
        escaped = within && byte == b'\\' && !escaped;
        i += 1;
    }
    (out, length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spaces_in_texts_stay() {
        const TEXT: &[u8] = b"{ \"a b\":  [\"c \\\" d\", 1 ],\n \"e\\\\\": \" \" }";
        let (out, length) = without_spaces::<{ TEXT.len() }>(TEXT);
        assert_eq!(str::from_utf8(&out[..length]).unwrap(), r#"{"a b":["c \" d",1],"e\\":" "}"#);
    }
}
