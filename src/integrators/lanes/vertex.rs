//! Vertices on diffuse surfaces of one colour, under a light that is one quad, as vectors.

use super::Walk;
use super::paths::{Paths, RayRows};
use crate::geometry::lanes::{NO_SHAPE, Rays};
use crate::geometry::{Ray, Surface};
use crate::integrators::path::LEAST_SURVIVAL;
use crate::lights::Incident;
use crate::lights::lanes::{LightSamples, Points};
use crate::materials::Event;
use crate::numeric::lanes::{
    Each, Floats, LANES, Mask, Row, Row3, Vector, bits, floats, mask, offset_origin, sin_cos, words,
};
use crate::sampling::lanes::Places;
use crate::sampling::stream::Purpose;
use crate::scene::lanes::OnlyLight;
use crate::scene::{RayCounts, Tracer};
use fearless_simd::prelude::*;
use std::f32::consts::{FRAC_1_PI, TAU};

/// Local axes around normals: [`Frame`](crate::sampling::frame::Frame).
#[derive(Clone, Copy)]
struct Frames<S: Simd> {
    tangent: Vector<S>,
    bitangent: Vector<S>,
    normal: Vector<S>,
}

impl<S: Simd> Frames<S> {
    #[inline(always)]
    fn new(s: S, n: Vector<S>) -> Self {
        let one = floats(s, 1.0);
        let sign = one.copysign(n.z);
        let a = floats(s, -1.0) / (sign + n.z);
        let b = n.x * n.y * a;
        Frames {
            tangent: Vector {
                x: one + sign * n.x * n.x * a,
                y: sign * b,
                z: -sign * n.x,
            },
            bitangent: Vector {
                x: b,
                y: sign + n.y * n.y * a,
                z: -n.y,
            },
            normal: n,
        }
    }

    #[inline(always)]
    fn to_world(self, w: Vector<S>) -> Vector<S> {
        self.tangent * w.x + self.bitangent * w.y + self.normal * w.z
    }
}

/// The vertices of some lanes.
#[derive(Clone, Copy)]
struct Vertices<S: Simd> {
    lanes: Mask<S>,
    /// The points, with normals on the side of the eye.
    from: Points<S>,
    /// The normal on the front of the surface, and the cosine of the direction to the eye with it.
    n: Vector<S>,
    cos_o: Floats<S>,
    albedo: Vector<S>,
    /// The place of their random numbers.
    numbers: Places<S>,
}

