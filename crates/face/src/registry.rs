//! What the module knows: its parts say so, and a call that needs one that is not here yet asks the host for it.

use std::{cell::RefCell, sync::Arc};

use js_sys::Function;
use wasm_bindgen::prelude::*;

use forage::{Error, Registry, describe::Entry, kernel::allowed};

use crate::convert::{js_error, js_error_as};

/// Entries that a part of a module adds to a registry.
pub type Entries = fn(Registry) -> Registry;

#[derive(Default)]
struct Known {
    parts: Vec<(u8, Entries)>,
    /// The texts of scenes that the host has brought.
    scenes: Vec<&'static str>,
    /// Planners that somebody has brought since.
    own: Vec<&'static Entry>,
    /// Kept for ever: runs hold on to it, and there are as many as a module has parts.
    registry: Option<&'static Arc<Registry>>,
    bring: Option<Function>,
}

thread_local!(static KNOWN: RefCell<Known> = RefCell::default());

/// Says what there is to run in a module: at its start, and once more for each part that is loaded later. Entries are offered
/// in the order of `rank`, whenever they came.
///
/// The face itself names no planner: a module holds what is listed here, and the linker drops the rest.
pub fn know(rank: u8, entries: Entries) {
    console_error_panic_hook::set_once();
    KNOWN.with_borrow_mut(|known| {
        // Behind all of its rank. To sort would bring in a sort.
        let at = known.parts.partition_point(|(other, _)| *other <= rank);
        known.parts.insert(at, (rank, entries));
        known.list();
    });
}

/// Adds a planner that somebody brings, in the place of one of the same name that was brought before.
pub(crate) fn know_own(entry: &'static Entry) {
    KNOWN.with_borrow_mut(|known| {
        known.own.push(entry);
        known.list();
    });
}

impl Known {
    fn list(&mut self) {
        let registry = self.parts.iter().fold(Registry::new(), |registry, (_, entries)| entries(registry));
        self.registry = Some(Box::leak(Box::new(Arc::new(registry.with_all(&self.own).with_scenes(&self.scenes)))));
    }
}

/// Adds scenes by the texts of their files: those that ship, where the module leaves them out.
#[wasm_bindgen(js_name = addScenes, skip_typescript)]
pub fn add_scenes(texts: Vec<String>) {
    KNOWN.with_borrow_mut(|known| {
        known.scenes.extend(texts.into_iter().map(|text| &*text.leak()));
        known.list();
    });
}

/// Sets who brings what is not here: a function of `planner`, `kind`, `scene`, `generator`, `follower`, `role` or `tool` and the
/// name of one. It returns true if it has loaded a part that may hold it, a text to say which part has to be loaded first, or
/// undefined where there is none.
#[wasm_bindgen(js_name = bringBy, skip_typescript)]
pub fn bring_by(bring: &Function) {
    KNOWN.with_borrow_mut(|known| known.bring = Some(bring.clone()));
}

/// What there is. One instance for all calls, until a part is added.
#[inline(never)]
pub(crate) fn registry() -> &'static Arc<Registry> {
    KNOWN.with_borrow_mut(|known| *known.registry.get_or_insert_with(|| Box::leak(Box::default())))
}

/// What is asked of the registry. A name that it does not know may be in a part that the host can bring: then it is asked again.
pub(crate) fn ask<T>(question: impl Fn(&'static Arc<Registry>) -> Result<T, Error>) -> Result<T, JsValue> {
    loop {
        match question(registry()) {
            Ok(answer) => return Ok(answer),
            Err(error) => match lacking(&error) {
                Some(name) if bring(error.field(), &name)? => {}
                _ => return Err(js_error(error)),
            },
        }
    }
}

/// The name that the registry does not know: what was asked for, or the kind of a scene that a text carries.
fn lacking(error: &Error) -> Option<String> {
    match error.code() {
        "unknown" => Some(error.value().to_owned()),
        "refused" if error.field() == "kind" => Some(error.value().strip_prefix('"')?.strip_suffix('"')?.to_owned()),
        _ => None,
    }
}

/// Whether the host has loaded a part that may hold this.
///
/// # Errors
/// An `Error` with the code `not-loaded`, where the part has to be loaded first.
#[inline(never)]
pub(crate) fn bring(field: &str, value: &str) -> Result<bool, JsValue> {
    let Some(bring) = KNOWN.with_borrow(|known| known.bring.clone()) else { return Ok(false) };
    let brought = bring.call2(&JsValue::UNDEFINED, &field.into(), &value.into())?;
    match brought.as_string() {
        Some(part) => Err(js_error_as("not-loaded", Error::refused(field, value, allowed::loaded(&part)))),
        None => Ok(brought.is_truthy()),
    }
}
