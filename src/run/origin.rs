//! What a run began with, so that it can begin again.

use std::sync::Arc;

use crate::{describe::Registry, kernel::Stepper};

pub(super) enum Origin {
    /// An entry of this registry starts it.
    Registry(Arc<Registry>),
    /// It was started elsewhere, and this is how it began.
    State(Stepper),
}
