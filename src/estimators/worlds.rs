//! Worlds with known answers, written once for both dimensions.
//!
//! The surface that is asked lies at the origin and looks up, along `y`.

use super::world::{Hit, World};
use crate::numeric;
use crate::space::{Ray, Space};
use glam::Vec2;

/// The point of a floor that looks up at the world.
pub fn floor<S: Space>(albedo: f32) -> Hit<S, f32> {
    let zero = S::from_plane(Vec2::ZERO);
    Hit {
        p: zero,
        error: zero,
        n: S::from_plane(Vec2::Y),
        albedo,
        emission: 0.0,
        aimed: false,
    }
}

/// Nothing but a surrounding, whose radiance is a function of the direction.
#[derive(Clone, Copy, Debug)]
pub struct Sky<F>(pub F);

impl<S: Space, F: Fn(S::Vector) -> f32> World<S> for Sky<F> {
    type Light = f32;

    fn first_hit(&mut self, _: &Ray<S>) -> Option<Hit<S, f32>> {
        None
    }

    fn environment(&self, direction: S::Vector) -> f32 {
        (self.0)(direction)
    }
}

/// A white sky: the open furnace, in which a right estimator reads the albedo.
pub fn white<S: Space>() -> Sky<fn(S::Vector) -> f32> {
    Sky(|_| 1.0)
}

/// A lamp of radiance 1 between two angles from the normal, in radians, positive to the right: a
/// segment of the flat world, and in space a strip without end.
///
/// The floor reflects `albedo / 2 · (sin high - sin low)`, in both.
pub fn strip<S: Space>(low: f32, high: f32) -> Sky<impl Fn(S::Vector) -> f32> {
    Sky(move |w: S::Vector| {
        let profile = S::to_plane(w);
        let angle = numeric::atan2(profile.x, profile.y);
        f32::from(u8::from(low <= angle && angle < high))
    })
}

/// A round lamp of radiance 1 whose radius is `sin_radius` of its distance, at `angle` from the
/// normal: a disc of the flat world, a sphere in space.
///
/// The floor reflects `albedo · sin_radius^k · cos angle` where the whole lamp is above the
/// horizon, with the fall-off `k` of the world ([`Space::FALL_OFF`]).
pub fn ball<S: Space>(sin_radius: f32, angle: f32) -> Sky<impl Fn(S::Vector) -> f32> {
    let (sin, cos) = numeric::sin_cos(angle);
    let axis = S::from_plane(Vec2::new(sin, cos));
    let cos_radius = (1.0 - sin_radius * sin_radius).sqrt();
    Sky(move |w: S::Vector| f32::from(u8::from(S::dot(w, axis) > cos_radius)))
}

/// A closed room whose walls all glow with radiance 1 and reflect `albedo`.
///
/// Its radiance is the same everywhere: bounce `k` adds `albedo^k`, all of them `1 / (1 - albedo)`.
#[derive(Clone, Copy, Debug)]
pub struct Furnace {
    /// The share of light the walls reflect.
    pub albedo: f32,
}

impl<S: Space> World<S> for Furnace {
    type Light = f32;

    fn first_hit(&mut self, ray: &Ray<S>) -> Option<Hit<S, f32>> {
        // Which way the wall leans is of no account where all walls are alike.
        Some(Hit {
            n: -ray.direction,
            emission: 1.0,
            ..floor(self.albedo)
        })
    }

    fn environment(&self, _: S::Vector) -> f32 {
        0.0
    }
}

impl Furnace {
    /// Radiance with at most `depth` bounces: `1 + albedo + ... + albedo^depth`.
    pub fn radiance(&self, depth: u32) -> f64 {
        (0..depth).fold(1.0, |sum, _| 1.0 + f64::from(self.albedo) * sum)
    }
}

/// Two parallel plates without end, one unit apart, the lower at `y = 0`.
#[derive(Clone, Copy, Debug)]
pub struct Plates {
    /// The share of light reflected by the lower and the upper plate.
    pub albedo: [f32; 2],
    /// Radiance emitted by each.
    pub emission: [f32; 2],
}

impl<S: Space> World<S> for Plates {
    type Light = f32;

    fn first_hit(&mut self, ray: &Ray<S>) -> Option<Hit<S, f32>> {
        let slope = S::to_plane(ray.direction).y;
        let upper = slope > 0.0;
        let t = (f32::from(u8::from(upper)) - S::to_plane(ray.origin).y) / slope;
        // All points of a plate are alike: the hit keeps its height and moves back to the middle,
        // so that long runs between the plates lose no digits.
        (slope != 0.0 && t > 0.0).then(|| Hit {
            p: S::from_plane(Vec2::new(0.0, f32::from(u8::from(upper)))),
            n: S::from_plane(if upper { Vec2::NEG_Y } else { Vec2::Y }),
            emission: self.emission[usize::from(upper)],
            ..floor(self.albedo[usize::from(upper)])
        })
    }

    fn environment(&self, _: S::Vector) -> f32 {
        0.0
    }
}

impl Plates {
    /// Radiance of both plates with at most `depth` bounces. Each sees nothing but the other, so
    /// `L = E + albedo · L'`, in the flat world as in space.
    pub fn radiance(&self, depth: u32) -> [f64; 2] {
        let [albedo, emission] = [self.albedo, self.emission].map(|x| x.map(f64::from));
        (0..depth).fold(emission, |l, _| {
            [0, 1].map(|i| emission[i] + albedo[i] * l[1 - i])
        })
    }
}
