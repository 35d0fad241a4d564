//! A run as an SVG picture: for the shell's `--svg` and the page's export.

use std::fmt::Write;

use crate::{
    geometry::{self, Bounds, YAxis},
    kernel::{Backdrop, Frame, Role, Shape, Span, VERTEX},
    scene::Scene,
    session::Session,
};

/// How a role is drawn: stroke in each theme, width in pixels, opacity, dashes.
struct Style {
    light: &'static str,
    dark: &'static str,
    width: f64,
    opacity: f64,
    dash: &'static str,
}

const fn style(light: &'static str, dark: &'static str, width: f64, opacity: f64, dash: &'static str) -> Style {
    Style { light, dark, width, opacity, dash }
}

fn style_of(role: Role) -> Style {
    match role {
        Role::Particles | Role::Before => style("#5b5fa8", "#9aa2e8", 1.0, 0.35, ""),
        Role::PersonalBests => style("#4d8f8b", "#6fc0ba", 1.0, 0.3, ""),
        Role::Velocities | Role::Inertia => style("#7a7f78", "#98a39a", 1.0, 0.5, ""),
        Role::Roads => style("#8c8674", "#56695f", 1.0, 0.6, ""),
        Role::Tours => style("#5b5fa8", "#9aa2e8", 1.0, 0.2, ""),
        Role::Stops | Role::Different => style("#8f3fb0", "#cf8df0", 1.4, 0.9, ""),
        Role::Best | Role::After | Role::Smoothed | Role::Tour => style("#c27803", "#f2b33d", 3.0, 1.0, ""),
        Role::Pheromone | Role::Trails => style("#7b5ea7", "#b79be0", 1.5, 0.6, ""),
        Role::Ants => style("#8a5a2b", "#d9a86c", 1.0, 0.3, ""),
        Role::Closed => style("#7fa8c9", "#3f6f94", 1.0, 0.5, ""),
        Role::Frontier | Role::Candidates => style("#1f6fb2", "#7cc0f5", 1.0, 0.9, ""),
        Role::Hen => style("#b4446c", "#ee86ac", 1.4, 0.8, ""),
        Role::Chick | Role::Jump => style("#8f3fb0", "#cf8df0", 1.4, 0.8, ""),
        Role::Moving => style("#b03a2e", "#ff8f80", 1.6, 0.9, ""),
        Role::Predicted => style("#b03a2e", "#ff8f80", 1.0, 0.16, ""),
        Role::Sensor => style("#1f6fb2", "#7cc0f5", 1.0, 0.7, "4 4"),
        Role::Robot => style("#1f6fb2", "#7cc0f5", 2.0, 1.0, ""),
        Role::Track => style("#1f6fb2", "#7cc0f5", 2.5, 1.0, ""),
        Role::Ahead => style("#c27803", "#f2b33d", 2.0, 0.9, "2 4"),
        Role::LocalGoal => style("#c27803", "#f2b33d", 4.0, 1.0, ""),
        Role::Events => style("#26302a", "#e8ebe2", 1.8, 0.9, ""),
        Role::Exact => style("#2f6b4f", "#7fcf9f", 2.0, 0.9, "6 5"),
        Role::Cognitive => style("#4d8f8b", "#6fc0ba", 1.6, 1.0, ""),
        Role::Social | Role::Velocity | Role::MeanBest => style("#c27803", "#f2b33d", 1.6, 1.0, ""),
        Role::Tree | Role::Nodes => style("#5b5fa8", "#9aa2e8", 1.0, 0.6, ""),
        Role::GoalTree => style("#8a5a2b", "#d9a86c", 1.0, 0.6, ""),
        Role::Samples => style("#7a7f78", "#98a39a", 1.0, 0.6, ""),
        Role::Kept => style("#1f6fb2", "#7cc0f5", 1.4, 0.9, ""),
        Role::Chosen => style("#c27803", "#f2b33d", 2.0, 1.0, ""),
        Role::Guides => style("#8c8674", "#56695f", 0.8, 0.5, "2 4"),
        Role::Selected => style("#8f3fb0", "#cf8df0", 1.0, 0.5, ""),
        Role::Attractors => style("#4d8f8b", "#6fc0ba", 1.0, 0.6, ""),
    }
}

const SIZE: f64 = 900.0;
const MARGIN: f64 = 24.0;
/// Of more stops none has a number.
const NUMBERED: usize = 100;

