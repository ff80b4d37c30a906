//! Sixteen paths under way, side by side in memory.

use crate::color::Rgb;
use crate::geometry::lanes::{NO_SHAPE, Note, Rays};
use crate::geometry::{Intersection, Ray, Surface};
use crate::materials::Event;
use crate::numeric::lanes::{LANES, Row, Row3, Vector, WordRow, floats, mask, words};
use crate::scene::lanes::PlainHit;
use fearless_simd::prelude::*;

/// The density of a direction that nobody else could have drawn: one from the eye or after a mirror.
pub(super) const NO_PDF: f32 = -1.0;

/// Sixteen paths.
#[derive(Debug, Default)]
pub(super) struct Paths {
    /// The number of each one's sample.
    pub(super) sample: [usize; LANES],
    pub(super) ray: RayRows,
    pub(super) beta: Row3,
    /// Throughput that Russian roulette has not accounted for yet.
    pub(super) rr_beta: Row3,
    pub(super) li: Row3,
    /// The segment that is traced next, or was last.
    pub(super) depth: WordRow,
    /// The density with which the ray was drawn, or [`NO_PDF`].
    pub(super) pdf: Row,
    /// The surface that drew it, with its normal on the side of the eye.
    pub(super) left: SurfaceRows,
    /// What the ray has met.
    pub(super) here: SurfaceRows,
    pub(super) t: Row,
    pub(super) u: Row,
    pub(super) v: Row,
    pub(super) part: WordRow,
    /// The albedo there, where it is diffuse and of one colour.
    pub(super) albedo: Row3,
    /// A bit for each path that has met what shines.
    pub(super) shines: u32,
    /// A bit for each path that was scattered diffusely at its first vertex, and for each that was by a mirror or glass at
    /// its last.
    pub(super) first_is_diffuse: u32,
    pub(super) last_is_specular: u32,
    /// A bit for each path whose caustics are traced from the lights.
    pub(super) on_caustic: u32,
}

/// Sixteen rays without end.
#[derive(Debug, Default)]
pub(super) struct RayRows {
    pub(super) origin: Row3,
    pub(super) direction: Row3,
}

impl<S: Simd> From<&Rays<S>> for RayRows {
    #[inline(always)]
    fn from(rays: &Rays<S>) -> Self {
        RayRows {
            origin: rays.origin.into(),
            direction: rays.direction.into(),
        }
    }
}

impl RayRows {
    pub(super) fn lane(&self, lane: usize) -> Ray {
        Ray::new(
            self.origin.lane(lane).into(),
            self.direction.lane(lane).into(),
        )
    }

    pub(super) fn set_lane(&mut self, lane: usize, ray: &Ray) {
        self.origin.set_lane(lane, ray.origin);
        self.direction.set_lane(lane, ray.direction);
    }
}

/// Sixteen points of surfaces.
#[derive(Debug, Default)]
pub(super) struct SurfaceRows {
    pub(super) p: Row3,
    pub(super) error: Row3,
    pub(super) n: Row3,
    pub(super) shape: WordRow,
}

impl SurfaceRows {
    pub(super) fn lane(&self, lane: usize) -> Surface {
        Surface {
            p: self.p.lane(lane).into(),
            error: self.error.lane(lane).into(),
            n: self.n.lane(lane).into(),
            time: 0.0,
        }
    }

    pub(super) fn set_lane(&mut self, lane: usize, surface: &Surface, shape: u32) {
        self.p.set_lane(lane, surface.p);
        self.error.set_lane(lane, surface.error);
        self.n.set_lane(lane, surface.n);
        self.shape.0[lane] = shape;
    }
}

impl Paths {
    /// Starts paths in some lanes.
    #[inline(always)]
    pub(super) fn start<S: Simd>(&mut self, s: S, lanes: u32) {
        let started = mask(s, lanes);
        self.beta.set_where(s, started, Vector::splat(s, [1.0; 3]));
        self.rr_beta
            .set_where(s, started, Vector::splat(s, [1.0; 3]));
        self.li.set_where(s, started, Vector::splat(s, [0.0; 3]));
        self.depth.set_where(s, started, words(s, 1));
        self.pdf.set_where(s, started, floats(s, NO_PDF));
        self.left.shape.set_where(s, started, words(s, NO_SHAPE));
        self.last_is_specular &= !lanes;
        self.on_caustic &= !lanes;
    }

    /// The light that a path has found.
    pub(super) fn light(&self, lane: usize) -> Rgb {
        Rgb::from(self.li.lane(lane))
    }

    /// Adds light that is scattered to the eye along the path.
    pub(super) fn add(&mut self, lane: usize, li: Rgb) {
        let sum = self.light(lane) + Rgb::from(self.beta.lane(lane)) * li;
        self.li.set_lane(lane, sum.channels());
    }

    /// Notes how some paths were scattered at their vertices.
    #[inline(always)]
    pub(super) fn note(&mut self, lanes: u32, first: u32, event: Event) {
        self.first_is_diffuse &= !(lanes & first);
        self.last_is_specular &= !lanes;
        match event {
            Event::Diffuse => self.first_is_diffuse |= lanes & first,
            Event::Specular => self.last_is_specular |= lanes,
            Event::Gloss => {}
        }
    }

    /// What a path has met.
    pub(super) fn hit(&self, lane: usize) -> PlainHit {
        PlainHit {
            intersection: Intersection {
                t: self.t.0[lane],
                u: self.u.0[lane],
                v: self.v.0[lane],
                part: self.part.0[lane],
            },
            surface: self.here.lane(lane),
            shape: self.here.shape.0[lane],
        }
    }

    /// Stores what a path has met.
    pub(super) fn set_hit(&mut self, lane: usize, hit: &PlainHit, note: Note) {
        let Intersection { t, u, v, part } = hit.intersection;
        self.t.0[lane] = t;
        self.u.0[lane] = u;
        self.v.0[lane] = v;
        self.part.0[lane] = part;
        self.here.set_lane(lane, &hit.surface, hit.shape);
        self.albedo.set_lane(lane, note.albedo);
        self.shines &= !(1 << lane);
        self.shines |= u32::from(note.shines) << lane;
    }
}
