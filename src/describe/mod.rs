//! What there is to know of a planner before it runs: its entry, readings, formulas and layers. Kinds of scenes, generators
//! and followers of a path have entries, too; a [`Registry`] lists those that a build knows.
//!
//! Vocabulary only: planners and followers import from here, and nothing here depends on one of them.

mod case;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) mod catalogue;
#[cfg(not(target_arch = "wasm32"))]
mod centre_bias;
mod color;
mod entry;
mod event;
mod follower;
mod formula;
mod generator;
mod layer;
pub mod layers;
mod look;
mod member;
mod preset;
mod reading;
mod registry;
mod scene_kind;

pub use case::Case;
#[cfg(not(target_arch = "wasm32"))]
pub use catalogue::Catalogue;
#[cfg(not(target_arch = "wasm32"))]
pub use centre_bias::{CentreBias, Ratio};
pub(crate) use color::Hex;
pub use color::{Color, Rgba, color_at, read_color};
pub use entry::{Entries, Entry, Start, Suggestion};
pub use event::{EventKind, Tone};
pub use follower::{Column, Extra, Follow, FollowOutcome, FollowOutcomes, FollowedPath, Follower};
pub use formula::{Formula, Scope};
pub use generator::{Draft, Generator};
pub use layer::{Layer, Shown, Weight};
pub use look::{Glyph, Look, Ramp};
pub use member::Member;
pub use preset::{PAPER, Preset, ROAD};
pub use reading::{CONVERGED, Group, Reading};
pub use registry::{Listed, Registry};
pub use scene_kind::{ReadScene, SceneKind};
