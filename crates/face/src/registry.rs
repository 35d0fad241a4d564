//! What the module knows: it says so at its start.

use std::sync::{Arc, OnceLock};

use forage::Registry;

static KNOWN: OnceLock<Arc<Registry>> = OnceLock::new();

/// Says, at the start of a module, what there is to run in it. Only the first call counts.
///
/// The face itself names no planner: a module holds what its registry lists, and the linker drops the rest.
pub fn know(registry: Registry) {
    console_error_panic_hook::set_once();
    KNOWN.get_or_init(|| Arc::new(registry));
}

/// What there is. One instance for all calls.
#[inline(never)]
pub(crate) fn registry() -> &'static Arc<Registry> {
    KNOWN.get_or_init(Arc::default)
}
