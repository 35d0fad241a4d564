//! The glyphs of an SVG picture: the same forms and sizes as on the page's stage. All places are in pixels.

use std::fmt::{self, Display, Formatter, Write};

use crate::{
    describe::{Color, Glyph, Hex, Look, Rgba, Tone},
    geometry,
};

/// The width of the outline of rings and diamonds.
const OUTLINE: f64 = 2.0;
/// The width of the rim that separates a glyph from what lies beneath, beyond its outline.
const RIM: f64 = 3.0;
/// The side of an event's sign.
const EVENT: f64 = 14.0;
/// An obstacle's radius is at least this.
const OBSTACLE: f64 = 3.0;
/// A robot's radius is at least this.
const ROBOT: f64 = 8.0;
/// An arrowhead, along and to each side.
const HEAD: [f64; 2] = [5.0, 4.2];
/// A straight stretch of at least this length has an arrowhead, a long one several.
const LONG: f64 = 34.0;
/// The distance between arrowheads.
const APART: f64 = 130.0;
/// More arrowheads than about these would hide the line.
const MOST: f64 = 110.0;

/// Each tone's colour, outline and sign, on a square of 16. What calls for attention comes later. The page has the same in
/// `www/src/render/canvas/tones.ts`.
const TONES: [(Tone, Color, &str, &str); 5] = [
    (Tone::Plain, Color::named("ink-2"), "M8 4.5a3.5 3.5 0 1 1 0 7a3.5 3.5 0 1 1 0-7Z", ""),
    (Tone::Good, Color::named("accent"), "M8 1.5a6.5 6.5 0 1 1 0 13a6.5 6.5 0 1 1 0-13Z", "m5 8.3 2.1 2.1L11 6.2"),
    (Tone::Warning, Color::named("best"), "M8 1.8 14.8 14H1.2Z", "M8 6.2v3.6M8 11.8v.2"),
    (Tone::Decision, Color::named("robot"), "M8 1.2 14.8 8 8 14.8 1.2 8Z", "M5.8 8h4.4M8.4 6.1 10.3 8 8.4 9.9"),
    (Tone::Bad, Color::named("danger"), "M5.2 1.2h5.6l4 4v5.6l-4 4H5.2l-4-4V5.2Z", "m5.4 5.4 5.2 5.2M10.6 5.4l-5.2 5.2"),
];

/// What a glyph is drawn with.
pub(super) struct Ink {
    /// The layer's key, as a class.
    pub layer: &'static str,
    pub color: Hex,
    pub fill: Hex,
    /// The colour of the stage.
    pub ground: Hex,
    pub width: f64,
}

