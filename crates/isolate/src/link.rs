//! Code in links: deflated, in base64url, behind the key `page.code`. What does not run it skips it, as all that begins with `page.`.

use base64ct::{Base64UrlUnpadded, Encoding};
use forage::{Error, kernel::Message, message};

use super::LONGEST;

const KEY: &str = "page.code=";

/// How many bytes a code may have in a link, deflated.
pub const MOST_IN_LINK: usize = 8192;

fn too_large(bytes: usize) -> Error {
    let found = message!("error-bytes", "a size of {n} bytes", n = bytes);
    Error::refused("code", found, message!("error-most-bytes", "at most {most} bytes", most = MOST_IN_LINK))
}

/// The link with a code; in the place of another one that it has.
///
/// # Errors
/// [`Error::Refused`] for `code`, where it has more than [`MOST_IN_LINK`] bytes deflated.
pub fn with_code(link: &str, code: &str) -> Result<String, Error> {
    let deflated = miniz_oxide::deflate::compress_to_vec(code.as_bytes(), 9);
    if deflated.len() > MOST_IN_LINK {
        return Err(too_large(deflated.len()));
    }
    let kept: Vec<_> = link.split('&').filter(|part| !part.starts_with(KEY)).collect();
    Ok(format!("{}&{KEY}{}", kept.join("&"), Base64UrlUnpadded::encode_string(&deflated)))
}

/// The code in a link; `None` where it has none.
///
/// # Errors
/// [`Error::Refused`] for `code`, where it is too large; [`Error::Malformed`] where it is damaged.
pub fn code_in(link: &str) -> Result<Option<String>, Error> {
    let Some(packed) = packed_in(link) else { return Ok(None) };
    let damaged = |problem: String| Error::malformed("code", message!("isolate-damaged", "it is damaged: {problem}", problem));
    if packed.len() > MOST_IN_LINK / 3 * 4 + 4 {
        return Err(too_large(packed.len() / 4 * 3));
    }
    let deflated = Base64UrlUnpadded::decode_vec(packed).map_err(|error| damaged(error.to_string()))?;
    let bytes = miniz_oxide::inflate::decompress_to_vec_with_limit(&deflated, LONGEST).map_err(|error| damaged(error.to_string()))?;
    String::from_utf8(bytes).map(Some).map_err(|error| Error::malformed("code", Message::verbatim(error.to_string())))
}

/// Whether a link brings code, good or damaged.
pub fn carries_code(link: &str) -> bool {
    packed_in(link).is_some()
}

fn packed_in(link: &str) -> Option<&str> {
    link.split('&').find_map(|part| part.strip_prefix(KEY))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_goes_into_a_link_and_comes_out_again() {
        let link = "#v=1&planner=mine&scene=sphere&seed=1";
        assert_eq!(code_in(link).unwrap(), None);
        let first = with_code(link, "register({})").unwrap();
        let second = with_code(&first, "register({ name: 'ä' })").unwrap();
        assert_eq!(code_in(&second).unwrap().as_deref(), Some("register({ name: 'ä' })"));
        assert_eq!(second.matches(KEY).count(), 1);
    }

    #[test]
    fn what_is_too_large_or_damaged_is_refused() {
        // What cannot be deflated by much.
        let mut random = forage::kernel::rng::Stream::new(1, 0);
        let large: String = (0..18_000).map(|_| char::from(b' ' + (90.0 * random.unit()) as u8)).collect();
        assert_eq!(with_code("#v=1", &large).unwrap_err().field(), "code");
        for packed in ["!", "AAAA", &"A".repeat(20_000)] {
            assert_eq!(code_in(&format!("#v=1&{KEY}{packed}")).unwrap_err().field(), "code", "{packed}");
        }
    }
}
