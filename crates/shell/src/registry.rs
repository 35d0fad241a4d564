//! What the commands know: the registry that the program was started with.

use std::sync::{Arc, OnceLock};

use forage::Registry;

static KNOWN: OnceLock<Arc<Registry>> = OnceLock::new();

/// Says, at the start of the program, what there is. Only the first call counts.
pub(super) fn know(registry: Registry) {
    KNOWN.get_or_init(|| Arc::new(registry));
}

/// What there is.
pub(super) fn registry() -> &'static Arc<Registry> {
    KNOWN.get_or_init(|| Arc::clone(forage::standard()))
}
