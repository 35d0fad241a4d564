//! What there is to know of a planner before it runs: its entry, parameters, readings, formulas and layers. Kinds of scene
//! have entries, too.
//!
//! Vocabulary only: planners and followers import from here, and nothing here depends on one of them.

mod color;
mod entry;
mod event;
mod follower;
mod formula;
mod layer;
pub mod layers;
mod look;
mod member;
mod preset;
mod reading;
mod scene_kind;

pub(crate) use color::Hex;
pub use color::{Color, Rgba};
pub use entry::{Entries, Entry, Start, Suggestion};
pub use event::{EventKind, Tone};
pub use follower::{Column, Follower};
pub use formula::{Formula, Scope};
pub use layer::{Layer, Shown, Weight};
pub use look::{Glyph, Look, Ramp};
pub use member::Member;
pub use preset::{PAPER, Preset, ROAD};
pub use reading::{CONVERGED, Group, Reading};
pub use scene_kind::{ReadScene, SceneKind};
