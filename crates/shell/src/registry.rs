//! What the commands know: the registry that the program was started with, and planners by their code.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use forage::{Registry, describe::Entry};

static KNOWN: OnceLock<Arc<Registry>> = OnceLock::new();
/// The same with the planners that were brought since.
static MORE: Mutex<Option<&'static Arc<Registry>>> = Mutex::new(None);

/// Says, at the start of the program, what there is. Only the first call counts.
pub(super) fn know(registry: Registry) {
    KNOWN.get_or_init(|| Arc::new(registry));
}

/// What there is.
pub(super) fn registry() -> &'static Arc<Registry> {
    let more = *MORE.lock().unwrap_or_else(PoisonError::into_inner);
    more.unwrap_or_else(|| KNOWN.get_or_init(|| Arc::clone(forage::standard())))
}

/// Registers a planner of the user. It is kept as long as the program runs: there are as many as files that were named.
pub(super) fn register(entry: &'static Entry) {
    let all = Registry::clone(registry()).with(entry);
    *MORE.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::leak(Box::new(Arc::new(all))));
}
