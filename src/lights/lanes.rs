//! A quad that shines, sampled from sixteen points at once: [`QuadLight::sample`] from afar, bit for bit.

use super::QuadLight;
use crate::color::Rgb;
use crate::geometry::Surface;
use crate::geometry::lanes::{Rays, bilinear};
use crate::numeric::gamma;
use crate::numeric::lanes::{
    Floats, Mask, Vector, Wides, Words, floats, mask, offset_origin, scale_and_direction,
};
use fearless_simd::prelude::*;
use glam::Vec3;

/// A quad that shines on one side or on both.
#[derive(Clone, Copy, Debug)]
pub struct QuadInLanes {
    corners: [Vec3; 4],
    surface: Surface,
    radiance: Rgb,
    two_sided: bool,
    area: f64,
    middle: Vec3,
    /// Square of the distance beyond which it is sampled by area.
    far: f32,
    /// No light reaches points that are not farther along its normal: those certainly behind all corners. Minus infinity
    /// for a light with two sides.
    front: f64,
}

/// Sixteen points of surfaces, with their normals on the side from which light is looked for.
#[derive(Clone, Copy, Debug)]
pub struct Points<S: Simd> {
    /// The points.
    pub p: Vector<S>,
    /// The bounds on their errors.
    pub error: Vector<S>,
    /// The normals.
    pub n: Vector<S>,
    /// The numbers of their shapes.
    pub shape: Words<S>,
}

/// Samples of the light: see [`LightSample`](super::LightSample).
#[derive(Clone, Copy, Debug)]
pub struct LightSamples<S: Simd> {
    /// Lanes that have one.
    pub some: Mask<S>,
    /// Unit directions to the light.
    pub wi: Vector<S>,
    /// Their densities in 1/sr.
    pub pdf: Floats<S>,
    /// Radiance in W/(m² sr); of lights without extent the irradiance of what faces them.
    pub li: Vector<S>,
    /// Lanes whose light has no extent: no ray finds it by chance.
    pub delta: Mask<S>,
    /// Rays that end just before the light.
    pub shadow_rays: Rays<S>,
}

impl<S: Simd> LightSamples<S> {
    /// None in any lane, seen from these shapes.
    #[inline(always)]
    pub fn none(s: S, shape: Words<S>) -> Self {
        let zero = Vector::splat(s, [0.0; 3]);
        LightSamples {
            some: mask(s, 0),
            wi: zero,
            pdf: zero.x,
            li: zero,
            delta: mask(s, 0),
            shadow_rays: Rays {
                origin: zero,
                direction: zero,
                t_max: zero.x,
                from: shape,
            },
        }
    }
}

impl QuadInLanes {
    /// The same light.
    pub fn new(light: &QuadLight) -> Self {
        let (middle, far) = light.by_area_beyond();
        let (corners, surface) = (light.quad().corners(), light.quad().surface_at(0.5, 0.5));
        let n = surface.n.as_dvec3();
        let lowest = corners
            .map(|corner| n.dot(corner.as_dvec3()))
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let front = match light.is_two_sided() {
            true => f64::NEG_INFINITY,
            false => lowest - n.abs().dot(surface.error.as_dvec3()),
        };
        QuadInLanes {
            corners,
            surface,
            front,
            radiance: light.radiance(),
            two_sided: light.is_two_sided(),
            area: f64::from(light.quad().area()),
            middle,
            far,
        }
    }

    /// Lanes before the light and so near that it is sampled by solid angle.
    #[inline(always)]
    pub fn is_near<S: Simd>(&self, s: S, from: &Points<S>) -> Mask<S> {
        let apart = Vector::splat(s, self.middle) - from.p;
        let n = Vector::splat(s, self.surface.n).widen();
        let before = from.p.widen().dot(n).gt(Wides::splat(s, self.front));
        before & !apart.dot(apart).simd_ge(floats(s, self.far))
    }

    /// A point of it, by area.
    ///
    /// * Domain: `u` in `[0, 1)²`.
    /// * Density: that of the plain [`QuadLight::sample_area`].
    #[inline(always)]
    pub fn sample_area<S: Simd>(
        &self,
        s: S,
        from: &Points<S>,
        u: [Floats<S>; 2],
    ) -> LightSamples<S> {
        let zero = floats(s, 0.0);
        let target = self.point(s, u);
        let way = from.p.widen() - target.widen();
        let mut n = Vector::splat(s, self.surface.n);
        if self.two_sided {
            let behind = Wides::splat(s, 0.0).gt(way.dot(n.widen()));
            n = Vector::select(behind, -n, n);
        }
        let error = Vector::splat(s, self.surface.error);
        let faces = way
            .dot(n.widen())
            .gt(Wides::from(n.abs().dot(error + from.error)));
        let to = target.widen() - from.p.widen();
        let wi = to.normalize(s).narrow();
        let cos = n.dot(wi);
        let cos_light = -Wides::from(cos);
        let pdf = (to.dot(to) / (cos_light * self.area)).narrow();
        let fine = cos_light.gt(Wides::splat(s, 0.0)) & pdf.abs().simd_lt(floats(s, f32::INFINITY));
        let pdf = fine.select(pdf, zero);

        let back = from.p - target;
        let end = offset_origin(s, target, error + back.abs() * gamma(3), n, back);
        let origin = offset_origin(s, from.p, from.error, from.n, end - from.p);
        let (scale, direction) = scale_and_direction(s, end - origin);
        LightSamples {
            some: faces & cos.simd_lt(zero) & pdf.simd_gt(zero),
            wi,
            pdf,
            li: Vector::splat(s, self.radiance.channels()),
            delta: mask(s, 0),
            shadow_rays: Rays {
                origin,
                direction,
                t_max: scale * (1.0 - gamma(8)),
                from: from.shape,
            },
        }
    }

