//! The look of layers, as data that the page's stages, the legend and the shell's pictures share.

use serde::{Serialize, Serializer};

use crate::kernel::Shape;

use super::{Color, Rgba};

/// The look of a layer. Lengths are in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(as = "LookView"))]
pub struct Look {
    /// The colour of lines and points.
    pub color: Color,
    /// The colour of what a disc, a band, a robot or a sign covers.
    pub fill: Option<Color>,
    /// The width of lines.
    pub width: f64,
    /// The diameter of a point.
    pub point: f64,
    /// The opacity of a weight of 0 and of a weight of 1: 0 is invisible, 1 covers what lies beneath.
    pub opacity: [f64; 2],
    /// Layers of a higher order are drawn later. Results have 40, the robot 48, the marks of an explanation 49 and more.
    pub order: i16,
    /// Lengths of dashes and gaps, in turn; empty: solid.
    pub dash: &'static [f64],
    /// The form of its points, so that colour is not the only distinction.
    pub glyph: Glyph,
    /// The colours of a field's values.
    pub ramp: Option<&'static Ramp>,
    /// The width of lines of weight 1, where those of weight 0 have `width`. 0: all lines have `width`.
    pub swell: f64,
    /// Whether it has fine details: drawn for the visible part of the plane only.
    pub near: bool,
    /// Whether a rim separates it from what lies beneath.
    pub lifted: bool,
    /// How its vertices belong together, for a legend; `None` if that depends on the scene.
    pub shape: Option<Shape>,
    /// The rank among the layers that show the planner's result; 0: it shows none. The one with the highest rank shows the
    /// final path, the others how it came about.
    pub result: u8,
}

impl Look {
    /// Thin, grey lines and small points: the default that other looks differ from.
    pub const PLAIN: Self = Self {
        color: Color::named("ink-2"),
        fill: None,
        width: 1.0,
        point: 3.0,
        opacity: [1.0, 1.0],
        order: 20,
        dash: &[],
        glyph: Glyph::Dot,
        ramp: None,
        swell: 0.0,
        near: false,
        lifted: false,
        shape: None,
        result: 0,
    };

    /// The opacity of a weight.
    pub fn opacity_at(&self, weight: f64) -> f64 {
        let [best, worst] = self.opacity;
        best + weight.clamp(0.0, 1.0) * (worst - best)
    }
}

/// What is as in [`Look::PLAIN`] is left out, except colour, width, point, order and opacity.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Look", optional_fields))]
struct LookView {
    /// Of lines and points.
    color: Color,
    /// Of what a disc, a band, a robot or a sign covers.
    #[serde(skip_serializing_if = "Option::is_none")]
    fill: Option<Color>,
    /// Of lines.
    width: f64,
    /// The diameter of a point.
    point: f64,
    /// Layers of a higher order are drawn later.
    order: i16,
    /// The width of lines of weight 1, where those of weight 0 have `width`.
    #[serde(skip_serializing_if = "Option::is_none")]
    swell: Option<f64>,
    /// The rank among the layers that show the planner's result. The highest is what is handed over.
    #[serde(skip_serializing_if = "Option::is_none")]
    result: Option<u8>,
    /// Of a weight of 0, and of a weight of 1: from 0 (invisible) to 1.
    opacity: [f64; 2],
    /// Lengths of dashes and gaps, in turn. Absent: solid.
    #[serde(skip_serializing_if = "Option::is_none")]
    dash: Option<&'static [f64]>,
    /// A form of its own, so that colour is not the only distinction. Absent: plain.
    #[serde(skip_serializing_if = "Option::is_none")]
    glyph: Option<Glyph>,
    /// How its vertices belong together, if that does not depend on the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<Shape>,
    /// Whether it has fine details: drawn only for the part of the plane that `lookAt` gives.
    #[serde(skip_serializing_if = "Option::is_none")]
    near: Option<bool>,
    /// Whether a rim separates it from what lies beneath.
    #[serde(skip_serializing_if = "Option::is_none")]
    lifted: Option<bool>,
    /// Whether the ramp is that of the values' square root.
    #[serde(skip_serializing_if = "Option::is_none")]
    root: Option<bool>,
    /// A field's colours: of its smallest value, the middle and the largest.
    #[serde(skip_serializing_if = "Option::is_none")]
    ramp: Option<[Color; 3]>,
}

impl Serialize for Look {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let &Self { color, fill, width, point, opacity, order, dash, glyph, ramp, swell, near, lifted, shape, result } = self;
        let set = |flag: bool| flag.then_some(true);
        let view = LookView {
            color,
            fill,
            width,
            point,
            order,
            swell: (swell != 0.0).then_some(swell),
            result: (result != 0).then_some(result),
            opacity,
            dash: (!dash.is_empty()).then_some(dash),
            glyph: (glyph != Glyph::Dot).then_some(glyph),
            shape,
            near: set(near),
            lifted: set(lifted),
            root: set(ramp.is_some_and(|ramp| ramp.root)),
            ramp: ramp.map(|ramp| ramp.colors),
        };
        view.serialize(serializer)
    }
}

/// The form of a layer's points or tubes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Glyph {
    /// Round and filled.
    #[cfg_attr(feature = "types", ts(skip))]
    Dot,
    /// A circle.
    Ring,
    /// A square on its corner.
    Diamond,
    /// A disc with its number in the tour or, without one, in the scene.
    Number,
    /// Lines with arrowheads.
    Arrow,
    /// A disc as large as its tube is wide: a moving obstacle.
    Disc,
    /// What a tube covers, shaded.
    Band,
    /// The rim of what a tube covers.
    Reach,
    /// A robot with its heading.
    Robot,
    /// A sign for an event.
    Event,
}

/// Colours of a field's values, from the smallest to the largest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// The colours of the smallest, the middle and the largest value.
    pub colors: [Color; 3],
    /// Whether the square root of the values is shown, which separates small ones.
    pub root: bool,
}

impl Ramp {
    /// The colours on a light or a dark ground.
    pub fn on(&self, dark: bool) -> [Rgba; 3] {
        self.colors.map(|color| color.on(dark))
    }
}
