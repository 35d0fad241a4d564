//! Links: made, taken apart and opened.

use std::sync::Arc;

use wasm_bindgen::prelude::*;

use forage::{Error, Link, Registry, run::Run};

use crate::{JsLinkSetup, JsText, Session, Trial, js_error, plain, read::read_text, registry::ask, tool::Tool};

struct Links {
    parse: fn(&Registry, &str) -> Result<Link, Error>,
    open: fn(&Arc<Registry>, &str) -> Result<Run, Error>,
    check: fn(&Run) -> Result<(), Error>,
    of: fn(&Run) -> Option<String>,
}

static LINKS: Tool<Links> = Tool::new("links");

/// Offers links.
pub fn offer_links() {
    LINKS.offer(&Links { parse: Link::parse, open: Run::from_link, check: Run::check_link, of: Run::link });
}

/// The link of a run; empty where nobody could open it.
fn link_of(run: &Run) -> Result<String, JsValue> {
    let links = LINKS.get()?;
    (links.check)(run).map_err(js_error)?;
    Ok((links.of)(run).unwrap_or_default())
}

/// Takes a link apart without running it.
///
/// # Errors
/// An `Error` that says what is wrong with it.
#[wasm_bindgen(js_name = parseLink)]
pub fn parse_link(link: &JsText) -> Result<JsLinkSetup, JsValue> {
    let text = read_text("link", link)?;
    let links = LINKS.get()?;
    plain(&ask(|registry| (links.parse)(registry, &text))?.contents())
}

#[wasm_bindgen]
impl Session {
    /// The run that a link describes, at iteration 0.
    ///
    /// # Errors
    /// As the constructor, and for a link that cannot be read.
    #[wasm_bindgen(js_name = fromLink)]
    pub fn from_link(link: &JsText) -> Result<Session, JsValue> {
        let text = read_text("link", link)?;
        let links = LINKS.get()?;
        ask(|registry| (links.open)(registry, &text)).map(Session::of)
    }

    /// A link that opens this very picture; begins with `#`. Empty within a step that is not over.
    ///
    /// # Errors
    /// Where the part with links is not loaded.
    pub fn link(&self) -> Result<String, JsValue> {
        link_of(&self.run)
    }
}

#[wasm_bindgen]
impl Trial {
    /// A link that opens the run at this iteration, in the page and in the shell; begins with `#`.
    ///
    /// # Errors
    /// Where the part with links is not loaded.
    pub fn link(&mut self) -> Result<String, JsValue> {
        link_of(self.0.run())
    }
}
