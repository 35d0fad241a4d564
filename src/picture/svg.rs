//! A run as an SVG picture: for the shell's `--svg` and the page's export.

use std::fmt::{Display, Write};

use crate::{
    describe::{Color, Entry, Glyph, Hex, Layer, Look, Rgba, Tone, layers},
    geometry::{self, Bounds, YAxis},
    kernel::{Backdrop, Frame, LayerKey, Shape, Span, VERTEX},
    run::Run,
    scene::Scene,
};

use super::{
    glyph::{self, Dashes, Ink, Px, opaque, rounded},
    raster,
};

const STAGE: Color = Color::named("stage");
const EDGE: Color = Color::named("axis");
const DISC: [Color; 2] = [Color::named("disc"), Color::named("disc-edge")];
const WALL: Color = Color::named("wall");
const MARGIN_COLOR: Color = Color::named("margin");
const START: Color = Color::named("accent");
const GOAL: Color = Color::named("danger");
const INK: Color = Color::named("ink");
const UNNUMBERED: Color = Color::named("ink-2");

/// A result where a later one is handed over: how that came about.
const fn beneath(look: &Look) -> Look {
    Look { width: 1.5, opacity: [0.75, 0.75], dash: &[1.0, 4.0], ..*look }
}

/// The opacity of what a tube without a glyph covers.
const SHADE: f64 = 0.2;
/// The least opacity of a point: it has less ink than a line.
const FAINTEST_POINT: f64 = 0.65;
/// The radius of a field's values.
const FIELD_POINT: f64 = 2.6;
const SIZE: f64 = 900.0;
const MARGIN: f64 = 24.0;
/// Of more stops none has a number.
const NUMBERED: usize = 100;

/// The run's present state: the scene, these of the planner's layers, and the exact optimum if `exact` is among them.
pub fn svg(run: &Run, dark: bool, shown: &[LayerKey]) -> String {
    let view = run.scene().view();
    let (width, height) = (view.max[0] - view.min[0], view.max[1] - view.min[1]);
    let scale = (SIZE - 2.0 * MARGIN) / width.max(height);
    let down = run.scene().plane().is_some_and(|plane| plane.y_axis() == YAxis::Down);
    let top = if down { view.min[1] } else { view.max[1] };
    let canvas = Canvas { scale, left: view.min[0], top, up: if down { -1.0 } else { 1.0 }, dark, text: String::new() };
    canvas.picture(run, shown, [width, height].map(|side| rounded(side * scale + 2.0 * MARGIN)))
}

struct Canvas {
    scale: f64,
    left: f64,
    top: f64,
    /// 1 where y grows upwards, −1 where it grows downwards.
    up: f64,
    dark: bool,
    text: String,
}

/// Writing to a `String` cannot fail, so its `Result` says nothing.
macro_rules! put {
    ($canvas:expr, $($argument:tt)*) => {{ let _ = writeln!($canvas.text, $($argument)*); }};
}

impl Canvas {
    fn at(&self, point: [f64; 2]) -> [f64; 2] {
        self.place(point).map(rounded)
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [MARGIN + (x - self.left) * self.scale, MARGIN + self.up * (self.top - y) * self.scale]
    }

    fn tone(&self, color: Color) -> Hex {
        Hex(opaque(color.on(self.dark)))
    }

