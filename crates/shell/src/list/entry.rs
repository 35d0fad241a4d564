//! One entry of `forage list --json`, with the same fields in the same order.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::registry::registry;

#[derive(Deserialize)]
struct Named {
    name: String,
}

/// The entry of this name, which must be known.
pub(super) fn json(name: &str) -> String {
    let text = serde_json::to_string_pretty(&registry().catalogue()).unwrap_or_default();
    let Ok(parts) = serde_json::from_str::<BTreeMap<&str, &RawValue>>(&text) else { return text };
    if registry().follower(name).is_ok() {
        return parts.get(name).map_or(String::new(), |follower| outdented(follower, 2));
    }
    let lists = ["planners", "generators", "scenes"].into_iter().filter_map(|list| parts.get(list));
    let mut entries = lists.flat_map(|list| serde_json::from_str::<Vec<&RawValue>>(list.get()).unwrap_or_default());
    let entry = entries.find(|entry| serde_json::from_str::<Named>(entry.get()).is_ok_and(|entry| entry.name == name));
    entry.map_or(String::new(), |entry| outdented(entry, 4))
}

/// Removes the spaces in front of lines that come from where the entry stands.
fn outdented(entry: &RawValue, spaces: usize) -> String {
    entry.get().replace(&format!("\n{}", " ".repeat(spaces)), "\n")
}