impl<'s, S: Simd> Walk<'_, 's, S> {
    /// Aims at the light from the vertices of some lanes, and chooses where their paths go on; the lanes that do.
    #[inline(always)]
    pub(super) fn scatter_vectors(&mut self, tracer: &mut Tracer<'s>, lanes: u32) -> u32 {
        if lanes == 0 {
            return 0;
        }
        let (s, paths) = (self.s, &*self.paths);
        let back = -paths.ray.direction.get(s);
        let n = paths.here.n.get(s);
        let cos_o = back.dot(n);
        let vertices = Vertices {
            lanes: mask(s, lanes),
            from: Points {
                p: paths.here.p.get(s),
                error: paths.here.error.get(s),
                n: Vector::select(cos_o.simd_lt(floats(s, 0.0)), -n, n),
                shape: paths.here.shape.get(s),
            },
            n,
            cos_o,
            albedo: paths.albedo.get(s),
            numbers: self.streams.at(s, paths.depth.get(s)),
        };
        self.aim(tracer, &vertices);
        self.go_on(&vertices)
    }

    /// Adds the light of the lamp that is scattered once, at the vertices: next-event estimation.
    #[inline(always)]
    fn aim(&mut self, tracer: &mut Tracer<'s>, at: &Vertices<S>) {
        let (s, scene) = (self.s, &self.by.scene);
        let zero = floats(s, 0.0);
        // The light that is aimed at, and the part of it.
        let mut aimed = [(0, 0); LANES];
        let (mut sample, plain, target) = match scene.light() {
            Some(OnlyLight { quad, shape, index }) => {
                aimed = [(*index, 0); LANES];
                let [u, v, ..] = self.streams.four(s, &at.numbers, Purpose::LightPoint);
                let near = quad.is_near(s, &at.from) & at.lanes;
                (quad.sample_area(s, &at.from, [u, v]), bits(near), *shape)
            }
            None => (
                LightSamples::none(s, at.from.shape),
                bits(at.lanes),
                NO_SHAPE,
            ),
        };
        if plain != 0 {
            self.sample_plain(tracer, plain, &mut sample, &mut aimed, at);
        }

        let cos_i = sample.wi.dot(at.n);
        let cos = cos_i.abs();
        let f = at.albedo * FRAC_1_PI;
        let same_side = (at.cos_o * cos_i).simd_gt(zero);
        let asks = at.lanes & sample.some & same_side & !f.is_zero(s) & !cos.simd_eq(zero);
        tracer.count(RayCounts {
            shadow: bits(asks).count_ones().into(),
            ..RayCounts::default()
        });
        let mut visible = self.visible(&sample.shadow_rays, target, bits(asks));
        if scene.has_contacts() {
            let rays = RayRows::from(&sample.shadow_rays);
            for lane in Each(visible) {
                if !scene.light_is_met(aimed[lane], &rays.lane(lane)) {
                    visible &= !(1 << lane);
                }
            }
        }

        // `Heuristic::Power`.
        let ratio = cos * FRAC_1_PI / sample.pdf;
        let weight = floats(s, 1.0) / (floats(s, 1.0) + ratio * ratio);
        let share = sample.delta.select(floats(s, 1.0), weight / sample.pdf);
        let li = sample.li * share;
        let scattered = self.paths.beta.get(s).times((f * cos).times(li));
        let sum = self.paths.li.get(s) + scattered;
        self.paths.li.set_where(s, mask(s, visible), sum);
    }

    /// Those of some lanes whose shadow rays meet nothing before their end, on the shape `target`.
    #[inline(always)]
    fn visible(&self, rays: &Rays<S>, target: u32, asks: u32) -> u32 {
        let (s, scene) = (self.s, &self.by.scene);
        let (mut visible, mut doubt, mut at_triangles) = (asks, asks, 0);
        if let Some(shapes) = scene.shapes() {
            let few = shapes.occluded(s, rays, target, mask(s, asks));
            visible &= !bits(few.hit);
            doubt = visible & bits(few.doubt);
            at_triangles = visible & bits(few.at_triangles);
        }
        if doubt | at_triangles == 0 {
            return visible;
        }
        let (ways, t_max) = (RayRows::from(rays), Row::from(rays.t_max));
        for lane in Each(doubt | at_triangles) {
            let ray = Ray {
                t_max: t_max.0[lane],
                ..ways.lane(lane)
            };
            let blocked = match doubt >> lane & 1 == 1 {
                true => scene.occluded(&ray),
                false => scene.occluded_by_triangles(&ray),
            };
            if blocked {
                visible &= !(1 << lane);
            }
        }
        visible
    }

    /// Samples a light in some lanes by the plain code: near a quad, which is sampled by solid angle there, and all
    /// other lights.
    #[inline(always)]
    fn sample_plain(
        &self,
        tracer: &Tracer<'s>,
        lanes: u32,
        sample: &mut LightSamples<S>,
        aimed: &mut [(u32, u32); LANES],
        at: &Vertices<S>,
    ) {
        let (s, n) = (self.s, Row3::from(at.from.n));
        let (mut some, mut delta) = (bits(sample.some) & !lanes, 0);
        let (mut wi, mut pdf) = (Row3::from(sample.wi), Row::from(sample.pdf));
        let mut li = Row3::from(sample.li);
        let rays = &mut sample.shadow_rays;
        let (mut origin, mut direction) = (Row3::from(rays.origin), Row3::from(rays.direction));
        let mut t_max = Row::from(rays.t_max);
        for lane in Each(lanes) {
            let from = Surface {
                n: n.lane(lane).into(),
                ..self.paths.here.lane(lane)
            };
            let vertex = u64::from(self.paths.depth.0[lane]);
            let mut numbers = self.streams.lane(lane).at(vertex, Purpose::LightPoint);
            let (u, pick) = (numbers.two(), numbers.fine());
            let Some((light, plain)) = tracer.chosen_light_sample(&from, pick, u) else {
                continue;
            };
            aimed[lane] = (light as u32, plain.part);
            let own = match plain.incident {
                Incident::Radiance { li, pdf: density } => {
                    pdf.0[lane] = density;
                    li
                }
                Incident::Irradiance(e) => {
                    delta |= 1 << lane;
                    e
                }
            };
            some |= 1 << lane;
            wi.set_lane(lane, plain.wi);
            li.set_lane(lane, own.channels());
            origin.set_lane(lane, plain.shadow_ray.origin);
            direction.set_lane(lane, plain.shadow_ray.direction);
            t_max.0[lane] = plain.shadow_ray.t_max.min(f32::MAX);
        }
        sample.some = mask(s, some);
        sample.delta = mask(s, delta);
        sample.wi = wi.get(s);
        sample.pdf = pdf.get(s);
        sample.li = li.get(s);
        rays.origin = origin.get(s);
        rays.direction = direction.get(s);
        rays.t_max = t_max.get(s);
    }

    /// Draws the directions of the next rays by the cosine, and plays Russian roulette; the lanes that go on.
    #[inline(always)]
    fn go_on(&mut self, at: &Vertices<S>) -> u32 {
        let (s, zero) = (self.s, floats(self.s, 0.0));
        let paths = &mut *self.paths;
        let depth = paths.depth.get(s);
        let [u, v, _, left] = self.streams.four(s, &at.numbers, Purpose::Direction);
        // `hemisphere::sample_cosine`.
        let (sin_phi, cos_phi) = sin_cos(s, v * TAU);
        let sin = u.sqrt();
        let up = Vector {
            x: sin * cos_phi,
            y: sin * sin_phi,
            z: (floats(s, 1.0) - u).sqrt(),
        };
        let wi = Vector::select(at.cos_o.simd_lt(zero), -up, up);
        let same_side = (at.cos_o * wi.z).simd_gt(zero);
        let pdf = same_side.select(wi.z.abs() * FRAC_1_PI, zero);
        let direction = Frames::new(s, at.n).to_world(wi).normalize();
        let origin = offset_origin(s, at.from.p, at.from.error, at.n, direction);

        let mut on = at.lanes & !at.cos_o.simd_eq(zero);
        let mut beta = paths.beta.get(s).times(at.albedo);
        let mut rr_beta = paths.rr_beta.get(s).times(at.albedo);
        let plays = depth.simd_ge(words(s, self.by.path.roulette_from));
        if bits(plays & on) != 0 {
            let (least, one) = (floats(s, LEAST_SURVIVAL), floats(s, 1.0));
            let q = rr_beta.x.max(rr_beta.y).max(rr_beta.z);
            let q = q.simd_lt(least).select(least, q);
            let q = q.simd_gt(one).select(one, q);
            on &= !plays | left.simd_lt(q);
            beta = Vector::select(plays, beta / q, beta);
            rr_beta = Vector::select(plays, rr_beta / q, rr_beta);
        }
        paths.beta.set_where(s, on, beta);
        paths.rr_beta.set_where(s, on, rr_beta);
        paths.ray.origin.set_where(s, on, origin);
        paths.ray.direction.set_where(s, on, direction);
        paths.left.p.set_where(s, on, at.from.p);
        paths.left.error.set_where(s, on, at.from.error);
        paths.left.n.set_where(s, on, at.from.n);
        Self::leave(s, paths, on, pdf);
        bits(on)
    }

    /// Notes what the next rays were drawn by.
    #[inline(always)]
    fn leave(s: S, paths: &mut Paths, on: Mask<S>, pdf: Floats<S>) {
        paths.pdf.set_where(s, on, pdf);
        paths.left.shape.set_where(s, on, paths.here.shape.get(s));
        let depth = paths.depth.get(s);
        paths.depth.set_where(s, on, depth + words(s, 1));
        let first = bits(depth.simd_eq(words(s, 1)));
        paths.note(bits(on), first, Event::Diffuse);
    }
}
