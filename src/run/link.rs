//! Links: a whole run in an address's fragment.
//!
//! `#v=1&planner=wcpso&scene=wcpso-discs&seed=7&p.w_max=0.8&at=120&hash=…`: the scene is a shipped name, or `~` and
//! the scene file deflated and written in base64url. Parameters that have their defaults are left out.

use std::{fmt, sync::Arc};

use base64ct::{Base64UrlUnpadded, Encoding};
use miniz_oxide::inflate::TINFLStatus;
use serde::Serialize;

use crate::{
    describe::Registry,
    kernel::{Error, Message, Scene, limits},
    message,
    params::{Overrides, Value},
};

use super::{setup::Setup, stepping::Run};

const VERSION: &str = "1";

/// A run at an iteration.
#[derive(Debug, Clone)]
pub struct Link {
    /// What is run.
    pub setup: Setup,
    /// The scene ships with the registry under its name, so that the link need not carry it.
    pub scene_ships: bool,
    /// How far.
    pub iteration: u64,
    /// The state's hash there.
    pub hash: Option<String>,
}

/// What a link says, without its scene's body in letters.
#[derive(Debug, Serialize)]
#[cfg_attr(
    feature = "types",
    derive(ts_rs::TS),
    ts(
        rename = "LinkSetup",
        type = "Configured & { scene: Scene; seed: number; iteration: number; /** The state's hash that the link promises. */ hash?: string }"
    )
)]
pub struct Contents<'a> {
    planner: &'a str,
    scene: &'a Scene,
    params: &'a Overrides,
    seed: u64,
    iteration: u64,
    /// The state's hash that the link promises.
    #[serde(skip_serializing_if = "Option::is_none")]
    hash: Option<&'a str>,
}

impl Link {
    /// What it says, to be serialised.
    pub fn contents(&self) -> Contents<'_> {
        let Setup { planner, scene, params, seed } = &self.setup;
        Contents { planner, scene, params, seed: *seed, iteration: self.iteration, hash: self.hash.as_deref() }
    }
}

impl fmt::Display for Link {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Setup { planner, scene, params, seed } = &self.setup;
        let scene = if self.scene_ships { scene.name().to_owned() } else { packed(scene) };
        write!(f, "#v={VERSION}&planner={planner}&scene={scene}&seed={seed}")?;
        for (name, value) in params.iter() {
            write!(f, "&p.{name}={value}")?;
        }
        write!(f, "&at={}", self.iteration)?;
        self.hash.iter().try_for_each(|hash| write!(f, "&hash={hash}"))
    }
}

impl Link {
    /// Whether a text looks like a link (rather than a file's name): it has a fragment that begins with `v=`.
    pub fn is_link(text: &str) -> bool {
        text.split_once('#').is_some_and(|(_, fragment)| fragment.starts_with("v="))
    }

    /// Takes a link apart: the fragment alone, or a whole address that ends in it. Keys that begin with `page.` say how a page shows
    /// the run, and are skipped.
    ///
    /// # Errors
    /// A message that says what is wrong: no fragment, another version, an unknown key, too long, or whatever [`Setup::check`] refuses.
    pub fn parse(registry: &Registry, text: &str) -> Result<Self, Error> {
        limits::check_bytes("link", text.len(), limits::LINK_BYTES)?;
        let wrong = |problem: Message| Error::malformed("link", problem);
        let (_, fragment) = text.trim().split_once('#').ok_or_else(|| wrong(message!("link-no-fragment", "it has no #…")))?;
        let (mut version, mut planner, mut scene, mut seed, mut iteration, mut hash) = (None, None, None, 1, 0, None);
        let mut params = Overrides::new();
        for (key, value) in fragment.split('&').filter_map(|pair| pair.split_once('=')) {
            match key {
                "v" => version = Some(value),
                "planner" => planner = Some(value.to_owned()),
                "scene" => scene = Some((unpacked(registry, value)?, !value.starts_with(PACKED))),
                "seed" => seed = limits::read_whole(key, value)?,
                "at" => iteration = limits::read_whole(key, value)?,
                "hash" => hash = Some(value.trim().to_owned()),
                _ if key.starts_with("page.") => {}
                _ => match key.strip_prefix("p.") {
                    Some(name) => params.insert(name, Value::from(value)),
                    None => {
                        return Err(wrong(message!(
                            "link-unknown-key",
                            "`{key}` means nothing in a link of version {version}",
                            key,
                            version = VERSION
                        )));
                    }
                },
            }
        }
        match version {
            Some(VERSION) => {}
            Some(other) => {
                return Err(wrong(message!(
                    "link-other-version",
                    "it is of version {other}, and this program reads version {version}",
                    other,
                    version = VERSION
                )));
            }
            None => return Err(wrong(message!("link-no-version", "it does not begin with #v="))),
        }
        let planner = planner.ok_or_else(|| wrong(message!("link-no-planner", "it names no planner")))?;
        let (scene, scene_ships) = scene.ok_or_else(|| wrong(message!("link-no-scene", "it names no scene")))?;
        let setup = Setup { planner, scene, params, seed };
        setup.check(registry)?;
        Ok(Self { setup, scene_ships, iteration, hash })
    }
}

