//! Lamps as they are seen in balls of glass and mirror: where focused light comes from.
//!
//! A ray and the centre of a ball lie in one plane, and however often the ball reflects or refracts
//! the ray, it stays there. So where the ray goes depends on one number alone, how far from the
//! centre it passes; whether it meets a lamp, on how far that is from the plane.
//!
//! Source: Descartes, Les Météores (1637), "De l'arc-en-ciel", for the angle by which a ball turns
//! a ray.

mod image;

pub(in crate::scene) use image::Image;

use super::ball::{Ball, Sight};
use glam::Vec3;
use std::f64::consts::PI;
use wide::f32x8;

/// The rings in which a ball is looked at, equally wide in the square of the distance from its
/// middle.
const RINGS: usize = 16;
/// Rings are looked at eight at a time.
const LANES: usize = 8;
const GROUPS: usize = RINGS / LANES;
/// The squares of the distances at which rings begin, have their middle and end.
const STOPS: [[f32x8; 3]; GROUPS] = {
    let mut stops = [[f32x8::ZERO; 3]; GROUPS];
    let mut group = 0;
    while group < GROUPS {
        let mut lane = 0;
        let mut at = [[0.0; LANES]; 3];
        while lane < LANES {
            let ring = (group * LANES + lane) as f32;
            at[0][lane] = ring / RINGS as f32;
            at[1][lane] = (ring + 0.5) / RINGS as f32;
            at[2][lane] = (ring + 1.0) / RINGS as f32;
            lane += 1;
        }
        stops[group] = [f32x8::new(at[0]), f32x8::new(at[1]), f32x8::new(at[2])];
        group += 1;
    }
    stops
};

/// How light goes on from a ball: it crosses the ball so many times, and is reflected within it once
/// less; with no crossing it is reflected by the ball.
#[derive(Clone, Copy, Debug)]
pub(in crate::scene) struct Way {
    /// The index of refraction; `None` for a mirror, which light does not cross.
    pub(in crate::scene) ior: Option<f64>,
    /// How many times light crosses the ball; 0 for a mirror.
    pub(in crate::scene) crossings: u32,
    /// How much of the light goes this way, roughly.
    pub(in crate::scene) strength: f32,
}

/// A lamp and a ball in which it is seen.
#[derive(Clone, Debug)]
pub(super) struct VirtualLight {
    /// Unit, from the centre of the ball towards the lamp.
    towards: Vec3,
    /// Sine and cosine of half the angle under which the lamp is seen from there.
    spread: [f32; 2],
    /// At each stop the sine and the cosine of the angle, seen from the ball's centre, between where
    /// a ray comes from, infinitely far away, and where it is when it is as far away as the lamp.
    /// NaN in rings of which the middle does not come through the ball.
    turns: [[SinCos; 3]; GROUPS],
    /// See [`Way::strength`].
    strength: f32,
}

impl VirtualLight {
    /// What is seen of a lamp that fills the ball `lamp`; `None` where the two balls meet.
    pub(in crate::scene) fn new(ball: &Ball, lamp: &Ball, way: Way) -> Option<Self> {
        let between = lamp.center - ball.center;
        let distance = between.length();
        if !(distance > ball.radius + lamp.radius && distance.is_finite()) {
            return None;
        }
        let turn = |square: f32| {
            let sin = f64::from(square).sqrt();
            let across = match way.ior {
                Some(ior) => PI - 2.0 * libm::asin(sin / ior),
                None => 0.0,
            };
            2.0 * libm::asin(sin) - libm::asin(sin * ball.radius / distance)
                + f64::from(way.crossings) * across
        };
        let turns = STOPS.map(|group| {
            let [low, middle, high] = group.map(|lanes| lanes.to_array().map(turn));
            let or_middle = |end: [f64; LANES]| {
                std::array::from_fn(|i| if end[i].is_nan() { middle[i] } else { end[i] })
            };
            [or_middle(low), middle, or_middle(high)].map(SinCos::of)
        });
        let spread = libm::asin(lamp.radius / distance);
        Some(VirtualLight {
            towards: (between / distance).as_vec3(),
            spread: [libm::sin(spread), libm::cos(spread)].map(|x| x as f32),
            turns,
            strength: way.strength,
        })
    }

