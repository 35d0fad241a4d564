//! Scenes: a header, which all kinds share, and a body of one kind.

use std::{
    any::Any,
    fmt,
    sync::{Arc, OnceLock},
};

use serde_json::Value;

use crate::{geometry::Bounds, message};

use super::{
    Error, Exact, Message, Minimum, ReferenceOptimum, Solution, TourEnds, json,
    scene_body::{Plane, SceneBody, SceneKindId, Verdict},
};

/// Computes an exact optimum of a scene: the shortest path by a rule, or the shortest tour with such ends. `None` if there is
/// none, or if it would take too long.
pub type Optimum = fn(&Scene, ReferenceOptimum, Option<TourEnds>) -> Option<Exact>;

/// What every scene file carries besides its content.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(optional_fields))]
pub struct Header {
    /// Short identifier, used in links and on the command line.
    pub name: String,
    /// A line for people.
    pub title: String,
    /// A remark, e.g. which parts are reconstructed.
    pub note: Option<String>,
    /// The source of its data.
    pub source: Option<String>,
    /// The unit of its lengths.
    pub units: Option<String>,
    /// The optimum stated in the file; results are measured against the computed one, see [`Scene::exact`].
    #[cfg_attr(
        feature = "types",
        ts(optional, type = "{ length?: number; order?: number[]; tip_length?: number; straight?: number; [also: string]: unknown }")
    )]
    pub exact: Option<Value>,
    /// Published values for it, as in the file.
    #[cfg_attr(feature = "types", ts(optional, type = "Record<string, unknown>"))]
    pub published: Option<Value>,
}

impl Header {
    /// Name and title, and nothing else.
    pub fn named(name: impl Into<String>, title: impl Into<String>) -> Self {
        Self { name: name.into(), title: title.into(), note: None, source: None, units: None, exact: None, published: None }
    }
}

/// A valid scene. Copies share the body, and its optima once they are computed.
#[derive(Clone)]
pub struct Scene {
    header: Header,
    body: Arc<dyn SceneBody>,
    optimum: Option<Optimum>,
    optima: Arc<Optima>,
}

/// By the rule (from cell to cell or not), the shortest path and then the shortest tours by their ends.
type Optima = [[OnceLock<Option<Exact>>; 1 + TourEnds::ALL.len()]; 2];

impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Scene")
            .field("header", &self.header)
            .field("kind", &self.kind())
            .field("body", &self.written())
            .finish_non_exhaustive()
    }
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.header == other.header && self.kind() == other.kind() && self.written() == other.written()
    }
}

impl Scene {
    /// A scene of checked parts; `optimum` computes its exact optima, if they can be computed.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong.
    pub fn new(header: Header, body: Arc<dyn SceneBody>, optimum: Option<Optimum>) -> Result<Self, Error> {
        if header.name.is_empty() || header.name.len() > 100 {
            return Err(Error::refused("name", format!("\"{}\"", header.name), message!("scene-name", "1 to 100 characters")));
        }
        body.check(header.exact.as_ref())?;
        Ok(Self::unchecked(header, body, optimum))
    }

    pub(super) fn unchecked(header: Header, body: Arc<dyn SceneBody>, optimum: Option<Optimum>) -> Self {
        Self { header, body, optimum, optima: Arc::default() }
    }

    /// The same scene under another header.
    ///
    /// # Errors
    /// As [`Scene::new`].
    pub fn with_header(&self, header: Header) -> Result<Self, Error> {
        Self::new(header, Arc::clone(&self.body), self.optimum)
    }

    /// Name, title and where it comes from.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The content.
    pub fn body(&self) -> &dyn SceneBody {
        &*self.body
    }

    /// The short identifier.
    pub fn name(&self) -> &str {
        &self.header.name
    }

    /// Its kind.
    pub fn kind(&self) -> SceneKindId {
        self.body.kind()
    }

    /// The content as its own type.
    ///
    /// # Errors
    /// [`Error::Refused`] for `kind` if it is of another kind.
    pub fn get<B: SceneBody>(&self) -> Result<&B, Error> {
        (self.body() as &dyn Any).downcast_ref().ok_or_else(|| self.other_kind(B::kind_id()))
    }