impl Run {
    /// The run that a link describes, at its beginning.
    ///
    /// # Errors
    /// As [`Run::new`], and for a link that cannot be read.
    pub fn from_link(registry: &Arc<Registry>, link: &str) -> Result<Self, Error> {
        Self::new(registry, Link::parse(registry, link)?.setup)
    }

    /// Refuses a run on a scene that is code.
    ///
    /// # Errors
    /// [`Error::Refused`] for `scene`.
    pub fn check_link(&self) -> Result<(), Error> {
        if !self.scene().body().is_code() {
            return Ok(());
        }
        let found = message!("link-code", "one whose function is code");
        Err(Error::refused("scene", found, message!("link-no-code", "one with a named function or a formula: a link carries no code")))
    }

    /// A link that opens this very picture: planner, scene, changed parameters, seed, iteration and hash. `None` where nobody else could
    /// open it: if no registry lists the planner, where the scene is code, and within a step.
    pub fn link(&self) -> Option<String> {
        let registry = self.registry().filter(|_| !self.is_partly() && !self.scene().body().is_code())?;
        let setup = Setup {
            planner: self.entry().name.to_owned(),
            scene: Arc::clone(self.scene()),
            params: self.parameters().changed().clone(),
            seed: self.seed(),
        };
        let scene_ships = registry.scene(setup.scene.name()).is_ok_and(|known| known == setup.scene);
        Some(Link { setup, scene_ships, iteration: self.iteration(), hash: Some(self.hash()) }.to_string())
    }
}

/// What a packed scene begins with.
const PACKED: char = '~';

/// What the name of a scene begins with that a page keeps apart, for it is too large for a link.
const APART: char = '@';

/// The scene's file, deflated.
fn packed(scene: &Scene) -> String {
    let deflated = miniz_oxide::deflate::compress_to_vec(scene.to_compact_json().as_bytes(), 9);
    format!("{PACKED}{}", Base64UrlUnpadded::encode_string(&deflated))
}

