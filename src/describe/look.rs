//! The look of layers, as data that the page's stages, the legend and the shell's pictures share.

use serde::{Serialize, Serializer, ser::SerializeStruct};

use crate::kernel::Shape;

use super::{Color, Rgba};

/// The look of a layer. Lengths are in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// What is as in [`Look::PLAIN`] is left out.
impl Serialize for Look {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Look", 13)?;
        let colors = [("color", Some(self.color)), ("fill", self.fill)];
        for (name, color) in colors.into_iter().filter_map(|(name, color)| Some((name, color?))) {
            out.serialize_field(name, &color)?;
        }
        let (order, result) = (f64::from(self.order), f64::from(self.result));
        let numbers = [("width", self.width), ("point", self.point), ("order", order), ("swell", self.swell), ("result", result)];
        for (name, number) in numbers.into_iter().filter(|&(_, number)| number != 0.0) {
            out.serialize_field(name, &number)?;
        }
        for (name, list) in [("opacity", &self.opacity[..]), ("dash", self.dash)].into_iter().filter(|(_, list)| !list.is_empty()) {
            out.serialize_field(name, list)?;
        }
        let words = [("glyph", self.glyph.name()), ("shape", self.shape.map_or("", Shape::name))];
        for (name, word) in words.into_iter().filter(|(_, word)| !word.is_empty()) {
            out.serialize_field(name, word)?;
        }
        let root = self.ramp.is_some_and(|ramp| ramp.root);
        for (name, flag) in [("near", self.near), ("lifted", self.lifted), ("root", root)].into_iter().filter(|&(_, flag)| flag) {
            out.serialize_field(name, &flag)?;
        }
        if let Some(ramp) = self.ramp {
            out.serialize_field("ramp", &ramp.colors[..])?;
        }
        out.end()
    }
}

/// The form of a layer's points or tubes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Glyph {
    /// Round and filled.
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

impl Glyph {
    /// The name in JavaScript; empty for [`Glyph::Dot`], the default.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dot => "",
            Self::Ring => "ring",
            Self::Diamond => "diamond",
            Self::Number => "number",
            Self::Arrow => "arrow",
            Self::Disc => "disc",
            Self::Band => "band",
            Self::Reach => "reach",
            Self::Robot => "robot",
            Self::Event => "event",
        }
    }
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
    /// The colour of a value, given as a share from 0 (the smallest) to 1 (the largest).
    pub fn at(&self, share: f64, dark: bool) -> Rgba {
        let share = share.clamp(0.0, 1.0);
        let along = 2.0 * if self.root { share.sqrt() } else { share };
        let i = (along as usize).min(1);
        let [from, to] = [i, i + 1].map(|k| self.colors[k].on(dark).map(f64::from));
        std::array::from_fn(|c| (from[c] + (along - i as f64) * (to[c] - from[c])) as u8)
    }
}
