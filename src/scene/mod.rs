//! What is planned in: one file a kind, the scene file around them (`file`), the scenes that ship (`shipped`), other
//! programs' files ([`formats`]) and random scenes ([`generate`](mod@generate)).
//!
//! A [`Scene`] that exists is valid: its numbers are finite, start and goal are inside and free.

mod arm;
mod check;
mod discs;
mod endpoints;
mod file;
pub mod formats;
mod function;
pub mod generate;
mod grid;
mod moving;
mod reach;
mod shipped;
mod tour;

use std::sync::OnceLock;

use crate::{
    arm::ArmScene,
    exact::Exact,
    geometry::Bounds,
    kernel::{Error, Kind, Round, Solution, Verdict, Yardstick},
};

pub(crate) use arm::JOINED;
pub use arm::MAX_CUBOIDS;
pub use discs::{DiscsScene, MAX_DISCS};
pub use function::{Function, FunctionScene, MAX_DIMENSION};
pub use grid::{CONTACT, GridScene, MAX_EXACT_CELLS, MAX_GRID_STOPS, MAX_SIDE, Robot};
pub use moving::{Leg, MAX_MOVING, MAX_WAYPOINTS, Motion, Moving};
pub use shipped::{shipped, shipped_names};
pub use tour::{MAX_STOPS, TourScene};

/// What every scene file carries besides its content.
#[derive(Debug, Clone, PartialEq)]
pub struct Header {
    /// Short identifier, used in links and on the command line.
    pub name: String,
    /// A line for people.
    pub title: String,
    /// What should be known about it.
    pub note: Option<String>,
    /// Where it comes from.
    pub source: Option<String>,
    /// The unit of its lengths.
    pub units: Option<String>,
    /// The stored optimum; what results are measured by is computed anew, see [`Scene::exact`].
    pub exact: Option<serde_json::Value>,
    /// Figures published for it, as they stand in the file.
    pub published: Option<serde_json::Value>,
}

/// What is in a scene.
#[expect(clippy::large_enum_variant, reason = "scenes are few, and shared")]
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// See [`FunctionScene`].
    Function(FunctionScene),
    /// See [`DiscsScene`].
    Discs(DiscsScene),
    /// See [`GridScene`].
    Grid(GridScene),
    /// See [`TourScene`].
    Tour(TourScene),
    /// See [`ArmScene`].
    Arm(ArmScene),
}

/// A valid scene.
#[derive(Debug, Clone)]
pub struct Scene {
    header: Header,
    body: Body,
    exact: OnceLock<Option<Exact>>,
    exact_over_cells: OnceLock<Option<Exact>>,
    /// The shortest tours, by yardstick and by what their ends are.
    exact_tours: [[OnceLock<Option<Exact>>; Round::ALL.len()]; 2],
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.header == other.header && self.body == other.body
    }
}

impl Scene {
    /// A scene of checked parts.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong.
    pub fn new(header: Header, body: Body) -> Result<Self, Error> {
        if header.name.is_empty() || header.name.len() > 100 {
            return Err(Error::refused("name", format!("\"{}\"", header.name), "1 to 100 characters"));
        }
        match &body {
            Body::Function(scene) => scene.check()?,
            Body::Discs(scene) => scene.check()?,
            Body::Grid(scene) => scene.check()?,
            Body::Tour(scene) => scene.check(header.exact.as_ref())?,
            Body::Arm(scene) => scene.check()?,
        }
        Ok(Self { header, body, exact: OnceLock::new(), exact_over_cells: OnceLock::new(), exact_tours: Default::default() })
    }

    /// Name, title and where it comes from.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The content.
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The short identifier.
    pub fn name(&self) -> &str {
        &self.header.name
    }

    /// What it is made of.
    pub fn kind(&self) -> Kind {
        match self.body {
            Body::Function(_) => Kind::Function,
            Body::Discs(_) => Kind::Discs,
            Body::Grid(_) => Kind::Grid,
            Body::Tour(_) => Kind::Tour,
            Body::Arm(_) => Kind::Arm,
        }
    }

    /// Where a path in the plane begins and where it leads; `None` where there is none to find.
    pub fn ends(&self) -> Option<([f64; 2], [f64; 2])> {
        match &self.body {
            Body::Function(_) | Body::Tour(_) | Body::Arm(_) => None,
            Body::Discs(scene) => Some((scene.start, scene.goal)),
            Body::Grid(scene) => scene.ends().ok(),
        }
    }

    /// The exact shortest path, computed at the first call; `None` where there is no path to find.
    pub fn exact(&self) -> Option<&Exact> {
        self.exact
            .get_or_init(|| match &self.body {
                Body::Function(_) | Body::Tour(_) => None,
                Body::Discs(scene) => scene.exact(),
                Body::Grid(scene) => scene.exact(),
                Body::Arm(scene) => scene.exact(self.header.exact.as_ref()),
            })
            .as_ref()
    }

