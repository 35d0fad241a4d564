//! Geometry against slow arithmetic with fractions, which rounds nothing.

mod exact;

use arbitrary::{Result, Unstructured};
use forage::geometry::{Block, Cuboid, Disc, Field, Oriented, closest_approach, distance_squared, first_within};
use num_traits::Zero as _;

use exact::{Number, exact, square};

/// Coordinates are whole numbers where three things often meet in a point, or any numbers of a size that scenes have.
struct Place {
    whole: bool,
}

impl Place {
    fn new(drawn: &mut Unstructured) -> Result<Self> {
        Ok(Self { whole: drawn.arbitrary()? })
    }

    fn number(&self, drawn: &mut Unstructured) -> Result<f64> {
        if self.whole {
            return Ok(f64::from(drawn.int_in_range(-6_i8..=6)?));
        }
        let fraction = f64::from(drawn.arbitrary::<i32>()?) / f64::from(1 << 30);
        Ok(fraction * *drawn.choose(&[1.0, 1e-6, 30.0, 1e3])?)
    }

    fn point<const N: usize>(&self, drawn: &mut Unstructured) -> Result<[f64; N]> {
        let mut point = [0.0; N];
        for axis in &mut point {
            *axis = self.number(drawn)?;
        }
        Ok(point)
    }

    /// Two corners of a box.
    fn corners<const N: usize>(&self, drawn: &mut Unstructured) -> Result<[[f64; N]; 2]> {
        let [a, b]: [[f64; N]; 2] = [self.point(drawn)?, self.point(drawn)?];
        Ok([std::array::from_fn(|i| a[i].min(b[i])), std::array::from_fn(|i| a[i].max(b[i]))])
    }

    fn length(&self, drawn: &mut Unstructured) -> Result<f64> {
        Ok(self.number(drawn)?.abs())
    }
}

/// The greatest coordinate: what rounding is measured by.
fn size(points: &[&[f64]]) -> f64 {
    points.iter().flat_map(|point| point.iter()).fold(0.0, |size: f64, c| size.max(c.abs()))
}

/// The same but for the rounding of numbers of that size; squares of distances.
fn assert_near(found: f64, right: &Number, size: f64, what: &str) {
    let right = exact::nearest(right);
    assert!((found - right).abs() <= 64.0 * f64::EPSILON * size * size, "{what}: {found}, by fractions {right}, {size}");
}

/// Whether something is within a reach is the same, unless the difference is one of rounding.
fn assert_within(found: bool, squared: &Number, reach: f64, size: f64, what: &str) {
    let margin = exact::nearest(&(squared - square(&exact(reach))));
    let slack = 256.0 * f64::EPSILON * size.max(reach) * size.max(reach);
    assert!(margin.abs() <= slack || found == (margin < 0.0), "{what}: {found} by {margin}");
}

pub fn segment(drawn: &mut Unstructured) -> Result<()> {
    let place = Place::new(drawn)?;
    let [a, b, c]: [[f64; 2]; 3] = [place.point(drawn)?, place.point(drawn)?, place.point(drawn)?];
    let (radius, size) = (place.length(drawn)?, size(&[&a, &b, &c]));
    let squared = exact::to_point(&a, &b, &c);
    assert_near(distance_squared(a, b, c), &squared, size, "a point from a segment");
    let disc = Disc { center: c, radius };
    let part = disc.clip(a, b);
    assert_within(part.is_some(), &squared, radius, size, "a segment in a disc");
    if let Some([from, to]) = part {
        assert!(0.0 <= from && from <= to && to <= 1.0, "{from} to {to}");
        // The middle is inside, what is before and behind is not.
        for (t, inside) in [(f64::midpoint(from, to), true), (from / 2.0, false), (f64::midpoint(1.0, to), false)] {
            if inside || (0.0 < t && t < from) || (to < t && t < 1.0) {
                let at = exact::along(&a, &b, t);
                assert_within(inside, &exact::apart(&at, &c.map(exact)), radius, size, "a part of a segment");
            }
        }
    }
    Ok(())
}

