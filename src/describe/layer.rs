//! The layers that a planner draws.

use serde::{Serialize, Serializer};

use crate::{
    kernel::{LayerKey, SceneKindId, words},
    params::When,
};

use super::Look;

/// A layer that a planner draws, or that its explanations mark.
///
/// ```
/// use forage::{describe::{Color, Layer, Look, layers}, kernel::LayerKey};
/// const BEST: Layer = layers::BEST.titled("Shortest", "The shortest path so far: the result.");
/// const SCOUTS: LayerKey = LayerKey("scouts");
/// const LOOK: Look = Look { color: Color::new("#7a5c00", "#e8c95a"), width: 1.5, ..Look::PLAIN };
/// const LAYERS: &[Layer] = &[BEST, Layer::new(SCOUTS, "Scouts", "Ants that explore.", &LOOK).pickable()];
/// # assert!(LAYERS[1].pickable && LAYERS[0].look.result > 0);
/// ```
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Layer {
    /// The key that drawings use.
    #[serde(rename = "role")]
    pub key: LayerKey,
    /// The title in a legend.
    pub title: &'static str,
    /// A help text of one sentence.
    pub help: &'static str,
    /// When it is shown.
    #[serde(rename = "on", serialize_with = "is_on")]
    #[cfg_attr(feature = "types", ts(type = "boolean"))]
    pub shown: Shown,
    /// Whether its pieces can be inspected.
    pub pickable: bool,
    /// The parameter value with which there is something to draw; `None`: with any.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub when: Option<When>,
    /// The kinds of scene on which there is something to draw; empty: all that the planner runs on.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<SceneKindId>>"))]
    pub kinds: &'static [SceneKindId],
    /// The meaning of its vertices' weight.
    #[serde(skip_serializing_if = "Weight::is_none")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Weight>"))]
    pub weight: Weight,
    /// Its look.
    pub look: &'static Look,
}

impl Layer {
    /// A layer that is shown whatever the parameters are.
    pub const fn new(key: LayerKey, title: &'static str, help: &'static str, look: &'static Look) -> Self {
        Self {
            key,
            title: words(title),
            help: words(help),
            shown: Shown::On,
            pickable: false,
            when: None,
            kinds: &[],
            weight: Weight::None,
            look,
        }
    }

    /// The same with another title and help text.
    #[must_use]
    pub const fn titled(self, title: &'static str, help: &'static str) -> Self {
        Self { title: words(title), help: words(help), ..self }
    }

    /// The same with weights of this meaning.
    #[must_use]
    pub const fn weighted(self, weight: Weight) -> Self {
        Self { weight, ..self }
    }

    /// The same, hidden by default.
    #[must_use]
    pub const fn off(self) -> Self {
        Self { shown: Shown::Off, ..self }
    }

    /// The same, drawn by explanations only, never in a frame.
    #[must_use]
    pub const fn inspection(self) -> Self {
        Self { shown: Shown::Inspection, ..self }
    }

    /// The same with pieces that can be inspected.
    #[must_use]
    pub const fn pickable(self) -> Self {
        Self { pickable: true, ..self }
    }

    /// The same with something to draw only while a parameter has this value (`polar`, `true`).
    #[must_use]
    pub const fn when(self, parameter: &'static str, value: &'static str) -> Self {
        Self { when: Some(When { parameter, value }), ..self }
    }

    /// The same with something to draw only on these kinds of scene.
    #[must_use]
    pub const fn on_kinds(self, kinds: &'static [SceneKindId]) -> Self {
        Self { kinds, ..self }
    }
}

/// When a layer is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// By default.
    On,
    /// On request.
    Off,
    /// In an explanation only.
    Inspection,
}

/// The meaning of the weight of a layer's vertices.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Weight {
    /// Nothing: it is 0.
    #[cfg_attr(feature = "types", ts(skip))]
    None,
    /// How much worse than the iteration's best, from 0 (the best) toward 1.
    Rank,
    /// A share, from 0 to 1.
    Share,
    /// A length or a cost, in the scene's unit.
    Length,
    /// How much more pheromone than where no ant has been; below 0: there is no edge to hold any.
    Pheromone,
    /// A position in the best tour, from 0; −1: none.
    Place,
    /// Half the width of a tube, in the scene's unit.
    HalfWidth,
    /// Seconds since the start.
    Time,
    /// 1 for an ant that reached the goal, 0 for one that did not. Its path has a vertex for each step.
    Arrived,
}

impl Weight {
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
    fn is_none(&self) -> bool {
        *self == Self::None
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
fn is_on<S: Serializer>(shown: &Shown, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_bool(*shown == Shown::On)
}
