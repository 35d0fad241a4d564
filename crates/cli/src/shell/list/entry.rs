//! One entry of `forage list --json`, with the same fields in the same order.

use forage::catalogue::catalogue;
use serde::Deserialize;
use serde_json::value::RawValue;

/// The parts of the catalogue that have pages.
#[derive(Deserialize)]
struct Parts<'a> {
    #[serde(borrow)]
    planners: Vec<&'a RawValue>,
    #[serde(borrow)]
    generators: Vec<&'a RawValue>,
    #[serde(borrow)]
    scenes: Vec<&'a RawValue>,
    #[serde(borrow)]
    drive: &'a RawValue,
    #[serde(borrow)]
    motion: &'a RawValue,
}

#[derive(Deserialize)]
struct Named {
    name: String,
}

/// The entry of this name, which must be known.
pub(super) fn json(name: &str) -> String {
    let text = serde_json::to_string_pretty(&catalogue()).unwrap_or_default();
    let Ok(parts) = serde_json::from_str::<Parts>(&text) else { return text };
    match name {
        "drive" => return outdented(parts.drive, 2),
        "motion" => return outdented(parts.motion, 2),
        _ => {}
    }
    let mut entries = parts.planners.into_iter().chain(parts.generators).chain(parts.scenes);
    let entry = entries.find(|entry| serde_json::from_str::<Named>(entry.get()).is_ok_and(|entry| entry.name == name));
    entry.map_or(String::new(), |entry| outdented(entry, 4))
}

/// Removes the spaces in front of lines that come from where the entry stands.
fn outdented(entry: &RawValue, spaces: usize) -> String {
    entry.get().replace(&format!("\n{}", " ".repeat(spaces)), "\n")
}
