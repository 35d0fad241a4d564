//! How much an input may hold: the same limits natively and in WebAssembly, checked before anything recursive sees a value.

use crate::message;

use super::{Error, Message};

/// How deep lists and objects may be nested.
pub const DEPTH: usize = 64;
/// How many values an input may hold: twice as many as the largest matrix of distances.
pub const VALUES: usize = 8_000_000;
/// The longest link, and the longest scene that one may carry, in bytes.
pub const LINK_BYTES: usize = 4 << 20;
/// The largest file, in bytes.
pub const FILE_BYTES: usize = 64 << 20;

/// The most memory that the members of a search may take together, in bytes. WebAssembly has eight times as much for them, their
/// copies and everything else.
pub const MEMBERS_BYTES: usize = 512 << 20;

/// The largest whole number that a seed, a count or an iteration can be: JavaScript holds all up to here exactly.
pub const WHOLE: u64 = (1 << 53) - 1;

/// The whole numbers up to [`WHOLE`], in words.
pub fn whole_range() -> Message {
    message!("error-whole-from-to", "a whole number from {min} to {max}", min = 0, max = WHOLE)
}

/// Refuses a number above [`WHOLE`].
///
/// # Errors
/// [`Error::Refused`] for `field`.
pub fn check_whole(field: &str, number: u64) -> Result<u64, Error> {
    if number <= WHOLE { Ok(number) } else { Err(Error::refused(field, number, whole_range())) }
}

/// The whole number up to [`WHOLE`] that a text is.
///
/// # Errors
/// [`Error::Refused`] for `field`.
pub fn read_whole(field: &str, text: &str) -> Result<u64, Error> {
    let number = text.parse().ok().filter(|&number| number <= WHOLE);
    number.ok_or_else(|| Error::refused(field, text, whole_range()))
}

/// Refuses a text or a file of more than `most` bytes.
///
/// # Errors
/// [`Error::Refused`] for `field`.
pub fn check_bytes(field: &str, bytes: usize, most: usize) -> Result<(), Error> {
    if bytes <= most {
        Ok(())
    } else {
        Err(Error::refused(
            field,
            message!("error-bytes", "a size of {n} bytes", n = bytes),
            message!("error-most-bytes", "at most {most} bytes", most),
        ))
    }
}

/// Refuses more members than there is memory for; one of them takes `each` bytes.
///
/// # Errors
/// [`Error::Refused`] for `field`.
pub fn check_members(field: &str, members: u64, each: usize) -> Result<(), Error> {
    let most = (MEMBERS_BYTES / each.max(1)) as u64;
    if members <= most {
        return Ok(());
    }
    let allowed = message!("error-most-members", "at most {most} where each takes {each} bytes of memory", most, each);
    Err(Error::refused(field, members, allowed))
}

/// Refuses values that are nested deeper than [`DEPTH`].
pub(super) fn check_depth(field: &str, depth: usize) -> Result<(), Error> {
    if depth <= DEPTH {
        return Ok(());
    }
    Err(Error::refused(
        field,
        message!("error-deep", "nesting deeper than {most} levels", most = DEPTH),
        message!("error-most-levels", "at most {most} levels deep", most = DEPTH),
    ))
}

/// Refuses more values than [`VALUES`].
///
/// # Errors
/// [`Error::Refused`] for `field`.
pub fn check_values(field: &str, values: usize) -> Result<(), Error> {
    if values <= VALUES {
        return Ok(());
    }
    Err(Error::refused(
        field,
        message!("error-many-values", "more than {most} values", most = VALUES),
        message!("error-most-values", "at most {most} values", most = VALUES),
    ))
}

/// Refuses JSON text that is longer, nested deeper or of more values than allowed. What is no JSON may pass.
pub(super) fn check_json(field: &str, text: &str) -> Result<(), Error> {
    check_bytes(field, text.len(), FILE_BYTES)?;
    let (mut depth, mut values, mut quoted, mut escaped) = (0_usize, 1, false, false);
    for byte in text.bytes() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = quoted,
            b'"' => quoted = !quoted,
            _ if quoted => {}
            b'[' | b'{' => {
                (depth, values) = (depth + 1, values + 1);
                check_depth(field, depth)?;
            }
            b']' | b'}' => depth = depth.saturating_sub(1),
            b',' => values += 1,
            _ => {}
        }
    }
    check_values(field, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nested(depth: usize) -> String {
        "[".repeat(depth) + &"]".repeat(depth)
    }

    #[test]
    fn sixty_four_levels_are_read_and_one_more_is_refused() {
        assert_eq!(check_json("scene", &nested(DEPTH)), Ok(()));
        let error = check_json("scene", &nested(DEPTH + 1)).unwrap_err();
        assert_eq!(error.to_string(), "scene: nesting deeper than 64 levels is not allowed; it must be at most 64 levels deep");
    }

    #[test]
    fn brackets_in_texts_and_beside_each_other_are_not_nested() {
        let text = format!(r#"{{"a\"{0}": "{0}\\", "b": [{1}]}}"#, "[".repeat(100), "[],".repeat(100));
        assert_eq!(check_json("scene", &text), Ok(()));
    }

    #[test]
    fn whole_numbers_are_those_that_javascript_holds() {
        assert_eq!(read_whole("at", "9007199254740991"), check_whole("at", WHOLE));
        for text in ["9007199254740992", "99999999999999999999", "-1", "1.5", "1e3", ""] {
            let error = read_whole("at", text).unwrap_err();
            assert_eq!((error.field(), error.value(), &*error.allowed()), ("at", text, "a whole number from 0 to 9007199254740991"));
        }
        assert_eq!(check_whole("seed", WHOLE + 1).unwrap_err().value(), "9007199254740992");
    }

    #[test]
    fn members_have_so_much_memory() {
        assert_eq!(check_members("population", 4, MEMBERS_BYTES / 4), Ok(()));
        let error = check_members("population", 5, MEMBERS_BYTES / 4).unwrap_err();
        assert_eq!(
            (error.field(), error.value(), &*error.allowed()),
            ("population", "5", "at most 4 where each takes 134217728 bytes of memory")
        );
    }

    #[test]
    fn too_many_values_and_bytes_are_refused() {
        assert_eq!(check_json("scene", &",".repeat(VALUES - 1)), Ok(()));
        assert_eq!(check_json("scene", &",".repeat(VALUES)).unwrap_err().value(), "more than 8000000 values");
        assert_eq!(check_json("scene", &" ".repeat(FILE_BYTES + 1)).unwrap_err().allowed(), "at most 67108864 bytes");
    }
}
