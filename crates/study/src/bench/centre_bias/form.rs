//! A test function whose minimum is in the middle of the search box, anywhere, or in the middle with its axes turned.

use std::{fmt, str::FromStr, sync::Arc};

use forage::{
    Error,
    kernel::rng::Stream,
    scene::{Function, FunctionScene},
    swarm::objective::{Evaluation, Objective, Scratch, SearchBox},
};
use serde::{Deserialize, Serialize};

/// How far from the middle a moved minimum is at most, as a share of half a side.
const FARTHEST: f64 = 0.8;
/// The numbers of the streams, by what they draw: another one than that of a planner with the same seed.
const SHIFT: u64 = 1 << 40;
const AXES: u64 = SHIFT + 1;

/// What was done to a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// Its minimum is in the middle.
    Centred,
    /// Its minimum is anywhere within four fifths of half a side.
    Shifted,
    /// Its minimum is in the middle, and its axes point anywhere.
    Rotated,
}

impl Form {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Centred, Self::Shifted, Self::Rotated];

    /// Its name in rows and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Centred => "centred",
            Self::Shifted => "shifted",
            Self::Rotated => "rotated",
        }
    }

    /// A function in this form.
    ///
    /// # Errors
    /// A dimension that the function does not have.
    pub(super) fn of(self, function: Function, dimension: usize, instance: u64) -> Result<FunctionScene, Error> {
        let centre = vec![-function.minimiser(); dimension];
        match self {
            Self::Centred => Ok(FunctionScene::named(function, dimension, centre)),
            Self::Shifted => {
                let (mut stream, far) = (Stream::new(instance, SHIFT), FARTHEST * function.half_side());
                let shift = centre.iter().map(|centre| centre + stream.between(-far, far)).collect();
                Ok(FunctionScene::named(function, dimension, shift))
            }
            Self::Rotated => {
                let search_box = SearchBox::cube(dimension, -function.half_side(), function.half_side())?;
                let axes = axes(dimension, &mut Stream::new(instance, AXES));
                FunctionScene::of(Arc::new(Rotated { function, axes, search_box }), Some(0.0), Some(vec![0.0; dimension]))
            }
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Form {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let known = || Self::ALL.map(Self::name);
        Self::ALL.into_iter().find(|form| form.name() == text).ok_or_else(|| Error::unknown("form", text, known()))
    }
}

/// A function around the middle, seen along other axes.
struct Rotated {
    function: Function,
    /// Orthonormal, one after the other.
    axes: Vec<f64>,
    search_box: SearchBox,
}

impl Objective for Rotated {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], _scratch: &mut Scratch) -> Evaluation {
        let minimiser = self.function.minimiser();
        let seen: Vec<f64> = self.axes.chunks_exact(x.len()).map(|axis| minimiser + dot(axis, x)).collect();
        self.function.value(&seen).into()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Axes in any directions, all equally probable: normally distributed numbers, made orthonormal one after the other (Gram and Schmidt).
fn axes(n: usize, stream: &mut Stream) -> Vec<f64> {
    let mut axes: Vec<f64> = (0..n * n).map(|_| stream.normal()).collect();
    for k in 0..n {
        let (before, rest) = axes.split_at_mut(k * n);
        let axis = &mut rest[..n];
        for other in before.chunks_exact(n) {
            let along = dot(axis, other);
            axis.iter_mut().zip(other).for_each(|(x, other)| *x -= along * other);
        }
        let length = dot(axis, axis).sqrt();
        axis.iter_mut().for_each(|x| *x /= length);
    }
    axes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_form_has_its_minimum_where_it_should() {
        for function in Function::ALL.into_iter().filter(|function| function.dimensions().1 > 2) {
            for instance in 1..5 {
                let [centred, shifted, rotated] = Form::ALL.map(|form| form.of(function, 5, instance).unwrap());
                let half = function.half_side();
                for scene in [&centred, &shifted, &rotated] {
                    assert!(scene.value(&scene.minimiser().unwrap()).abs() < 1e-12, "{function:?}");
                    assert_eq!((scene.search_box().low()[3], scene.search_box().high()[3]), (-half, half));
                }
                assert_eq!(centred.minimiser(), Some(vec![0.0; 5]));
                let moved = shifted.minimiser().unwrap();
                assert!(moved.iter().all(|x| x.abs() <= FARTHEST * half) && moved.iter().any(|x| x.abs() > 0.1 * half), "{moved:?}");
            }
        }
    }

    #[test]
    fn turning_keeps_distances_and_a_sphere_as_it_is() {
        let axes = axes(6, &mut Stream::new(7, AXES));
        for (i, a) in axes.chunks_exact(6).enumerate() {
            for (j, b) in axes.chunks_exact(6).enumerate() {
                assert!((dot(a, b) - f64::from(u8::from(i == j))).abs() < 1e-12);
            }
        }
        let x = [3.0, -20.0, 55.0, 0.5, -7.0, 80.0];
        let [centred, _, rotated] = Form::ALL.map(|form| form.of(Function::Sphere, 6, 3).unwrap().value(&x));
        assert!((centred - rotated).abs() < 1e-9 * centred);
        let [centred, _, rotated] = Form::ALL.map(|form| form.of(Function::Rastrigin, 6, 3).unwrap().value(&x));
        assert!((centred - rotated).abs() > 1.0);
    }
}
