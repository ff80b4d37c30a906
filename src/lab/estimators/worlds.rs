//! Worlds with known answers, written once for both dimensions.
//!
//! The surface that is asked lies at the origin and looks up, along `y`.

use crate::color::Rgb;
use crate::integrators::world::{Diffuse, DirectLight, Step, World};
use crate::materials::Event;
use crate::numeric;
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Ray, Space};
use glam::Vec2;

/// A point of a diffuse surface that may glow.
#[derive(Clone, Copy, Debug)]
pub struct Lit<S: Space> {
    /// The surface.
    pub surface: Diffuse<S>,
    /// Radiance that it emits towards the ray by itself.
    pub emission: Rgb,
}

impl<S: Space> Lit<S> {
    /// How a path goes on: by the cosine.
    pub fn sample(&self, vertex: u64, stream: &Stream) -> Step<S> {
        let mut numbers = stream.at(vertex, Purpose::Direction);
        let local = S::sample_cosine(S::uniforms(&mut numbers));
        let direction = S::to_world(&S::frame(self.surface.n), local);
        Step {
            ray: self.surface.spawn(direction),
            weight: self.surface.albedo,
            bsdf_weight: self.surface.albedo,
            pdf: Some(S::pdf_cosine(local)),
            event: Event::Diffuse,
            left: numbers.one(),
        }
    }
}

/// The point of a grey floor that looks up at the world.
pub fn floor<S: Space>(albedo: f32) -> Lit<S> {
    let zero = S::from_plane(Vec2::ZERO);
    Lit {
        surface: Diffuse {
            p: zero,
            error: zero,
            n: S::from_plane(Vec2::Y),
            time: 0.0,
            albedo: Rgb::grey(albedo),
        },
        emission: Rgb::BLACK,
    }
}

/// What worlds of [`Lit`] points have in common.
macro_rules! lit {
    ($S:ident) => {
        type Point = Lit<$S>;

        fn diffuse(&self, at: &Lit<$S>) -> Diffuse<$S> {
            at.surface
        }

        fn sample_bsdf(&self, at: &Lit<$S>, vertex: u64, stream: &Stream) -> Option<Step<$S>> {
            Some(at.sample(vertex, stream))
        }
    };
}

/// A world that counts the rays it is asked for; shadow rays are its own affair.
#[derive(Clone, Copy, Debug)]
pub struct Counted<W> {
    /// The world.
    pub world: W,
    /// Rays so far.
    pub rays: u64,
}

impl<W> Counted<W> {
    /// The world, with no ray traced.
    pub fn new(world: W) -> Self {
        Counted { world, rays: 0 }
    }
}

impl<S: Space, W: World<S>> World<S> for Counted<W> {
    type Point = W::Point;

    fn intersect(&mut self, ray: &Ray<S>, segment: u32) -> Option<W::Point> {
        self.rays += 1;
        self.world.intersect(ray, segment)
    }

    fn emitted(&self, ray: &Ray<S>, hit: Option<&W::Point>) -> Rgb {
        self.world.emitted(ray, hit)
    }

    fn diffuse(&self, at: &W::Point) -> Diffuse<S> {
        self.world.diffuse(at)
    }

    fn smooth_event(&self, at: &W::Point) -> Option<Event> {
        self.world.smooth_event(at)
    }

    fn sample_bsdf(&self, at: &W::Point, vertex: u64, stream: &Stream) -> Option<Step<S>> {
        self.world.sample_bsdf(at, vertex, stream)
    }

    fn lights(&self) -> usize {
        self.world.lights()
    }

    fn sample_light(
        &mut self,
        at: &W::Point,
        light: usize,
        vertex: u64,
        stream: &Stream,
    ) -> Option<DirectLight> {
        self.world.sample_light(at, light, vertex, stream)
    }

    fn pdf_light(&self, from: &W::Point, ray: &Ray<S>, hit: Option<&W::Point>) -> f32 {
        self.world.pdf_light(from, ray, hit)
    }
}

/// Nothing but a surrounding, whose radiance is a function of the direction.
#[derive(Clone, Copy, Debug)]
pub struct Sky<F>(pub F);

impl<S: Space, F: Fn(S::Vector) -> f32> World<S> for Sky<F> {
    lit!(S);

    fn intersect(&mut self, _: &Ray<S>, _: u32) -> Option<Lit<S>> {
        None
    }

    fn emitted(&self, ray: &Ray<S>, hit: Option<&Lit<S>>) -> Rgb {
        hit.map_or_else(|| Rgb::grey((self.0)(ray.direction)), |hit| hit.emission)
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
    lit!(S);

    fn intersect(&mut self, ray: &Ray<S>, _: u32) -> Option<Lit<S>> {
        // Which way the wall leans is of no account where all walls are alike.
        let Lit { surface, .. } = floor(self.albedo);
        Some(Lit {
            surface: Diffuse {
                n: -ray.direction,
                ..surface
            },
            emission: Rgb::WHITE,
        })
    }

    fn emitted(&self, _: &Ray<S>, hit: Option<&Lit<S>>) -> Rgb {
        hit.map_or(Rgb::BLACK, |hit| hit.emission)
    }
}

impl Furnace {
    /// A ray from the eye: any will do.
    pub fn eye<S: Space>() -> Ray<S> {
        Ray::new(S::from_plane(Vec2::ZERO), S::from_plane(Vec2::Y))
    }

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
    lit!(S);

    fn intersect(&mut self, ray: &Ray<S>, _: u32) -> Option<Lit<S>> {
        let slope = S::to_plane(ray.direction).y;
        let upper = slope > 0.0;
        let t = (f32::from(u8::from(upper)) - S::to_plane(ray.origin).y) / slope;
        // All points of a plate are alike: the hit keeps its height and moves back to the middle,
        // so that long runs between the plates lose no digits.
        let Lit { surface, .. } = floor(self.albedo[usize::from(upper)]);
        (slope != 0.0 && t > 0.0).then(|| Lit {
            surface: Diffuse {
                p: S::from_plane(Vec2::new(0.0, f32::from(u8::from(upper)))),
                n: S::from_plane(if upper { Vec2::NEG_Y } else { Vec2::Y }),
                ..surface
            },
            emission: Rgb::grey(self.emission[usize::from(upper)]),
        })
    }

    fn emitted(&self, _: &Ray<S>, hit: Option<&Lit<S>>) -> Rgb {
        hit.map_or(Rgb::BLACK, |hit| hit.emission)
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