    fn picture(mut self, run: &Run, shown: &[LayerKey], [width, height]: [f64; 2]) -> String {
        let [width, height] = [width, height].map(Px);
        let title = format!("{} on {}, iteration {}", run.entry().title, run.scene().header().title, run.iteration());
        put!(
            self,
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" fill="none" stroke-linecap="round" stroke-linejoin="round">"#
        );
        put!(self, "<title>{}</title>", escaped(&title));
        put!(self, r#"<rect width="100%" height="100%" fill="{}"/>"#, self.tone(STAGE));
        self.obstacles(run.scene());
        let mut frame = Frame::default();
        run.draw(&mut frame, Frame::BUDGET / 4);
        self.layers(run, &frame, shown);
        self.text.push_str("</svg>\n");
        self.text
    }

    fn obstacles(&mut self, scene: &Scene) {
        let [fill, stroke] = DISC.map(|color| self.tone(color));
        let (wall, margin) = (self.tone(WALL), self.tone(MARGIN_COLOR));
        scene.body().backdrop(&mut |piece| match piece {
            Backdrop::Border(bounds) => self.frame_of(bounds),
            Backdrop::Disc(disc) => {
                let [x, y] = self.at(disc.center).map(Px);
                let radius = Px(disc.radius * self.scale);
                put!(self, r#"<circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}" stroke="{stroke}" stroke-width="1.2"/>"#);
            }
            Backdrop::Block(block) => self.rectangle(block, &format!(r#"fill="{fill}" stroke="{stroke}" stroke-width="1.2""#)),
            Backdrop::Cells(cells) => self.rectangle(cells, &format!(r#"fill="{wall}" stroke="{wall}" stroke-width="1""#)),
            // A line of twice the distance about the box is round at the corners.
            Backdrop::Margin(block, distance) => {
                let width = Px(2.0 * distance * self.scale);
                self.rectangle(block, &format!(r#"fill="{margin}" stroke="{margin}" stroke-width="{width}""#));
            }
        });
    }

    fn frame_of(&mut self, bounds: Bounds) {
        let tone = self.tone(EDGE);
        self.rectangle(bounds, &format!(r#"stroke="{tone}" stroke-width="1""#));
    }

    fn rectangle(&mut self, bounds: Bounds, look: &str) {
        let ([x0, y0], [x1, y1]) = (self.at(bounds.min), self.at(bounds.max));
        let [x, y, width, height] = [x0, y0.min(y1), x1 - x0, (y1 - y0).abs()].map(Px);
        put!(self, r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" {look}/>"#);
    }

    /// The layers in the order of their looks; events, start and goal, and then the robot lie on top.
    fn layers(&mut self, run: &Run, frame: &Frame, shown: &[LayerKey]) {
        let entry = run.entry();
        let with_layer = |span: Span| Some((span, entry.layer(span.layer).filter(|layer| shown.contains(&layer.key))?));
        let drawn: Vec<_> = frame.spans().filter_map(with_layer).collect();
        for layer in entry.layers.iter().filter(|layer| is_hatched(layer.look) && shown.contains(&layer.key)) {
            put!(self, "{}", self.ink(layer.key, layer.look).hatch());
        }
        let result = drawn.iter().map(|(_, layer)| layer.look.result).max();
        // A sort of its own would be larger in the wasm than all glyphs.
        let mut last = None;
        while let Some(order) = drawn.iter().map(|(_, layer)| layer.look.order).filter(|&order| Some(order) > last).min() {
            for &(span, layer) in drawn.iter().filter(|(_, layer)| layer.look.order == order) {
                let look = if layer.look.result > 0 && Some(layer.look.result) < result { &beneath(layer.look) } else { layer.look };
                self.span(frame, span, layer, look);
            }
            last = Some(order);
        }
        if let Some(exact) = run.exact().filter(|_| shown.contains(&layers::EXACT.key)) {
            self.line(layers::EXACT.key, layers::EXACT.look, 0.0, &exact.path);
        }
        if entry.stops {
            self.stops(&run.scene().stops(), entry, frame, shown);
        }
        self.events(run, frame, &drawn);
        if !entry.stops {
            self.ends(run.scene());
        }
        self.robots(frame, &drawn);
    }

    fn span(&mut self, frame: &Frame, span: Span, layer: &Layer, look: &Look) {
        let points: Vec<_> = frame.points(span).collect();
        let weight = |vertex: usize| f64::from(frame.vertices()[(span.first as usize + vertex) * VERTEX + 3]);
        match (span.shape, look.glyph) {
            // Drawn with the scene, or on top.
            (Shape::Points, Glyph::Number | Glyph::Event) | (_, Glyph::Robot) => {}
            (Shape::Polyline, _) => {
                self.line(layer.key, look, weight(0), &points);
                if look.glyph == Glyph::Arrow {
                    let places: Vec<_> = points.iter().map(|&point| self.place(point)).collect();
                    put!(self, "{}", self.ink(layer.key, look).arrows(&places));
                }
            }
            (Shape::Tube, _) => self.tube(layer.key, look, &points, weight(0)),
            (Shape::Segments, _) => {
                points.chunks_exact(2).enumerate().for_each(|(i, pair)| self.line(layer.key, look, weight(2 * i), pair));
            }
            (Shape::Points, Glyph::Ring | Glyph::Diamond) => {
                let ink = self.ink(layer.key, look);
                let lifted = look.lifted && look.glyph == Glyph::Diamond;
                for &point in &points {
                    let at = self.at(point);
                    put!(self, "{}", if lifted { ink.lifted_diamond(at, look.point) } else { ink.outline(look.glyph, at, look.point) });
                }
            }
            (Shape::Points, _) => {
                for (i, &point) in points.iter().enumerate() {
                    let opacity = look.opacity_at(weight(i)).max(FAINTEST_POINT);
                    self.dot(layer.key, point, look.point / 2.0, look.color.on(self.dark), opacity);
                }
            }
            (Shape::Field, _) => {
                let colors = look.ramp.map(|ramp| ramp.on(self.dark));
                let drawn = colors.and_then(|colors| raster(frame, layer, &colors));
                let pixels = drawn.map_or_else(Vec::new, |raster| raster.pixels);
                for (&point, pixel) in points.iter().zip(pixels.as_chunks::<4>().0).filter(|(_, pixel)| pixel[3] > 0) {
                    self.dot(layer.key, point, FIELD_POINT, *pixel, 1.0);
                }
            }
        }
    }

    fn ink(&self, layer: LayerKey, look: &Look) -> Ink {
        let [color, fill] = [look.color, look.fill.unwrap_or(STAGE)].map(|color| self.tone(color));
        Ink { layer: layer.0, color, fill, ground: self.tone(STAGE), width: look.width }
    }

    /// Where something happened or was decided.
    fn events(&mut self, run: &Run, frame: &Frame, drawn: &[(Span, &Layer)]) {
        let tone = |at: usize| {
            let kind = run.events().get(at).and_then(|event| run.entry().events.iter().find(|kind| kind.name == event.kind));
            kind.map_or(Tone::Plain, |kind| kind.tone)
        };
        for (span, layer) in drawn.iter().filter(|(_, layer)| layer.look.glyph == Glyph::Event) {
            let events: Vec<_> = frame.points(*span).enumerate().map(|(i, point)| (self.at(point), tone(i))).collect();
            self.text.push_str(&glyph::events(layer.key.0, &events, &self.tone(STAGE), self.dark));
        }
    }

    /// Robots are discs, and a segment from the centre is the heading.
    fn robots(&mut self, frame: &Frame, drawn: &[(Span, &Layer)]) {
        let robots = || drawn.iter().filter(|(_, layer)| layer.look.glyph == Glyph::Robot);
        for (span, layer) in robots().filter(|(span, _)| span.shape == Shape::Tube) {
            let Some(center) = frame.points(*span).next() else { continue };
            let front = robots().find(|(other, _)| other.layer == span.layer && other.shape == Shape::Segments);
            let front = front.and_then(|(segment, _)| frame.points(*segment).nth(1)).filter(|&front| front != center);
            let heading = front.map(|front| {
                let places = [center, front].map(|point| self.place(point));
                [0, 1].map(|axis| (places[1][axis] - places[0][axis]) / geometry::length(&places))
            });
            let radius = f64::from(frame.vertices()[span.first as usize * VERTEX + 3]) * self.scale;
            put!(self, "{}", self.ink(layer.key, layer.look).robot(self.at(center), radius, heading));
        }
    }

    fn list(&self, points: &[[f64; 2]]) -> String {
        let mut list = String::new();
        for &point in points {
            let [x, y] = self.at(point).map(Px);
            let _ = write!(list, "{x},{y} ");
        }
        list
    }

    fn line(&mut self, layer: LayerKey, look: &Look, weight: f64, points: &[[f64; 2]]) {
        let list = self.list(points);
        let color = look.color.on(self.dark);
        let width = if look.swell > 0.0 { look.width + weight.clamp(0.0, 1.0) * (look.swell - look.width) } else { look.width };
        put!(
            self,
            r#"<polyline class="{}" points="{}" stroke="{}" stroke-width="{}" stroke-opacity="{}"{}/>"#,
            layer.0,
            list.trim_end(),
            Hex(opaque(color)),
            Px(width),
            Px(opacity_of(color, look.opacity_at(weight))),
            Dashes(look.dash)
        );
    }

    /// What a tube covers: an obstacle, a region that is expected to be taken, the rim of a range.
    fn tube(&mut self, layer: LayerKey, look: &Look, points: &[[f64; 2]], half: f64) {
        let radius = rounded(half * self.scale);
        let Some(at) = points.first().map(|&point| self.at(point)) else { return };
        let ink = self.ink(layer, look);
        match look.glyph {
            Glyph::Reach => put!(self, "{}", ink.reach(at, radius, look)),
            Glyph::Disc => put!(self, "{}", ink.disc(at, radius)),
            Glyph::Band => {
                let covered = look.fill.unwrap_or(look.color).on(self.dark);
                self.band(layer, points, radius, Hex(opaque(covered)), opacity_of(covered, 1.0));
                self.band(layer, points, radius, format_args!("url(#hatch-{})", layer.0), 0.5);
            }
            _ => self.band(layer, points, radius, ink.color, SHADE),
        }
    }

    /// A wide line with round ends; of one point a disc.
    fn band(&mut self, layer: LayerKey, points: &[[f64; 2]], radius: f64, paint: impl Display, opacity: f64) {
        let mut list = self.list(points);
        if points.len() == 1 {
            list = list.repeat(2);
        }
        let (width, opacity) = (Px(2.0 * radius), Px(opacity));
        put!(
            self,
            r#"<polyline class="{}" points="{}" stroke="{paint}" stroke-width="{width}" stroke-opacity="{opacity}"/>"#,
            layer.0,
            list.trim_end()
        );
    }

    fn dot(&mut self, layer: LayerKey, point: [f64; 2], radius: f64, color: Rgba, opacity: f64) {
        let ([x, y], [radius, opacity]) = (self.at(point).map(Px), [radius, opacity_of(color, opacity)].map(Px));
        let fill = Hex(opaque(color));
        put!(self, r#"<circle class="{}" cx="{x}" cy="{y}" r="{radius}" fill="{fill}" fill-opacity="{opacity}"/>"#, layer.0);
    }

    /// The stops with their places in the tour, as far as there is one, or else with the scene's own numbers.
    fn stops(&mut self, stops: &[[f64; 2]], entry: &Entry, frame: &Frame, shown: &[LayerKey]) {
        let numbers = |span: &Span| entry.layer(span.layer).is_some_and(|layer| layer.look.glyph == Glyph::Number);
        let all = |span: &Span| numbers(span) && span.count as usize == stops.len() && shown.contains(&span.layer);
        let span = frame.spans().find(all);
        let place = |stop: usize| span.map_or(-1.0, |span| frame.vertices()[(span.first as usize + stop) * VERTEX + 3]);
        let (ground, ink) = (self.tone(STAGE), self.tone(INK));
        let numbered = stops.len() <= NUMBERED;
        for (i, &stop) in stops.iter().enumerate() {
            let [x, y] = self.at(stop);
            let at = place(i);
            let tone = self.tone(if at < 0.0 { UNNUMBERED } else { layers::TOUR.look.color });
            let radius = if numbered { 9.5 } else { 3.5 };
            let (below, [x, y, disc, ring]) = (Px(y + 4.0), [x, y, radius, radius + 3.25].map(Px));
            put!(self, r#"<circle cx="{x}" cy="{y}" r="{disc}" fill="{ground}" stroke="{tone}" stroke-width="1.75"/>"#);
            if at == 0.0 {
                put!(self, r#"<circle cx="{x}" cy="{y}" r="{ring}" stroke="{tone}" stroke-width="2"/>"#);
            }
            if numbered {
                let number = if at < 0.0 { i } else { at as usize } + 1;
                put!(
                    self,
                    r#"<text x="{x}" y="{below}" fill="{ink}" font-family="sans-serif" font-size="11" text-anchor="middle">{number}</text>"#
                );
            }
        }
    }

    fn ends(&mut self, scene: &Scene) {
        let Some((start, goal)) = scene.ends() else {
            return;
        };
        for (point, fill) in [(start, self.tone(START)), (goal, self.tone(GOAL))] {
            let [x, y] = self.at(point).map(Px);
            put!(self, r#"<circle cx="{x}" cy="{y}" r="6" fill="{fill}"/>"#);
        }
    }
}

/// Moving obstacles are hatched: walls are plain.
const fn is_hatched(look: &Look) -> bool {
    matches!(look.glyph, Glyph::Disc | Glyph::Band)
}

/// The opacity of a colour that has one of its own.
fn opacity_of(color: Rgba, opacity: f64) -> f64 {
    rounded(opacity * f64::from(color[3]) / 255.0)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Setup, shipped, standard};

    #[test]
    fn a_tour_is_drawn_with_its_direction_and_the_stops_with_their_places() {
        let setup = Setup { planner: "bat".into(), scene: shipped("ant-bat-30").unwrap(), params: crate::Overrides::default(), seed: 1 };
        let mut run = Run::new(standard(), setup).unwrap();
        let before = svg(&run, false, &[layers::TOUR.key, layers::STOPS.key]);
        assert_eq!(before.matches("<circle").count(), 12, "neither start nor goal");
        assert!(before.contains(">12</text>") && !before.contains("<path"), "the scene's own numbers");
        while run.outcome().length.is_none() {
            run.step(1);
        }
        let picture = svg(&run, false, &[layers::TOUR.key, layers::STOPS.key]);
        assert_eq!(picture.matches("<circle").count(), 12 + 1, "the first has a ring");
        assert!(picture.matches('Z').count() >= 12, "a head on each leg");
        let numbers: std::collections::BTreeSet<_> =
            picture.lines().filter(|line| line.ends_with("</text>")).map(|line| line.rsplit('>').nth(1)).collect();
        assert_eq!(numbers.len(), 12);
    }

    #[test]
    fn a_picture_holds_the_scene_and_only_the_layers_asked_for() {
        let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs").unwrap(), params: crate::Overrides::default(), seed: 1 };
        let mut run = Run::new(standard(), setup).unwrap();
        run.step(5);
        let picture = svg(&run, false, &[layers::BEST.key, layers::EXACT.key]);
        assert_eq!(picture.matches("<circle").count(), 7 + 2, "discs, start and goal");
        assert_eq!(picture.matches(r#"class="best""#).count(), 1);
        assert_eq!(picture.matches(r#"class="exact""#).count(), 1);
        assert_eq!(picture.matches(r#"class="particles""#).count(), 0);
        assert_eq!(svg(&run, true, &[layers::PARTICLES.key]).matches(r#"class="particles""#).count(), 150);
        assert_eq!(escaped("a<b & c>d"), "a&lt;b &amp; c&gt;d");
    }

    #[test]
    fn a_layer_has_the_colour_of_its_look_by_day_and_by_night_and_cells_without_pheromone_are_left_out() {
        let setup = Setup { planner: "aco".into(), scene: shipped("ant-bat-30").unwrap(), params: crate::Overrides::default(), seed: 1 };
        let mut run = Run::new(standard(), setup).unwrap();
        run.step(3);
        for dark in [false, true] {
            let picture = svg(&run, dark, &[layers::BEST.key, layers::PHEROMONE.key]);
            let best = picture.lines().find(|line| line.contains(r#"class="best""#)).unwrap();
            assert!(best.contains(&format!(r#"stroke="{}""#, Hex(layers::BEST.look.color.on(dark)))), "{best}");
            let cells = picture.matches(r#"class="pheromone""#).count();
            assert!((1..900).contains(&cells), "{cells} of 900 cells");
        }
    }

    #[test]
    fn points_have_the_form_of_their_glyph() {
        let setup = Setup { planner: "wcpso".into(), scene: shipped("matyas").unwrap(), params: crate::Overrides::default(), seed: 1 };
        let mut run = Run::new(standard(), setup).unwrap();
        run.step(5);
        let picture = svg(&run, false, &[layers::BEST.key, layers::MEAN_BEST.key, layers::PARTICLES.key]);
        let ring = format!(r#"r="4.5" stroke="{}" stroke-width="2"/>"#, Hex(layers::BEST.look.color.light));
        let best = picture.lines().find(|line| line.contains(r#"class="best""#)).unwrap();
        assert!(best.starts_with("<circle") && best.ends_with(&ring), "{best}");
        let dots = picture.lines().filter(|line| line.contains(r#"class="particles""#));
        assert!(dots.map(|line| assert!(line.starts_with("<circle") && line.contains(r#"r="2.5" fill="#), "{line}")).count() > 0);
        let last = picture.lines().rev().nth(1).unwrap();
        assert_eq!(last, best, "layers of a higher order are drawn later");
    }

    #[test]
    fn a_drive_shows_events_by_their_tones_and_on_top_of_all_the_robot_in_its_heading() {
        let setup =
            Setup { planner: "a-star-drive".into(), scene: shipped("patrol").unwrap(), params: crate::Overrides::default(), seed: 1 };
        let mut run = Run::new(standard(), setup).unwrap();
        let keys = [layers::EVENTS.key, layers::MOVING.key, layers::PREDICTED.key, layers::ROBOT.key];
        let robot = |picture: &str| picture[picture.find(r#"<g class="robot""#).unwrap()..].to_owned();
        let before = robot(&svg(&run, false, &keys));
        assert!(
            before.contains("matrix(1 0 0 1 ") && before.contains(r#"<path d="M4.47 0A"#),
            "without a heading there is a dot: {before}"
        );
        run.step(u64::MAX);
        let picture = svg(&run, true, &keys);
        assert_eq!(picture.matches(r#"<g class="events""#).count(), run.events().len());
        assert!(picture.contains(r#"<pattern id="hatch-moving""#) && picture.contains(r#"fill="url(#hatch-moving)""#));
        let after = robot(&picture);
        assert!(after.contains("matrix(0 1 -1 0 "), "down: {after}");
        assert!(!after.contains("events") && !after.contains("<circle cx"), "it lies on top of all");
    }
}
