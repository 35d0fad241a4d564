//! Ctrl-C: the first one asks the run to stop, the second one ends the program.

use std::sync::{
    Arc, OnceLock,
    atomic::{AtomicBool, Ordering},
};

/// Only one handler can be set, so there is one flag.
static INTERRUPTED: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// Becomes true at the first Ctrl-C. If no handler can be set, the first Ctrl-C ends the program.
pub(super) fn flag() -> Arc<AtomicBool> {
    let begin = || {
        let interrupted = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&interrupted);
        let _ = ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                std::process::exit(130);
            }
        });
        interrupted
    };
    Arc::clone(INTERRUPTED.get_or_init(begin))
}
