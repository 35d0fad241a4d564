//! What a module may offer besides runs. An export passes on to it, so that it is linked only where it is offered.

use std::sync::OnceLock;

use wasm_bindgen::JsValue;

use forage::Error;

use crate::{js_error, registry::bring};

/// The functions of a tool.
pub(crate) struct Tool<T: 'static> {
    name: &'static str,
    offered: OnceLock<&'static T>,
}

impl<T> Tool<T> {
    pub(crate) const fn new(name: &'static str) -> Self {
        Self { name, offered: OnceLock::new() }
    }

    pub(crate) fn offer(&self, functions: &'static T) {
        self.offered.get_or_init(|| functions);
    }

    /// # Errors
    /// An `Error` of the field `tool`, where no part of the module has it, or it is not loaded.
    pub(crate) fn get(&self) -> Result<&'static T, JsValue> {
        while self.offered.get().is_none() && bring("tool", self.name)? {}
        self.offered.get().copied().ok_or_else(|| js_error(Error::unknown("tool", self.name, [])))
    }
}
