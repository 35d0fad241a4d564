//! Ctrl-C: once asks to stop, twice ends the program.

use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

/// Becomes true at the first Ctrl-C. Without a handler (none could be set) that one ends the program.
pub(super) fn flag() -> Arc<AtomicBool> {
    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    interrupted
}
