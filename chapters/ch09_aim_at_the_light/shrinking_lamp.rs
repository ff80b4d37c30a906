//! One surface below one lamp, which shrinks: what chance and what aiming make of it.
//!
//! The lamp has radiance 1 and is seen straight overhead, within a half-angle `a` of the normal: a
//! segment of the flat world, a sphere in space. The surface has albedo 1, and reflects `sin a` in
//! the flat world and `sin² a` in space.

use glam::Vec2;
use halfdisk::flatland;
use halfdisk::integrators::world::World;
use halfdisk::integrators::{Kajiya, NextEvent};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::walks::{self, Walks};
use halfdisk::lab::estimators::worlds::{self, Lit};
use halfdisk::scene::read::Source;
use halfdisk::scene::{SceneError, gallery};
use halfdisk::space::{Flat, Ray, Solid, Space};
use std::f64::consts::{FRAC_PI_4, PI};

/// How the lamp is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Technique {
    /// By chance, all directions alike: the half disk of the essay.
    Uniform,
    /// By chance, along the cosine: the walk of [`Kajiya`].
    Cosine,
    /// By a shadow ray: the walk of [`NextEvent`].
    Aim,
}

/// Eye, surface, lamp: two segments, and no more.
const MAX_DEPTH: u32 = 2;

/// `count` walks in the flat world, where the lamp is a segment; their mean is `sin a`.
///
/// * `half_angle` in radians, in `(0, 1.5]`.
pub fn flat(
    technique: Technique,
    half_angle: f64,
    count: u32,
    seed: u64,
) -> Result<Walks, SceneError> {
    let (truth, half) = (libm::sin(half_angle), libm::tan(half_angle));
    let text = format!(
        "name = 'shrinking lamp'\n\
         [[objects]]\nalbedo = 1\nsegment = {{ from = [-9, 0], to = [9, 0] }}\n\
         [[objects]]\nemits = 1\nsegment = {{ from = [{half:?}, 1], to = [-{half:?}, 1] }}\n"
    );
    let world = flatland::gallery::from_text(source(&text))?;
    // To the middle of the floor, past the lamp.
    let ray = Ray::<Flat>::new(Vec2::new(-0.5, 0.25), Vec2::new(2.0, -1.0).normalize());
    let max_depth = MAX_DEPTH;
    Ok(match technique {
        Technique::Uniform => {
            let half = half_angle as f32;
            uniform::<Flat, _>(|| worlds::strip::<Flat>(-half, half), truth, count, seed)
        }
        Technique::Cosine => walks::flat(&world, truth, count, seed, |world, stream| {
            Kajiya { max_depth }.walk(world, &ray, stream)
        }),
        Technique::Aim => walks::flat(&world, truth, count, seed, |world, stream| {
            NextEvent { max_depth }.walk(world, &ray, stream)
        }),
    })
}

/// `count` walks in space, where the lamp is a sphere; their mean is `sin² a`.
///
/// * `half_angle` in radians, in `(0, 1]`.
pub fn solid(
    technique: Technique,
    half_angle: f64,
    count: u32,
    seed: u64,
) -> Result<Walks, SceneError> {
    let radius = libm::sin(half_angle);
    let truth = radius * radius;
    let text = format!(
        "name = 'shrinking lamp'\n\
         camera = {{ from = [-0.5, 0.25, 0], to = [0, 0, 0], fov = 40 }}\n\
         materials.white.lambert.albedo = 1\n\
         [[objects]]\nmaterial = 'white'\n\
         quad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
         [[objects]]\nemits = 1\nsphere = {{ center = [0, 1, 0], radius = {radius:?} }}\n"
    );
    let scene = gallery::from_text(source(&text), None, |_| {})?;
    let ray = scene.camera.ray(0.5, 0.5);
    let max_depth = MAX_DEPTH;
    Ok(match technique {
        Technique::Uniform => {
            let ball = || worlds::ball::<Solid>(radius as f32, 0.0);
            uniform::<Solid, _>(ball, truth, count, seed)
        }
        Technique::Cosine => walks::solid(&scene, &ray, &Kajiya { max_depth }, truth, count, seed),
        Technique::Aim => walks::solid(&scene, &ray, &NextEvent { max_depth }, truth, count, seed),
    })
}

fn source(text: &str) -> Source<'_> {
    Source {
        file: "shrinking lamp",
        text,
    }
}

/// Walks of one uniform direction; the ray from the eye is counted as if there were one.
fn uniform<S: Space, W: World<S, Point = Lit<S>>>(
    world: impl Fn() -> W + Sync,
    truth: f64,
    count: u32,
    seed: u64,
) -> Walks {
    let gather = Gather {
        samples: 1,
        depth: 1,
        recipe: Recipe::Uniform,
    };
    let floor = worlds::floor::<S>(1.0);
    walks::many(truth, count, seed, |stream| {
        let li = gather.reflected(&mut world(), &floor, stream);
        (li, 2)
    })
}

impl Technique {
    /// Variance of one walk over its squared mean, in the flat world, exactly.
    ///
    /// For a small lamp `π/2a - 1`, `1/a - 1` and `a⁴/45`.
    pub fn exact_flat(self, half_angle: f64) -> f64 {
        let a = half_angle;
        let (sin, cos) = libm::sincos(a);
        match self {
            Technique::Uniform => FRAC_PI_4 * (a + sin * cos) / (sin * sin) - 1.0,
            Technique::Cosine => 1.0 / sin - 1.0,
            // The difference cancels where the lamp is small, and its series is exact there.
            Technique::Aim if a < 0.02 => a.powi(4) / 45.0,
            Technique::Aim => 0.5 * a * (a + sin * cos) / (sin * sin) - 1.0,
        }
    }

    /// The same in space.
    ///
    /// For a small lamp `2/a² - 1`, `1/a² - 1` and `a⁴/48`.
    pub fn exact_solid(self, half_angle: f64) -> f64 {
        let (sin, cos) = libm::sincos(half_angle);
        let square = sin * sin;
        match self {
            Technique::Uniform => 4.0 / 3.0 * (1.0 - cos.powi(3)) / (square * square) - 1.0,
            Technique::Cosine => 1.0 / square - 1.0,
            // (1 - cos) / (1 + cos) = (sin / (1 + cos))².
            Technique::Aim => (sin / (1.0 + cos)).powi(4) / 3.0,
        }
    }

    /// The share of walks that find the lamp in the flat world: what decides how many are needed.
    pub fn finds_flat(self, half_angle: f64) -> f64 {
        match self {
            Technique::Uniform => 2.0 * half_angle / PI,
            Technique::Cosine => libm::sin(half_angle),
            Technique::Aim => 1.0,
        }
    }
}