    /// `Quad::surface_at`.
    #[inline(always)]
    fn point<S: Simd>(&self, s: S, [u, v]: [Floats<S>; 2]) -> Vector<S> {
        let weights = bilinear(s, u, v);
        Vector {
            x: weighted(weights, self.corners.map(|corner| corner.x)),
            y: weighted(weights, self.corners.map(|corner| corner.y)),
            z: weighted(weights, self.corners.map(|corner| corner.z)),
        }
    }
}

#[inline(always)]
fn weighted<S: Simd>([a, b, c, d]: [Floats<S>; 4], corners: [f32; 4]) -> Floats<S> {
    a * corners[0] + b * corners[1] + c * corners[2] + d * corners[3]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Quad;
    use crate::lights::Incident;
    use crate::numeric::lanes::{LANES, Row, Row3, bits, levels, words};
    use crate::sampling::stream::{Purpose, Stream};
    use fearless_simd::dispatch;
    use glam::DVec3;

    #[test]
    fn samples_are_those_of_the_plain_light() {
        let (corner, u, v) = (
            DVec3::new(-1.0, 2.0, 0.3),
            DVec3::new(2.0, 0.0, 0.0),
            DVec3::new(0.0, 0.2, 1.5),
        );
        let quad = Quad::new(corner, u, v).expect("a quad");
        let one_sided = QuadLight::new(quad, Rgb::WHITE);
        let (mut some, mut near, mut by_angle) = (0, 0, 0);
        for light in [one_sided, one_sided.two_sided()] {
            let lanes = QuadInLanes::new(&light);
            for sample in 0..2000 {
                let mut numbers = Stream::new(3, 0, sample).at(0, Purpose::Direction);
                let mut row =
                    |size: f32| Row(std::array::from_fn(|_| (numbers.one() - 0.5) * size));
                let mut row3 = |size| Row3([(); 3].map(|()| row(size)));
                let (p, error, n) = (row3(20.0), row3(1e-5), row3(2.0));
                let (u, v) = (row(1.0), row(1.0));
                for level in levels() {
                    let (is_near, has, wi, pdf, o, d, t) = dispatch!(level, s => {
                        let from = Points {
                            p: p.get(s),
                            error: error.get(s).abs(),
                            n: n.get(s).normalize(),
                            shape: words(s, 0),
                        };
                        let l = lanes.sample_area(s, &from, [u.get(s) + 0.5, v.get(s) + 0.5]);
                        let rays = l.shadow_rays;
                        let (o, d) = (Row3::from(rays.origin), Row3::from(rays.direction));
                        let t = Row::from(rays.t_max);
                        let is_near = bits(lanes.is_near(s, &from));
                        (is_near, bits(l.some), Row3::from(l.wi), Row::from(l.pdf), o, d, t)
                    });
                    for lane in 0..LANES {
                        let from = Surface {
                            p: p.lane(lane).into(),
                            error: Vec3::from(error.lane(lane)).abs(),
                            n: Vec3::from(n.lane(lane)).normalize(),
                            time: 0.0,
                        };
                        let u = [u.0[lane] + 0.5, v.0[lane] + 0.5];
                        let plain = light.sample_area(&from, u);
                        assert_eq!(has >> lane & 1 == 1, plain.is_some(), "{level:?}");
                        near += is_near >> lane & 1;
                        // Only where it is near and before the light another point is drawn.
                        let whole = light.sample(&from, u).map(|l| l.shadow_ray.direction);
                        let same = whole == plain.map(|l| l.shadow_ray.direction);
                        assert!(same || is_near >> lane & 1 == 1, "{from:?}");
                        by_angle += u32::from(!same);
                        let Some(plain) = plain else { continue };
                        some += 1;
                        let Incident::Radiance { pdf: density, .. } = plain.incident else {
                            unreachable!("a light with an area");
                        };
                        assert_eq!((wi.lane(lane), pdf.0[lane]), (plain.wi.into(), density));
                        let ray = plain.shadow_ray;
                        assert_eq!(o.lane(lane), ray.origin.to_array());
                        assert_eq!((d.lane(lane), t.0[lane]), (ray.direction.into(), ray.t_max));
                    }
                }
            }
        }
        assert!(
            some > 50_000 && near < 2 * by_angle,
            "{some} {near} {by_angle}"
        );
    }
}