    /// What is seen of it where the ball is seen as `sight`; `None` where that is nothing.
    ///
    /// The lamp counts as a disc that faces the ball, and each ring shows all that any part of it
    /// shows. What is too much costs rays; what is missing is left to others.
    pub(super) fn seen_in(&self, sight: &Sight) -> Option<Image> {
        let back = -sight.axis;
        let cos = back.dot(self.towards);
        let aside = self.towards - back * cos;
        let sin = aside.length();
        let sideways = if sin > 0.0 {
            aside / sin
        } else {
            back.any_orthonormal_vector()
        };
        let mut image = Image::new(sight.axis, sideways, sight.size2, self.strength);

        let [spread_sin, spread_cos] = self.spread.map(f32x8::splat);
        let (sin, cos) = (f32x8::splat(sin), f32x8::splat(cos));
        for (group, (turns, stops)) in self.turns.iter().zip(&STOPS).enumerate() {
            // The angle Γ between here and where the ray arrives: φ less.
            let arrives = |i: usize| {
                let sin2 = stops[i] * f32x8::splat(sight.size2);
                let phi = SinCos {
                    sin: sin2.sqrt(),
                    cos: (f32x8::ONE - sin2).sqrt(),
                };
                turns[i].less(phi)
            };
            let middle = arrives(1);
            // The lamp, wider by as much as the ends of the ring lie beside its middle.
            let beside = [0, 2].map(|i| arrives(i).less(middle).cos);
            let beside_cos = beside[0].fast_min(beside[1]);
            let beside_sin = (f32x8::ONE - beside_cos * beside_cos)
                .fast_max(f32x8::ZERO)
                .sqrt();
            let wide = spread_cos * beside_cos - spread_sin * beside_sin;
            let cos_wide = beside_cos.simd_gt(-spread_cos).select(wide, -f32x8::ONE);
            // The lamp is at the angle γ, and the ray arrives beside it at an angle ψ around the
            // axis: cos(wide) <= cos Γ cos γ + sin Γ sin γ cos ψ.
            let (factor, least) = (middle.sin * sin, cos_wide - middle.cos * cos);
            let mut seen = factor.abs().simd_gt(least).to_bitmask();
            let (factor, least) = (factor.to_array(), least.to_array());
            while seen != 0 {
                let lane = seen.trailing_zeros() as usize % LANES;
                seen &= seen - 1;
                image.add(group * LANES + lane, factor[lane], least[lane]);
            }
        }
        (image.solid_angle() > 0.0).then_some(image)
    }
}

/// The sines and cosines of eight angles.
#[derive(Clone, Copy, Debug)]
struct SinCos {
    sin: f32x8,
    cos: f32x8,
}

impl SinCos {
    fn of(angles: [f64; LANES]) -> Self {
        let lanes = |of: fn(f64) -> f64| f32x8::new(angles.map(|angle| of(angle) as f32));
        SinCos {
            sin: lanes(libm::sin),
            cos: lanes(libm::cos),
        }
    }