    /// The exact shortest way by a rule; the same as [`Scene::exact`] but for grids by [`Yardstick::Cells`].
    pub fn exact_by(&self, yardstick: Yardstick) -> Option<&Exact> {
        match (&self.body, yardstick) {
            (Body::Grid(scene), Yardstick::Cells) => self.exact_over_cells.get_or_init(|| scene.exact_over_cells()).as_ref(),
            _ => self.exact(),
        }
    }

    /// The exact shortest tour through a scene's stops, with ways between them by a rule; computed at the first call.
    /// `None` where there are no stops, where one cannot be reached, or where there are too many: of those the file's own
    /// optimum counts, if it has one for such tours.
    pub fn exact_tour(&self, yardstick: Yardstick, round: Round) -> Option<&Exact> {
        let compute = || match &self.body {
            Body::Grid(scene) => scene.exact_tour(yardstick, round),
            Body::Tour(scene) => scene.exact_tour(round, self.header.exact.as_ref()),
            _ => None,
        };
        let cell = &self.exact_tours[usize::from(yardstick == Yardstick::Cells)][round as usize];
        cell.get_or_init(compute).as_ref()
    }

    /// Where a tour calls; empty where there are no stops.
    pub fn stops(&self) -> Vec<[f64; 2]> {
        match &self.body {
            Body::Grid(scene) => scene.stops.clone(),
            Body::Tour(scene) => scene.places(),
            _ => Vec::new(),
        }
    }

    /// The same grid with another start and goal; what follows from its cells is shared.
    ///
    /// # Errors
    /// [`Error::Refused`] for every other kind, and for ends where the robot does not fit.
    pub fn between(&self, ends: [[f64; 2]; 2]) -> Result<Self, Error> {
        let header = Header { exact: None, published: None, ..self.header.clone() };
        Self::new(header, Body::Grid(self.grid()?.between(ends)))
    }

    /// A function's minimum; `None` where it is a path that is looked for.
    pub fn minimum(&self) -> Option<f64> {
        (self.kind() == Kind::Function).then_some(0.0)
    }

    /// The exact minimum of what is measured: the shortest length by a rule, or a function's minimum.
    pub fn optimum(&self, yardstick: Yardstick) -> Option<f64> {
        self.minimum().or_else(|| self.exact_by(yardstick).map(|exact| exact.length))
    }

    /// The grid in it.
    ///
    /// # Errors
    /// [`Error::Refused`] for every other kind.
    pub fn grid(&self) -> Result<&GridScene, Error> {
        match &self.body {
            Body::Grid(scene) => Ok(scene),
            _ => Err(Error::refused("kind", self.kind().name(), "grid")),
        }
    }

    /// The stops of a tour in it.
    ///
    /// # Errors
    /// [`Error::Refused`] for every other kind.
    pub fn tour(&self) -> Result<&TourScene, Error> {
        match &self.body {
            Body::Tour(scene) => Ok(scene),
            _ => Err(Error::refused("kind", self.kind().name(), "tour")),
        }
    }

    /// The arm and its workspace in it.
    ///
    /// # Errors
    /// [`Error::Refused`] for every other kind.
    pub fn arm(&self) -> Result<&ArmScene, Error> {
        match &self.body {
            Body::Arm(scene) => Ok(scene),
            _ => Err(Error::refused("kind", self.kind().name(), "arm")),
        }
    }

    /// Whether the robot can go straight from one point of the plane to another; it may touch.
    pub fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        match &self.body {
            Body::Function(_) | Body::Tour(_) | Body::Arm(_) => true,
            Body::Discs(scene) => scene.discs.iter().all(|disc| disc.clearance_of_segment(a, b) >= 0.0),
            Body::Grid(scene) => scene.field().is_free(a, b),
        }
    }

    /// Measures and checks a solution.
    pub fn judge(&self, solution: &Solution) -> Verdict {
        match (&self.body, solution) {
            (Body::Discs(scene), Solution::Path(path)) => scene.judge(path),
            (Body::Grid(scene), Solution::Path(path)) => scene.judge(path),
            (Body::Grid(scene), Solution::Tour { order, round, path }) => scene.judge_tour(order, *round, path),
            (Body::Grid(scene), Solution::Drive(track)) => scene.judge_drive(track),
            (Body::Tour(scene), solution) => scene.judge(solution),
            (Body::Arm(scene), solution) => scene.judge(solution),
            _ => Verdict { length: None, feasible: true, clearance: None },
        }
    }

    /// The part of the plane that a picture should show: lower left and upper right corner.
    pub fn view(&self) -> Bounds {
        match &self.body {
            Body::Function(scene) => scene.view(),
            Body::Discs(scene) => scene.view(),
            Body::Grid(scene) => scene.bounds(),
            Body::Tour(scene) => scene.view(),
            Body::Arm(scene) => scene.view(),
        }
    }
}
