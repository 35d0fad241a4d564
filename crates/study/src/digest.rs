//! The digest at the end of each row: of all that stands in front of it, of the scene if it is a sweep's, and of this program's version.
//!
//! A row that was changed, cut, put together from others or made from something else does not fit its digest; it is no proof
//! against somebody who computes a digest, too: `--verify` runs rows again.

use csv::StringRecord;
use forage::{
    Scene,
    kernel::{Digest, Message},
    message,
};

/// The program's version, which is part of each digest.
pub(super) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// How many digits it has.
pub(super) const DIGITS: usize = 16;

/// What the rows of a scene come from besides what stands in them: also of which columns that is.
pub(super) fn origin(scene: &Scene, columns: &[String]) -> Digest {
    let mut digest = Digest::default();
    add(&mut digest, VERSION.as_bytes());
    columns.iter().for_each(|column| add(&mut digest, column.as_bytes()));
    add(&mut digest, scene.to_json().as_bytes());
    digest
}

/// The digest of what stands in front of it in a row.
pub(super) fn of(origin: &Digest, row: &[u8]) -> String {
    let mut digest = origin.clone();
    add(&mut digest, row);
    digest.hex()
}

/// The digest of cells in front of it, in columns of these names.
pub(super) fn of_cells<'a>(names: &StringRecord, cells: impl IntoIterator<Item = &'a str>) -> String {
    let mut digest = Digest::default();
    add(&mut digest, VERSION.as_bytes());
    names.iter().for_each(|name| add(&mut digest, name.as_bytes()));
    cells.into_iter().for_each(|cell| add(&mut digest, cell.as_bytes()));
    digest.hex()
}

/// What is wrong with a row that does not fit its digest.
pub(super) fn differs() -> Message {
    message!(
        "study-digest-differs",
        "it does not fit its digest: it was changed, or made by another version of forage than {version}, or on another scene",
        version = VERSION
    )
}

/// What is wrong with a file of rows that have none.
pub(super) fn missing() -> Message {
    message!(
        "study-no-digests",
        "its rows have no digests, by which changes are found: an earlier version of forage wrote it; this one is {version}",
        version = VERSION
    )
}

/// All bytes, and how many.
fn add(digest: &mut Digest, bytes: &[u8]) {
    for chunk in bytes.chunks(8) {
        let mut word = [0; 8];
        word[..chunk.len()].copy_from_slice(chunk);
        digest.word(u64::from_le_bytes(word));
    }
    digest.word(bytes.len() as u64);
}
