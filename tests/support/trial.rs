//! Tests that are made at run time: one for each planner.

use libtest_mimic::Trial;

/// A test with a name; it fails by panicking.
pub fn trial(name: impl Into<String>, check: impl FnOnce() + Send + 'static) -> Trial {
    Trial::test(name, move || {
        check();
        Ok(())
    })
}