    /// Of the differences.
    #[inline(always)]
    fn less(self, other: SinCos) -> SinCos {
        SinCos {
            sin: self.sin * other.cos - self.cos * other.sin,
            cos: self.cos * other.cos + self.sin * other.sin,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric;
    use crate::sampling::frame::Frame;
    use crate::sampling::stream::{Numbers, Purpose, Stream};
    use crate::sampling::warps;
    use glam::DVec3;

    const BALL: Ball = Ball {
        center: DVec3::new(180.0, 90.0, 190.0),
        radius: 90.0,
    };
    const GLASS: Way = Way {
        ior: Some(1.5),
        crossings: 1,
        strength: 1.0,
    };
    const LAMP: Ball = Ball {
        center: DVec3::new(278.0, 554.0, 279.5),
        radius: 83.5,
    };

    /// Where a ray that meets a ball goes on: reflected, or through it.
    fn onward(ball: Ball, way: Way, origin: DVec3, d: DVec3) -> Option<(DVec3, DVec3)> {
        let meet = |o: DVec3, d: DVec3, far: bool| {
            let f = o - ball.center;
            let root = (f.dot(d).powi(2) - f.length_squared() + ball.radius.powi(2)).sqrt();
            let p = o + d * (-f.dot(d) + if far { root } else { -root });
            (p, (p - ball.center) / ball.radius)
        };
        let (p, n) = meet(origin, d, false);
        if way.crossings == 0 {
            return Some((p, d - n * (2.0 * d.dot(n))));
        }
        let ior = way.ior?;
        let refract = |d: DVec3, n: DVec3, eta: f64| {
            let across = (d - n * d.dot(n)) * eta;
            let rest = 1.0 - across.length_squared();
            (rest >= 0.0).then(|| across + n * rest.sqrt() * d.dot(n).signum())
        };
        let mut inside = refract(d, n, 1.0 / ior)?;
        let (mut q, mut n) = meet(p, inside, true);
        for _ in 1..way.crossings {
            inside -= n * (2.0 * inside.dot(n));
            (q, n) = meet(q, inside, true);
        }
        Some((q, refract(inside, n, ior)?))
    }

    fn meets(ball: Ball, (o, d): (DVec3, DVec3)) -> bool {
        let f = ball.center - o;
        f.dot(d) > 0.0 && f.cross(d).length() <= ball.radius
    }

    /// Points around the ball, close to it and far away, and for each some random numbers.
    fn points() -> impl Iterator<Item = (Sight, DVec3, Numbers)> {
        (0..4000).filter_map(|i| {
            let mut numbers = Stream::new(1, i, 0).at(0, Purpose::Direction);
            let at = warps::sample_sphere(numbers.two()).as_dvec3();
            let distance = 90.5 + 200.0 * f64::from(numbers.one()).powi(2);
            let p = (BALL.center + at * distance).as_vec3();
            Some((BALL.seen_from(p)?, p.as_dvec3(), numbers))
        })
    }

    /// A direction to anywhere on the ball.
    fn anywhere(sight: &Sight, numbers: &mut Numbers) -> Vec3 {
        let cone = warps::sample_cone(numbers.two(), numeric::one_minus_cos(sight.size2));
        Frame::new(sight.axis).to_world(cone).normalize()
    }

    /// Of the rays to anywhere on the ball that meet the lamp, the share that its images show; and of
    /// those into its images, the share that meets the lamp, in units of what it is anywhere.
    fn found_and_gain(way: Way, really: Way) -> [f64; 2] {
        let lamp = VirtualLight::new(&BALL, &LAMP, way).expect("two balls apart");
        let (mut all, mut seen, mut found, mut drawn, mut hit) = (0, 0, 0, 0, 0);
        for (sight, p, mut numbers) in points() {
            let meets = |d: Vec3| {
                let onward = onward(BALL, really, p, d.as_dvec3().normalize());
                onward.is_some_and(|ray| meets(LAMP, ray))
            };
            let image = lamp.seen_in(&sight);
            for _ in 0..64 {
                let d = anywhere(&sight, &mut numbers);
                all += 1;
                if meets(d) {
                    seen += 1;
                    found += i32::from(image.as_ref().is_some_and(|image| image.shows(d)));
                }
                if let Some(image) = &image {
                    drawn += 1;
                    hit += i32::from(meets(image.sample(numbers.two())));
                }
            }
        }
        let share = |part, whole| f64::from(part) / f64::from(whole);
        [share(found, seen), share(hit, drawn) / share(seen, all)]
    }

    #[test]
    fn lamps_are_where_their_images_are() {
        let glass = |ior, crossings| Way {
            ior: Some(ior),
            crossings,
            ..GLASS
        };
        let ways = [
            (1.5, 0),
            (1.5, 1),
            (1.2, 1),
            (0.8, 1),
            (1.5, 2),
            (1.33, 2),
            (1.5, 3),
        ];
        for (ior, crossings) in ways {
            let way = glass(ior, crossings);
            let [found, gain] = found_and_gain(way, way);
            println!("{ior}, {crossings} crossings: {found} found, {gain} times as often");
            assert!(found > 0.95 && gain > 5.0, "{way:?}: {found} {gain}");
        }
        let [found, _] = found_and_gain(glass(1.2, 1), glass(1.5, 1));
        assert!(found < 0.5, "another glass: {found}");
        let [found, _] = found_and_gain(glass(1.5, 1), glass(1.5, 2));
        assert!(found < 0.5, "another way: {found}");
    }

    #[test]
    fn directions_fill_the_images_evenly() {
        let lamp = VirtualLight::new(&BALL, &LAMP, GLASS).expect("two balls apart");
        // Of directions to anywhere, those that an image shows; weighted by how rare they are, those
        // in its inner rings. Of directions drawn, the same.
        let (mut shown, mut expected, mut variance, mut expected_inner) = (0.0, 0.0, 0.0, 0.0);
        let (mut drawn, mut inner, mut left, mut strays) = (0.0_f64, 0.0, 0.0, 0);
        for (sight, _, mut numbers) in points() {
            let Some(image) = lamp.seen_in(&sight) else {
                continue;
            };
            let rim = 2.0 * image.one_minus_cos(RINGS - 2);
            let is_inner = |d: Vec3| f64::from((d - sight.axis).length_squared() < rim);
            let whole = std::f32::consts::TAU * numeric::one_minus_cos(sight.size2);
            let share = f64::from(image.solid_angle() / whole);
            for _ in 0..64 {
                let d = anywhere(&sight, &mut numbers);
                if image.shows(d) {
                    shown += 1.0;
                    expected_inner += is_inner(d) / share;
                }
                expected += share;
                variance += share * (1.0 - share);
                let d = image.sample(numbers.two());
                assert!((d.length() - 1.0).abs() < 1e-5);
                drawn += 1.0;
                inner += is_inner(d);
                left += f64::from(d.dot(sight.axis.cross(image.sideways)) > 0.0);
                strays += i32::from(!image.shows(d));
            }
        }
        println!("{shown} of {expected}, {inner} of {expected_inner}, {left} of {drawn}, {strays}");
        assert!((shown - expected).abs() < 4.4 * f64::sqrt(variance));
        assert!(
            (inner / expected_inner - 1.0).abs() < 0.15,
            "its error is 4 %"
        );
        assert!((left - 0.5 * drawn).abs() < 4.4 * 0.5 * drawn.sqrt());
        assert!(f64::from(strays) < 1e-3 * drawn);
    }
}