fn unpacked(registry: &Registry, text: &str) -> Result<Arc<Scene>, Error> {
    if text.starts_with(APART) {
        return Err(Error::malformed("link", message!("link-scene-apart", "its scene was too large for it, and is in a file of its own")));
    }
    let Some(code) = text.strip_prefix(PACKED) else {
        return registry.scene(text);
    };
    let most = limits::LINK_BYTES;
    let too_large = || {
        Error::refused(
            "link",
            message!("link-large-scene", "a scene of more than {most} bytes", most),
            message!("link-most-bytes", "one of at most {most} bytes", most),
        )
    };
    let broken = |problem: &dyn fmt::Display| {
        Error::malformed("link", message!("link-damaged", "its scene is damaged: {problem}", problem = problem.to_string()))
    };
    let deflated = Base64UrlUnpadded::decode_vec(code).map_err(|e| broken(&e))?;
    let inflated = miniz_oxide::inflate::decompress_to_vec_with_limit(&deflated, limits::LINK_BYTES);
    let bytes = inflated.map_err(|e| if e.status == TINFLStatus::HasMoreOutput { too_large() } else { broken(&e) })?;
    let text = String::from_utf8(bytes).map_err(|e| broken(&e))?;
    registry.read_scene(&text).map(Arc::new)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{shipped, standard};

    fn link(scene: Arc<Scene>, scene_ships: bool) -> Link {
        let params = Overrides::from_iter([("w_max", Value::from(0.8)), ("penalty", Value::from("waypoints"))]);
        Link {
            setup: Setup { planner: "wcpso".to_owned(), scene, params, seed: 7 },
            scene_ships,
            iteration: 120,
            hash: Some("00ff".to_owned()),
        }
    }

    #[test]
    fn a_hash_has_no_spaces_about_it() {
        let text = "#v=1&planner=wcpso&hash= 00ff\u{c}&scene=wcpso-discs";
        assert_eq!(Link::parse(standard(), text).unwrap().hash.as_deref(), Some("00ff"));
    }

    #[test]
    fn a_shipped_scene_goes_by_name_and_an_edited_one_as_a_whole() {
        let plain = link(shipped("wcpso-discs").unwrap(), true);
        assert_eq!(plain.to_string(), "#v=1&planner=wcpso&scene=wcpso-discs&seed=7&p.penalty=waypoints&p.w_max=0.8&at=120&hash=00ff");
        let edited = standard().read_scene(&plain.setup.scene.to_json().replacen("9.0", "8.5", 2)).unwrap();
        assert_ne!(edited, *plain.setup.scene);
        let edited = link(Arc::new(edited), false);
        assert!(edited.to_string().contains("scene=~"));
        for link in [plain, edited] {
            let back = Link::parse(standard(), &format!("https://example.org/forage/{link}")).unwrap();
            assert_eq!(back.to_string(), link.to_string());
            assert_eq!(back.setup.scene, link.setup.scene);
        }
    }

    #[test]
    fn what_a_page_adds_to_a_link_is_skipped() {
        let plain = "#v=1&planner=wcpso&scene=wcpso-discs&seed=7&at=120";
        let added = "#v=1&page.item=particles.3&planner=wcpso&scene=wcpso-discs&seed=7&at=120&page.camera=1,2,0.5&page.layers=";
        let link = Link::parse(standard(), added).unwrap();
        assert_eq!(link.to_string(), Link::parse(standard(), plain).unwrap().to_string());
    }

    #[test]
    fn a_link_that_cannot_be_opened_says_why() {
        for (text, part) in [
            ("no fragment", "no #"),
            ("#v=2&planner=pso", "version 2"),
            ("#planner=pso", "#v="),
            ("#v=1&planner=pso", "no scene"),
            ("#v=1&scene=sphere", "no planner"),
            ("#v=1&colour=red", "colour"),
            ("#v=1&scene=moon", "moon"),
            ("#v=1&planner=nobody&scene=sphere", "nobody"),
            ("#v=1&planner=pso&scene=sphere&p.w=9", "w: 9"),
            ("#v=1&planner=pso&scene=sphere&seed=9007199254740992", "seed"),
            ("#v=1&scene=~!!", "damaged"),
            ("#v=1&planner=pso&scene=@0123456789abcdef", "a file of its own"),
            ("#v=1&scene=~AAAA", "damaged"),
            ("#v=1&seed=-1", "seed"),
            ("#v=1&planner=pso&scene=sphere&at=9007199254740992", "at: 9007199254740992"),
            ("#v=1&planner=pso&scene=sphere&at=-1", "at: -1"),
            ("#v=1&planner=pso&scene=sphere&at=NaN", "at: NaN"),
        ] {
            let message = Link::parse(standard(), text).unwrap_err().to_string();
            assert!(message.contains(part), "{text}: {message}");
        }
    }

    #[test]
    fn a_link_that_holds_too_much_is_refused() {
        let with = |scene: &str| {
            let deflated = miniz_oxide::deflate::compress_to_vec(scene.as_bytes(), 9);
            Link::parse(standard(), &format!("#v=1&planner=pso&scene=~{}", Base64UrlUnpadded::encode_string(&deflated))).unwrap_err()
        };
        let nested = |depth: usize| with(&format!("{}{}", "[".repeat(depth), "]".repeat(depth)));
        assert_eq!(nested(64).allowed(), "an object with format, version, kind, name, title, …");
        assert_eq!([nested(65), nested(6000)].map(|error| error.value().to_owned()), ["nesting deeper than 64 levels"; 2]);
        assert_eq!(with(&" ".repeat(limits::LINK_BYTES + 1)).value(), "a scene of more than 4194304 bytes");
        let long = format!("#v=1&planner={}", "a".repeat(limits::LINK_BYTES));
        assert_eq!(Link::parse(standard(), &long).unwrap_err().allowed(), "at most 4194304 bytes");
    }
}