    /// The content as its own type, shared, for planners that keep it.
    ///
    /// # Errors
    /// As [`Scene::get`].
    pub fn share<B: SceneBody>(&self) -> Result<Arc<B>, Error> {
        let body: Arc<dyn Any + Send + Sync> = Arc::<dyn SceneBody>::clone(&self.body);
        body.downcast().map_err(|_| self.other_kind(B::kind_id()))
    }

    #[cold]
    #[inline(never)]
    fn other_kind(&self, expected: SceneKindId) -> Error {
        Error::refused("kind", self.kind().name(), Message::verbatim(expected.name()))
    }

    /// The plane with obstacles that paths lead through, if it is one.
    pub fn plane(&self) -> Option<&dyn Plane> {
        self.body.plane()
    }

    /// Start and goal of a path in the plane; `None` if there is no path to find.
    pub fn ends(&self) -> Option<([f64; 2], [f64; 2])> {
        self.plane()?.ends().ok()
    }

    /// Whether the robot can go straight from one point of the plane to another; it may touch.
    pub fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        self.plane().is_none_or(|plane| plane.is_free(a, b))
    }

    /// The stops of a tour; empty if there are none.
    pub fn stops(&self) -> Vec<[f64; 2]> {
        self.body.stops().places
    }

    /// The same scene with another start and goal. What was computed from its obstacles is shared.
    ///
    /// # Errors
    /// [`Error::Refused`] for a kind that cannot change them, and for ends where the robot does not fit.
    pub fn between(&self, ends: [[f64; 2]; 2]) -> Result<Self, Error> {
        let header = Header { exact: None, published: None, ..self.header.clone() };
        Self::new(header, self.body.between(ends)?, self.optimum)
    }

    /// The exact shortest path, computed at the first call; `None` if there is no path to find.
    pub fn exact(&self) -> Option<&Exact> {
        self.exact_by(ReferenceOptimum::default())
    }

    /// The exact shortest path by a rule, computed at the first call.
    pub fn exact_by(&self, reference: ReferenceOptimum) -> Option<&Exact> {
        self.computed(reference, None)
    }

    /// The exact shortest tour through a scene's stops, with paths between them by a rule; computed at the first call. `None`
    /// without stops or if one cannot be reached. For too many stops it is the optimum stated in the scene file, if there is
    /// one for such tours.
    pub fn exact_tour(&self, reference: ReferenceOptimum, ends: TourEnds) -> Option<&Exact> {
        self.computed(reference, Some(ends))
    }

    fn computed(&self, reference: ReferenceOptimum, ends: Option<TourEnds>) -> Option<&Exact> {
        let optimum = self.optimum?;
        let by_rule = &self.optima[usize::from(reference == ReferenceOptimum::Cells)];
        by_rule[ends.map_or(0, |ends| 1 + ends as usize)].get_or_init(|| optimum(self, reference, ends)).as_ref()
    }

    /// The minimum of a function; `None` for other kinds, and where it is not known.
    pub fn minimum(&self) -> Option<Minimum> {
        self.body.minimum()
    }

    /// The exact optimum: the shortest length by a rule, or the minimum of a function.
    pub fn optimum(&self, reference: ReferenceOptimum) -> Option<f64> {
        self.minimum().map(|minimum| minimum.value).or_else(|| self.exact_by(reference).map(|exact| exact.length))
    }

    /// Measures and checks a solution.
    pub fn judge(&self, solution: &Solution) -> Verdict {
        self.body.judge(solution)
    }

    /// The part of the plane that a picture should show: lower left and upper right corner.
    pub fn view(&self) -> Bounds {
        self.body.view()
    }

    /// Kind and content on one line, without what the header has: name, title, notes, stored optimum, published figures.
    pub(crate) fn content(&self) -> String {
        let kind = ("kind", Value::from(self.kind().name()));
        json::object([kind].iter().chain(&self.written()).map(|(name, value)| (*name, value)))
    }

    /// The body's fields, in the order in which they are written.
    pub(super) fn written(&self) -> Vec<(&'static str, Value)> {
        let mut out = Vec::new();
        self.body.write(&mut out);
        out
    }
}