pub fn block(drawn: &mut Unstructured) -> Result<()> {
    let place = Place::new(drawn)?;
    let [min, max] = place.corners(drawn)?;
    let (a, b, radius) = (place.point(drawn)?, place.point(drawn)?, place.length(drawn)?);
    let (block, size) = (Block { min, max }, size(&[&min, &max, &a, &b]));
    let squared = exact::to_box(&a, &b, &min, &max);
    assert_near(block.distance_squared(a, b), &squared, size, "a segment from a rectangle");
    assert_near(block.distance_squared_to(a), &exact::to_box(&a, &a, &min, &max), size, "a point from a rectangle");
    if place.whole {
        assert_eq!(block.clip(a, b).is_some(), squared.is_zero(), "whether they meet");
    }
    assert_within(block.clip_grown(radius, a, b).is_some(), &squared, radius, size, "a segment in a grown rectangle");
    if let Some([from, to]) = block.clip(a, b) {
        assert!(0.0 <= from && from <= to && to <= 1.0);
        let depth = exact::nearest(&exact::depth(&a, &b, &min, &max));
        assert!((block.depth(a, b) - depth).abs() <= 64.0 * f64::EPSILON * size, "{} deep, by fractions {depth}", block.depth(a, b));
    }
    Ok(())
}

pub fn cuboid(drawn: &mut Unstructured) -> Result<()> {
    let place = Place::new(drawn)?;
    let [min, max] = place.corners(drawn)?;
    let (a, b, radius) = (place.point(drawn)?, place.point(drawn)?, place.length(drawn)?);
    let (cuboid, size) = (Cuboid { min, max }, size(&[&min, &max, &a, &b]));
    let squared = exact::to_box(&a, &b, &min, &max);
    let found = cuboid.distance_squared(a, b);
    assert_near(found, &squared, size, "a segment from a cuboid");
    assert_eq!(cuboid.meets(a, b), found == 0.0, "it is 0 exactly where they meet");
    let bound = cuboid.gap_squared(a, b);
    assert!(bound.sqrt() <= found.sqrt() + 8.0 * f64::EPSILON * size, "no lower bound: {bound} of {found}");
    if place.whole {
        assert_eq!(cuboid.meets(a, b), squared.is_zero(), "whether they meet");
        assert_eq!(cuboid.contains(a), exact::to_box(&a, &a, &min, &max).is_zero(), "whether it holds a point");
    }
    assert_within(cuboid.is_within(radius, a, b), &squared, radius, size, "a capsule and a cuboid");
    Ok(())
}

pub fn outline(drawn: &mut Unstructured) -> Result<()> {
    let place = Place::new(drawn)?;
    let [min, max] = place.corners(drawn)?;
    let angle = f64::from(drawn.arbitrary::<i16>()?) / 5000.0;
    let direction = *drawn.choose(&[[1.0, 0.0], [0.6, 0.8], [-0.8, 0.6], [forage::math::cos(angle), forage::math::sin(angle)]])?;
    let outline = Oriented { center: place.point(drawn)?, direction, half: [place.length(drawn)?, place.length(drawn)?] };
    let block = Block { min, max };
    let size = size(&[&min, &max, &outline.center, &outline.half]);
    let found = outline.distance(&block);
    // Each side of the one from the other: 0 where they overlap.
    let corners = outline.corners();
    let sides = (0..4).map(|i| exact::to_box(&corners[i], &corners[(i + 1) % 4], &min, &max));
    let squared = sides.min().unwrap_or_else(Number::zero);
    let right = exact::nearest(&squared).sqrt();
    let slack = 64.0 * f64::EPSILON * size;
    if found > slack {
        // A root of a difference of squares of this size is no more exact.
        assert!((found - right).abs() <= slack.max(slack * size / found), "{found} apart, by fractions {right}");
    } else if found < -slack {
        // Where no sides meet, the one is in the other, and so is its middle.
        let inside = exact::to_box(&outline.center, &outline.center, &min, &max).is_zero();
        let middle = [0, 1].map(|axis| f64::midpoint(min[axis], max[axis]) - outline.center[axis]);
        let [x, y] = [middle[0] * direction[0] + middle[1] * direction[1], middle[1] * direction[0] - middle[0] * direction[1]];
        let around = x.abs() <= outline.half[0] + slack && y.abs() <= outline.half[1] + slack;
        assert!(squared.is_zero() || inside || around, "they overlap by {found}, and are {right} apart");
    }
    Ok(())
}