/// The session's present state: the scene, the layers of these roles, and the exact optimum if `exact` is among them.
pub fn svg(session: &Session, dark: bool, layers: &[Role]) -> String {
    let view = session.scene().view();
    let (width, height) = (view.max[0] - view.min[0], view.max[1] - view.min[1]);
    let scale = (SIZE - 2.0 * MARGIN) / width.max(height);
    let down = session.scene().plane().is_some_and(|plane| plane.y_axis() == YAxis::Down);
    let top = if down { view.min[1] } else { view.max[1] };
    let canvas = Canvas { scale, left: view.min[0], top, up: if down { -1.0 } else { 1.0 }, dark, text: String::new() };
    canvas.picture(session, layers, [width, height].map(|side| rounded(side * scale + 2.0 * MARGIN)))
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
    ($canvas:expr, $($argument:tt)*) => { let _ = writeln!($canvas.text, $($argument)*); };
}

impl Canvas {
    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [MARGIN + (x - self.left) * self.scale, MARGIN + self.up * (self.top - y) * self.scale].map(rounded)
    }

    fn tone(&self, light: &'static str, dark: &'static str) -> &'static str {
        if self.dark { dark } else { light }
    }

    fn picture(mut self, session: &Session, layers: &[Role], [width, height]: [f64; 2]) -> String {
        let title = format!("{} on {}, iteration {}", session.entry().title, session.scene().header().title, session.iteration());
        put!(
            self,
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" fill="none" stroke-linecap="round" stroke-linejoin="round">"#
        );
        put!(self, "<title>{}</title>", escaped(&title));
        put!(self, r#"<rect width="100%" height="100%" fill="{}"/>"#, self.tone("#faf8f2", "#101714"));
        self.obstacles(session.scene());
        let mut frame = Frame::default();
        session.draw(&mut frame, Frame::BUDGET / 4);
        self.layers(&frame, layers);
        if let Some(exact) = session.exact().filter(|_| layers.contains(&Role::Exact)) {
            self.line(Role::Exact, &style_of(Role::Exact), &exact.path);
        }
        if session.entry().stops {
            self.stops(&session.scene().stops(), &frame, layers);
        } else {
            self.ends(session.scene());
        }
        self.text.push_str("</svg>\n");
        self.text
    }

    fn obstacles(&mut self, scene: &Scene) {
        let (fill, stroke) = (self.tone("#d8d2c2", "#26352e"), self.tone("#8c8674", "#56695f"));
        let margin = self.tone("#ece7d9", "#1a251f");
        scene.body().backdrop(&mut |piece| match piece {
            Backdrop::Border(bounds) => self.frame_of(bounds),
            Backdrop::Disc(disc) => {
                let [x, y] = self.at(disc.center);
                let radius = rounded(disc.radius * self.scale);
                put!(self, r#"<circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}" stroke="{stroke}" stroke-width="1.2"/>"#);
            }
            Backdrop::Block(block) => self.rectangle(block, &format!(r#"fill="{fill}" stroke="{stroke}" stroke-width="1.2""#)),
            Backdrop::Cells(cells) => self.rectangle(cells, &format!(r#"fill="{fill}" stroke="{fill}" stroke-width="1""#)),
            // A line of twice the distance about the box is round at the corners.
            Backdrop::Margin(block, distance) => {
                let width = rounded(2.0 * distance * self.scale);
                self.rectangle(block, &format!(r#"fill="{margin}" stroke="{margin}" stroke-width="{width}""#));
            }
        });
    }

    fn frame_of(&mut self, bounds: Bounds) {
        let tone = self.tone("#d9d4c5", "#2b3a33");
        self.rectangle(bounds, &format!(r#"stroke="{tone}" stroke-width="1""#));
    }

    fn rectangle(&mut self, bounds: Bounds, look: &str) {
        let ([x0, y0], [x1, y1]) = (self.at(bounds.min), self.at(bounds.max));
        let (width, height) = (rounded(x1 - x0), rounded((y1 - y0).abs()));
        put!(self, r#"<rect x="{x0}" y="{}" width="{width}" height="{height}" {look}/>"#, y0.min(y1));
    }

    fn layers(&mut self, frame: &Frame, layers: &[Role]) {
        // Where the result is smoothed, what it was made of is drawn thin.
        let smoothed = layers.contains(&Role::Smoothed) && frame.spans().any(|span| span.role == Role::Smoothed);
        for span in frame.spans().filter(|span| layers.contains(&span.role)) {
            let points: Vec<_> = frame.points(span).collect();
            let look = style_of(if smoothed && span.role == Role::Best { Role::Guides } else { span.role });
            match span.shape {
                Shape::Polyline => {
                    self.line(span.role, &look, &points);
                    if span.role == Role::Tour {
                        self.arrows(&look, &points);
                    }
                }
                Shape::Tube => self.tube(span.role, &look, &points, f64::from(frame.vertices()[span.first as usize * VERTEX + 3])),
                Shape::Points if span.role == Role::Stops => {}
                Shape::Segments => points.chunks_exact(2).for_each(|pair| self.line(span.role, &look, pair)),
                Shape::Points | Shape::Field => points.iter().for_each(|&point| self.dot(span.role, point)),
            }
        }
    }

    fn line(&mut self, role: Role, look: &Style, points: &[[f64; 2]]) {
        let &Style { light, dark, width, opacity, dash } = look;
        let mut list = String::new();
        for &point in points {
            let [x, y] = self.at(point);
            let _ = write!(list, "{x},{y} ");
        }
        let dash = if dash.is_empty() { String::new() } else { format!(r#" stroke-dasharray="{dash}""#) };
        put!(
            self,
            r#"<polyline class="{}" points="{}" stroke="{}" stroke-width="{width}" stroke-opacity="{opacity}"{dash}/>"#,
            role.name(),
            list.trim_end(),
            self.tone(light, dark)
        );
    }

    /// A line as wide as it says, with round ends; of one point a disc. Where robots and obstacles are, they are outlined.
    fn tube(&mut self, role: Role, look: &Style, points: &[[f64; 2]], half: f64) {
        let (tone, opacity, radius) = (self.tone(look.light, look.dark), look.opacity, rounded(half * self.scale));
        match points {
            [point] => {
                let [x, y] = self.at(*point);
                let fill = if role == Role::Sensor { "none" } else { tone };
                let dash = if look.dash.is_empty() { String::new() } else { format!(r#" stroke-dasharray="{}""#, look.dash) };
                put!(
                    self,
                    r#"<circle class="{}" cx="{x}" cy="{y}" r="{radius}" fill="{fill}" fill-opacity="{}" stroke="{tone}" stroke-width="{}" stroke-opacity="{opacity}"{dash}/>"#,
                    role.name(),
                    opacity / 2.0,
                    look.width
                );
            }
            _ => self.line(role, &Style { width: 2.0 * radius, ..*look }, points),
        }
    }

    fn dot(&mut self, role: Role, point: [f64; 2]) {
        let Style { light, dark, width, opacity, .. } = style_of(role);
        let [x, y] = self.at(point);
        put!(
            self,
            r#"<circle class="{}" cx="{x}" cy="{y}" r="{}" fill="{}" fill-opacity="{opacity}"/>"#,
            role.name(),
            1.6 + width,
            self.tone(light, dark)
        );
    }

    /// Heads that say in which direction a tour goes: on each stretch with room for one, and every so often.
    fn arrows(&mut self, look: &Style, points: &[[f64; 2]]) {
        let places: Vec<_> = points.iter().map(|&point| self.at(point)).collect();
        let often = (geometry::length(&places) / 100.0).max(90.0);
        let mut since = often / 2.0;
        let mut heads = String::new();
        for leg in places.windows(2) {
            let ([x0, y0], [x1, y1]) = (leg[0], leg[1]);
            let length = geometry::length(leg);
            since += length;
            if length < 12.0 || (length < f64::max(34.0, often / 5.0) && since < often) {
                continue;
            }
            since = length / 2.0;
            let (x, y, dx, dy) = (f64::midpoint(x0, x1), f64::midpoint(y0, y1), 5.0 * (x1 - x0) / length, 5.0 * (y1 - y0) / length);
            let corner = |along: f64, aside: f64| (rounded(x + along * dx - aside * dy), rounded(y + along * dy + aside * dx));
            let ((tip_x, tip_y), (left_x, left_y), (right_x, right_y)) = (corner(1.0, 0.0), corner(-1.0, 0.85), corner(-1.0, -0.85));
            let _ = write!(heads, "M{tip_x} {tip_y} {left_x} {left_y} {right_x} {right_y}Z");
        }
        put!(self, r#"<path d="{heads}" fill="{}"/>"#, self.tone(look.light, look.dark));
    }

    /// The stops with their places in the tour, as far as there is one, or else with the scene's own numbers.
    fn stops(&mut self, stops: &[[f64; 2]], frame: &Frame, layers: &[Role]) {
        let all = |span: &Span| span.role == Role::Stops && span.count as usize == stops.len() && layers.contains(&span.role);
        let span = frame.spans().find(all);
        let place = |stop: usize| span.map_or(-1.0, |span| frame.vertices()[(span.first as usize + stop) * VERTEX + 3]);
        let Style { light, dark, .. } = style_of(Role::Tour);
        let (ground, ink) = (self.tone("#faf8f2", "#101714"), self.tone("#26302a", "#e8ebe2"));
        let numbered = stops.len() <= NUMBERED;
        for (i, &stop) in stops.iter().enumerate() {
            let [x, y] = self.at(stop);
            let at = place(i);
            let tone = if at < 0.0 { self.tone("#8c8674", "#56695f") } else { self.tone(light, dark) };
            let radius = if numbered { 9.5 } else { 3.5 };
            put!(self, r#"<circle cx="{x}" cy="{y}" r="{radius}" fill="{ground}" stroke="{tone}" stroke-width="1.75"/>"#);
            if at == 0.0 {
                put!(self, r#"<circle cx="{x}" cy="{y}" r="{}" stroke="{tone}" stroke-width="2"/>"#, radius + 3.25);
            }
            if numbered {
                let number = if at < 0.0 { i } else { at as usize } + 1;
                put!(
                    self,
                    r#"<text x="{x}" y="{}" fill="{ink}" font-family="sans-serif" font-size="11" text-anchor="middle">{number}</text>"#,
                    y + 4.0
                );
            }
        }
    }

    fn ends(&mut self, scene: &Scene) {
        let Some((start, goal)) = scene.ends() else {
            return;
        };
        for (point, fill) in [(start, self.tone("#2f6b4f", "#7fcf9f")), (goal, self.tone("#a63d2f", "#f0907f"))] {
            let [x, y] = self.at(point);
            put!(self, r#"<circle cx="{x}" cy="{y}" r="6" fill="{fill}"/>"#);
        }
    }
}

/// To a hundredth of a pixel.
fn rounded(pixels: f64) -> f64 {
    (pixels * 100.0).round() / 100.0
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Setup, shipped};

    #[test]
    fn a_tour_is_drawn_with_its_direction_and_the_stops_with_their_places() {
        let setup = Setup { planner: "bat".into(), scene: shipped("ant-bat-30").unwrap(), params: crate::Given::default(), seed: 1 };
        let mut session = Session::new(setup).unwrap();
        let before = svg(&session, false, &[Role::Tour, Role::Stops]);
        assert_eq!(before.matches("<circle").count(), 12, "neither start nor goal");
        assert!(before.contains(">12</text>") && !before.contains("<path"), "the scene's own numbers");
        while session.outcome().length.is_none() {
            session.step(1);
        }
        let picture = svg(&session, false, &[Role::Tour, Role::Stops]);
        assert_eq!(picture.matches("<circle").count(), 12 + 1, "the first has a ring");
        assert!(picture.matches('Z').count() >= 12, "a head on each leg");
        let numbers: std::collections::BTreeSet<_> =
            picture.lines().filter(|line| line.ends_with("</text>")).map(|line| line.rsplit('>').nth(1)).collect();
        assert_eq!(numbers.len(), 12);
    }

    #[test]
    fn a_picture_holds_the_scene_and_only_the_layers_asked_for() {
        let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs").unwrap(), params: crate::Given::default(), seed: 1 };
        let mut session = Session::new(setup).unwrap();
        session.step(5);
        let picture = svg(&session, false, &[Role::Best, Role::Exact]);
        assert_eq!(picture.matches("<circle").count(), 7 + 2, "discs, start and goal");
        assert_eq!(picture.matches(r#"class="best""#).count(), 1);
        assert_eq!(picture.matches(r#"class="exact""#).count(), 1);
        assert_eq!(picture.matches(r#"class="particles""#).count(), 0);
        assert_eq!(svg(&session, true, &[Role::Particles]).matches(r#"class="particles""#).count(), 150);
        assert_eq!(escaped("a<b & c>d"), "a&lt;b &amp; c&gt;d");
    }
}
