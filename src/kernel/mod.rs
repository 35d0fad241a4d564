//! The contract of planners and of scenes, and the data that it speaks of. Nothing here knows a planner or a kind of scene.

pub mod allowed;
pub mod digits;
pub mod error;
mod event;
mod facets;
pub mod fields;
mod frame;
pub(crate) mod inspection;
#[cfg(target_arch = "wasm32")]
pub mod javascript;
pub mod json;
pub mod limits;
pub mod message;
mod nowhere;
pub mod objective;
mod optimum;
pub(crate) mod part;
mod planner;
mod readings;
pub mod rng;
mod scene;
mod scene_body;
pub(crate) mod scene_file;
mod solution;
mod started;
mod state;
mod status;
mod subtask;

pub use error::Error;
pub use event::Event;
pub use facets::{Explain, Facets, Failure, Members, Recommend, Timeline};
pub use fields::Fields;
pub use frame::{Frame, LayerKey, Shape, Span, VERTEX};
pub use inspection::{Inspection, Item, Label, Mark, Quantity};
#[cfg(not(target_arch = "wasm32"))]
#[doc(hidden)]
pub use message::inventory;
pub use message::{Argument, Message, Sentence, words};
pub use optimum::{Exact, Minimum};
pub use part::Part;
pub use planner::{CloneBox, Planner, Progress};
pub use readings::{ReadingName, Readings};
pub use scene::{Header, Optimum, Scene};
pub use scene_body::{Backdrop, Plane, SceneBody, SceneKindId, Stops, Verdict};
pub use solution::{Border, Candidate, ReferenceOptimum, Solution, TourEnds, Track};
pub use started::{Answer, Started, Stepped, Stepper};
pub use state::{Digest, State};
pub use status::{Stage, Status};
pub use subtask::{Recommendation, Subtask, SubtaskResult, Subtasks};