impl Ink {
    /// A ring or a diamond of this diameter.
    pub fn outline(&self, glyph: Glyph, [x, y]: [f64; 2], diameter: f64) -> String {
        let Self { layer, color, .. } = self;
        let half = diameter / 2.0;
        let line = Px(OUTLINE);
        if glyph == Glyph::Diamond {
            let corners = diamond([x, y], half + 1.0);
            return format!(r#"<path class="{layer}" d="{corners}" stroke="{color}" stroke-width="{line}"/>"#);
        }
        let [x, y, half] = [x, y, half].map(Px);
        format!(r#"<circle class="{layer}" cx="{x}" cy="{y}" r="{half}" stroke="{color}" stroke-width="{line}"/>"#)
    }

    /// A diamond that a rim separates from what lies beneath.
    pub fn lifted_diamond(&self, at: [f64; 2], diameter: f64) -> String {
        let Self { layer, color, ground, width, .. } = self;
        let (corners, rim, width) = (diamond(at, diameter / 2.0), Px(width + RIM), Px(*width));
        format!(
            r#"<path d="{corners}" stroke="{ground}" stroke-width="{rim}"/>
<path class="{layer}" d="{corners}" fill="{ground}" stroke="{color}" stroke-width="{width}"/>"#
        )
    }

    /// A disc with a hatch and a rim.
    pub fn disc(&self, [x, y]: [f64; 2], radius: f64) -> String {
        let Self { layer, color, fill, ground, width } = self;
        let [x, y, r, rim, width] = [x, y, radius.max(OBSTACLE), width + RIM, *width].map(Px);
        format!(
            r#"<circle cx="{x}" cy="{y}" r="{r}" fill="{fill}" stroke="{ground}" stroke-width="{rim}" paint-order="stroke"/>
<circle class="{layer}" cx="{x}" cy="{y}" r="{r}" fill="url(#hatch-{layer})" stroke="{color}" stroke-width="{width}"/>"#
        )
    }

    /// The rim of a disc.
    pub fn reach(&self, [x, y]: [f64; 2], radius: f64, look: &Look) -> String {
        let Self { layer, color, width, .. } = self;
        let ([x, y, radius, width, opacity], dashes) = ([x, y, radius, *width, look.opacity[0]].map(Px), Dashes(look.dash));
        format!(
            r#"<circle class="{layer}" cx="{x}" cy="{y}" r="{radius}" stroke="{color}" stroke-width="{width}" stroke-opacity="{opacity}"{dashes}/>"#
        )
    }

    /// A robot on two wheels, with an arrowhead in the direction of its heading, a unit vector; `None`: with a dot.
    pub fn robot(&self, [x, y]: [f64; 2], radius: f64, heading: Option<[f64; 2]>) -> String {
        let Self { layer, color, fill, ground, width } = self;
        let r = rounded(radius.max(ROBOT));
        let [dx, dy] = heading.unwrap_or([1.0, 0.0]).map(rounded);
        let of = |share: f64| Px(share * r);
        let (left, long, wide, round) = (of(-0.475), of(0.95), of(0.34), of(0.17));
        let wheel = |top: f64| format!(r#"<rect x="{left}" y="{}" width="{long}" height="{wide}" rx="{round}"/>"#, of(top));
        let wheels = wheel(-1.17) + &wheel(0.83);
        let head = match heading {
            Some(_) => format!("M{} 0 {} {} {} 0 {} {}Z", of(0.74), of(-0.42), of(0.52), of(-0.16), of(-0.42), of(-0.52)),
            None => format!("M{0} 0A{0} {0} 0 1 1 {1} 0A{0} {0} 0 1 1 {0} 0Z", of(0.35), of(-0.35)),
        };
        let [x, y, dx, dy, against, r, width] = [x, y, dx, dy, -dy, r, *width].map(Px);
        format!(
            r#"<g class="{layer}" transform="matrix({dx} {dy} {against} {dx} {x} {y})">
<g stroke="{ground}" stroke-width="4">{wheels}<circle r="{r}"/></g>
<g fill="{color}">{wheels}</g>
<circle r="{r}" fill="{fill}" stroke="{color}" stroke-width="{width}"/>
<path d="{head}" fill="{color}"/>
</g>"#
        )
    }

    /// Arrowheads that say in which direction a line goes.
    pub fn arrows(&self, places: &[[f64; 2]]) -> String {
        let apart = (geometry::length(places) / MOST).max(APART);
        let long = LONG.max(apart / 5.0);
        let mut heads = String::new();
        // Where all stretches are short, there is still one every so often.
        let mut since = apart / 2.0;
        let mut from = 0;
        for to in 1..places.len() {
            let (a, b) = (places[from], places[to]);
            // Steps in one direction are one stretch.
            if places.get(to + 1).is_some_and(|&next| is_straight(a, b, next)) {
                continue;
            }
            let stretch = geometry::length(&[a, b]);
            let due = if stretch >= long {
                (stretch / apart).round().max(1.0)
            } else {
                f64::from(u8::from(stretch > 2.0 * HEAD[0] && since + stretch / 2.0 >= 0.7 * apart))
            };
            let unit = [0, 1].map(|axis| (b[axis] - a[axis]) / stretch);
            for k in 0..due as usize {
                let along = (k as f64 + 0.5) / due * stretch;
                head(&mut heads, [0, 1].map(|axis| a[axis] + along * unit[axis]), unit);
            }
            since = if due > 0.0 { stretch / (2.0 * due) } else { since + stretch };
            from = to;
        }
        let Self { color, ground, .. } = self;
        format!(r#"<path d="{heads}" fill="{color}" stroke="{ground}" stroke-width="1.75" paint-order="stroke"/>"#)
    }

    /// A pattern of thin slanting lines, `url(#hatch-LAYER)`.
    pub fn hatch(&self) -> String {
        let Self { layer, color, .. } = self;
        format!(
            r#"<pattern id="hatch-{layer}" width="7" height="7" patternUnits="userSpaceOnUse"><path d="M-9 9 2-2M-2 9 9-2M5 9 16-2" stroke="{color}" stroke-width="1.1"/></pattern>"#
        )
    }
}

/// The signs of events, by their tones: what calls for attention lies on top.
pub(super) fn events(layer: &str, events: &[([f64; 2], Tone)], ground: &Hex, dark: bool) -> String {
    let mut out = String::new();
    for (tone, color, outline, sign) in &TONES {
        let color = Hex(opaque(color.on(dark)));
        for ([x, y], _) in events.iter().filter(|(_, of)| of == tone) {
            let [left, top] = [x - EVENT / 2.0, y - EVENT / 2.0].map(Px);
            let _ = writeln!(
                out,
                r#"<g class="{layer}" transform="translate({left} {top}) scale({})">
<path d="{outline}" stroke="{ground}" stroke-width="5"/><path d="{outline}" fill="{color}" stroke="{color}" stroke-width="1.2"/><path d="{sign}" stroke="{ground}" stroke-width="1.7"/>
</g>"#,
                Px(EVENT / 16.0)
            );
        }
    }
    out
}

fn diamond([x, y]: [f64; 2], half: f64) -> String {
    let [left, top, right, bottom, x, y] = [x - half, y - half, x + half, y + half, x, y].map(Px);
    format!("M{x} {top} {right} {y} {x} {bottom} {left} {y}Z")
}

fn head(out: &mut String, [x, y]: [f64; 2], [dx, dy]: [f64; 2]) {
    let [along, aside] = HEAD;
    let corner = |along: f64, aside: f64| format!("{} {}", Px(x + along * dx - aside * dy), Px(y + along * dy + aside * dx));
    let _ = write!(out, "M{} {} {}Z", corner(along, 0.0), corner(-along, aside), corner(-along, -aside));
}

fn is_straight(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    let ([ux, uy], [vx, vy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    (ux * vy - uy * vx).abs() < 1e-3 * geometry::length(&[a, b]) * geometry::length(&[b, c]) && ux * vx + uy * vy > 0.0
}

/// The attribute that says how a line is dashed, if it is.
pub(super) struct Dashes(pub &'static [f64]);

impl Display for Dashes {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        for (i, length) in self.0.iter().enumerate() {
            write!(out, "{}{}", if i == 0 { r#" stroke-dasharray=""# } else { " " }, Px(*length))?;
        }
        out.write_str(if self.0.is_empty() { "" } else { "\"" })
    }
}

pub(super) const fn opaque([red, green, blue, _]: Rgba) -> Rgba {
    [red, green, blue, 255]
}

/// To a hundredth of a pixel, and never −0.
pub(super) fn rounded(pixels: f64) -> f64 {
    (pixels * 100.0).round() / 100.0 + 0.0
}

/// A number to a hundredth, as it is written in a picture. Writing one with all of its digits takes tables, which would be in the download.
#[derive(Clone, Copy)]
pub(super) struct Px(pub f64);

impl Display for Px {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let hundredths = (self.0.abs() * 100.0).round() as u64;
        let (whole, rest) = (hundredths / 100, hundredths % 100);
        if self.0 < 0.0 && hundredths > 0 {
            out.write_str("-")?;
        }
        match (rest, rest % 10) {
            (0, _) => write!(out, "{whole}"),
            (_, 0) => write!(out, "{whole}.{}", rest / 10),
            _ => write!(out, "{whole}.{rest:02}"),
        }
    }
}
