//! A kind of scene from outside: an id, a body, a reader and an optimum, listed beside the kinds that ship.
#![cfg(not(target_arch = "wasm32"))]

use std::{
    f64::consts::FRAC_1_SQRT_2,
    sync::{
        Arc,
        atomic::{AtomicUsize, Ordering},
    },
};

use forage::{
    Error, Registry, Scene,
    describe::SceneKind,
    geometry::{self, Bounds, Disc},
    kernel::{Backdrop, Exact, Fields, Message, Plane, ReferenceOptimum, SceneBody, SceneKindId, Solution, Verdict},
    scene::{GridScene, grid},
    standard,
};
use serde_json::Value;

const ID: SceneKindId = SceneKindId("pond");

/// A round pond in the middle of a square; paths go round it.
struct Pond {
    radius: f64,
    side: f64,
}

static COMPUTED: AtomicUsize = AtomicUsize::new(0);

const KIND: SceneKind = SceneKind {
    id: ID,
    title: "ponds",
    read: |fields: &mut Fields| {
        let radius = fields.number("radius")?;
        let side = fields.optional_number("side")?.unwrap_or(10.0);
        Ok(Arc::new(Pond { radius, side }))
    },
    optimum: Some(|scene, _, _| {
        COMPUTED.fetch_add(1, Ordering::Relaxed);
        let pond = scene.get::<Pond>().ok()?;
        Some(Exact::way(2.0 * pond.side, vec![[0.0; 2], [0.0, pond.side], [pond.side; 2]]))
    }),
    shipped: &[],
};

impl SceneBody for Pond {
    fn kind_id() -> SceneKindId {
        ID
    }

    fn kind(&self) -> SceneKindId {
        ID
    }

    fn check(&self, _stored: Option<&Value>) -> Result<(), Error> {
        if self.radius > 0.0 && 2.0 * self.radius < self.side {
            return Ok(());
        }
        Err(Error::refused("radius", self.radius, Message::verbatim(format!("greater than 0, less than half of {}", self.side))))
    }

    fn judge(&self, solution: &Solution) -> Verdict {
        let Solution::Path(path) = solution else { return Verdict::NO_PATH };
        let feasible = path.windows(2).all(|w| self.is_free(w[0], w[1]));
        Verdict { length: Some(geometry::length(path)), feasible, clearance: None }
    }

    fn view(&self) -> Bounds {
        Bounds { min: [0.0; 2], max: [self.side; 2] }
    }

    fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        out.extend([("radius", Value::from(self.radius)), ("side", Value::from(self.side))]);
    }

    fn backdrop(&self, draw: &mut dyn FnMut(Backdrop)) {
        draw(Backdrop::Border(self.view()));
    }

    fn plane(&self) -> Option<&dyn Plane> {
        Some(self)
    }
}

impl Plane for Pond {
    fn ends(&self) -> Result<([f64; 2], [f64; 2]), Error> {
        Ok(([0.0; 2], [self.side; 2]))
    }

    fn bounds(&self) -> Bounds {
        self.view()
    }

    fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        Disc { center: [self.side / 2.0; 2], radius: self.radius }.clearance_of_segment(a, b) >= 0.0
    }
}

const TEXT: &str = r#"{
  "format": "forage-scene",
  "version": 1,
  "kind": "pond",
  "name": "p",
  "title": "P",
  "radius": 2.5,
  "side": 10.0,
  "published": {
    "length": 3
  }
}"#;

fn kinds() -> Vec<&'static SceneKind> {
    Registry::standard().with(&KIND).kinds().to_vec()
}

fn refused(kinds: &[&SceneKind], text: &str) -> [String; 3] {
    let error = Scene::read(kinds, text).unwrap_err();
    [error.field(), error.value(), &error.allowed()].map(str::to_owned)
}

#[test]
fn a_file_of_a_kind_from_outside_is_read_judged_and_written() {
    let scene = Scene::read(&kinds(), TEXT).unwrap();
    assert_eq!((scene.kind(), scene.name(), scene.ends()), (ID, "p", Some(([0.0; 2], [10.0; 2]))));
    let straight = scene.judge(&Solution::Path(vec![[0.0; 2], [10.0; 2]]));
    assert_eq!((straight.feasible, straight.length), (false, Some(20.0 * FRAC_1_SQRT_2)));
    assert!(scene.judge(&Solution::Path(vec![[0.0; 2], [0.0, 10.0], [10.0; 2]])).feasible);
    assert_eq!(scene.to_json(), TEXT);
    assert_eq!(Scene::read(&kinds(), &scene.to_json()).unwrap(), scene);
    assert_ne!(Scene::read(&kinds(), &TEXT.replace("2.5", "2.25")).unwrap(), scene);
    let mut backdrop = Vec::new();
    scene.body().backdrop(&mut |piece| backdrop.push(piece));
    assert_eq!(backdrop, [Backdrop::Border(scene.view())]);
}

#[test]
fn what_is_wrong_is_refused_by_name() {
    let unknown = ["kind", "\"pond\"", "one of discs, grid, tour, arm, function"];
    assert_eq!(refused(standard().kinds(), TEXT), unknown);
    assert_eq!(standard().read_scene(TEXT).unwrap_err().allowed(), unknown[2]);
    assert_eq!(refused(&[&KIND, &grid::KIND], &TEXT.replace("pond", "lake"))[2], "one of pond, grid");
    assert_eq!(refused(&kinds(), &TEXT.replace("2.5", "5")), ["radius", "5", "greater than 0, less than half of 10"]);
    assert_eq!(refused(&kinds(), &TEXT.replace("2.5", "\"wide\"")), ["radius", "\"wide\"", "a finite number"]);
    let [field, _, allowed] = refused(&kinds(), &TEXT.replace("\"side\"", "\"depth\": 3, \"side\""));
    assert!(field == "depth" && allowed.ends_with("published, radius, side"), "{allowed}");
}

#[test]
fn a_body_is_found_as_what_it_is_only() {
    let scene = Scene::read(&[&KIND], TEXT).unwrap();
    assert_eq!(scene.get::<Pond>().unwrap().radius.to_bits(), 2.5_f64.to_bits());
    assert_eq!(scene.share::<Pond>().unwrap().side.to_bits(), 10.0_f64.to_bits());
    let error = scene.get::<GridScene>().unwrap_err();
    assert_eq!((error.field(), error.value(), &*error.allowed()), ("kind", "pond", "grid"));
    assert_eq!(scene.share::<GridScene>().unwrap_err(), error);
    assert_eq!(scene.between([[0.0; 2]; 2]).unwrap_err(), error);
}

#[test]
fn an_optimum_is_computed_once_for_all_copies_of_a_scene() {
    let scene = Scene::read(&[&KIND], TEXT).unwrap();
    let copy = scene.clone();
    assert_eq!(COMPUTED.load(Ordering::Relaxed), 0);
    assert_eq!(copy.exact().map(|exact| exact.length), Some(20.0));
    assert_eq!(scene.optimum(ReferenceOptimum::AnyAngle), Some(20.0));
    assert_eq!(COMPUTED.load(Ordering::Relaxed), 1);
    let without = Scene::read(&[&SceneKind { optimum: None, ..KIND }], TEXT).unwrap();
    assert_eq!((without.exact(), COMPUTED.load(Ordering::Relaxed)), (None, 1));
}