pub fn approach(drawn: &mut Unstructured) -> Result<()> {
    let place = Place::new(drawn)?;
    let (apart, closing): ([f64; 2], [f64; 2]) = (place.point(drawn)?, place.point(drawn)?);
    let (seconds, reach) = (place.length(drawn)?, place.length(drawn)?);
    let end = [0, 1].map(|axis| exact(apart[axis]) + exact(seconds) * exact(closing[axis]));
    let squared = exact::between(&apart.map(exact), &end);
    let size = size(&[&apart, &[closing[0] * seconds, closing[1] * seconds]]).max(reach);
    let (time, least) = closest_approach(apart, closing, seconds);
    assert!((0.0..=seconds).contains(&time));
    assert_near(least * least, &squared, size, "the closest approach");
    match first_within(apart, closing, seconds, reach) {
        Some(time) => {
            assert!(0.0 <= time && time <= seconds && reach > 0.0);
            assert_within(true, &squared, reach, size, "they come within reach");
            // At that moment they are as far apart, or nearer from the beginning.
            let at = [0, 1].map(|axis| exact(apart[axis]) + exact(time) * exact(closing[axis]));
            let then = exact::nearest(&at.iter().map(square).sum());
            let slack = 1024.0 * f64::EPSILON * size * size;
            assert!(time == 0.0 || (then - reach * reach).abs() <= slack, "{then} apart then, {}", reach * reach);
        }
        None => assert_within(false, &squared, reach, size, "they do not come within reach"),
    }
    Ok(())
}

/// A round robot among blocked cells: it passes where no cell is nearer than its radius.
pub fn grid(drawn: &mut Unstructured) -> Result<()> {
    let [columns, rows] = [drawn.int_in_range(1_usize..=7)?, drawn.int_in_range(1_usize..=7)?];
    let cell = *drawn.choose(&[1.0, 0.5, 0.1, 3.0])?;
    let bits: u64 = drawn.arbitrary()?;
    let blocked: Vec<bool> = (0..columns * rows).map(|k| bits >> k & 1 != 0).collect();
    let radius = cell * f64::from(drawn.int_in_range(0_u8..=12)?) / 8.0;
    let field = Field::new(cell, columns, &blocked, radius, drawn.arbitrary()?);
    let place = |drawn: &mut Unstructured, cells: usize| -> Result<f64> {
        let parts = drawn.int_in_range(0..=4 * cells)?;
        let off = if drawn.arbitrary()? { f64::from(drawn.arbitrary::<i16>()?) / 1e5 } else { 0.0 };
        Ok(((parts as f64 / 4.0 + off) * cell).clamp(0.0, cells as f64 * cell))
    };
    let (a, b) = ([place(drawn, columns)?, place(drawn, rows)?], [place(drawn, columns)?, place(drawn, rows)?]);
    let corner = |column: usize, row: usize| [column as f64 * cell, row as f64 * cell];
    let slack = 1e-9 * cell;
    let blocks: Vec<Block> = (0..columns * rows)
        .filter(|&k| blocked[k])
        .map(|k| Block { min: corner(k % columns, k / columns), max: corner(k % columns + 1, k / columns + 1) })
        .collect();
    let Some(squared) = blocks.iter().map(|block| exact::to_box(&a, &b, &block.min, &block.max)).min() else {
        assert!(field.is_free(a, b) && field.clearance(a, b).is_none(), "there is nothing");
        return Ok(());
    };
    let (apart, found) = (exact::nearest(&squared).sqrt(), field.is_free(a, b));
    if radius > 0.0 {
        assert!((apart - radius).abs() <= slack || found == (apart > radius), "{found}: {apart} from a cell, the radius is {radius}");
    } else if apart > slack {
        assert!(found, "a point is {apart} from a cell");
    } else {
        // A point may touch, and pass where cells do.
        let deep = blocks.iter().map(|block| exact::nearest(&exact::depth(&a, &b, &block.min, &block.max))).fold(0.0, f64::max);
        assert!(deep <= 1e-6 * cell || !found, "a point passes {deep} deep through a cell");
    }
    let clearance = field.clearance(a, b).unwrap_or(f64::INFINITY);
    assert!(
        apart <= slack || (clearance - (apart - radius)).abs() <= slack || (clearance - apart).abs() <= slack,
        "{clearance} of {apart}"
    );
    let outline = Oriented { center: a, direction: [0.6, 0.8], half: [radius, cell / 4.0] };
    let least = field.blocks().iter().map(|block| outline.distance(block)).fold(f64::INFINITY, f64::min);
    let distance = field.distance(&outline).unwrap_or(f64::INFINITY);
    assert!((distance - least).abs() <= slack, "an outline is {least} from the nearest block, not {distance}");
    Ok(())
}
