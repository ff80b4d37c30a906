//! What focuses light: perfectly specular objects, as targets for rays that look for their light.

use super::Object;
use crate::geometry::{Aabb, Shape};
use crate::numeric::one_minus_cos;
use crate::sampling::{frame::Frame, warps};
use glam::{DVec3, Vec3};

/// With more objects than this nobody aims at them: each asks for its angle at every surface.
const MOST: usize = 8;

/// Balls around the specular objects of a scene.
///
/// Light that reaches a diffuse surface by way of a mirror or glass is found by chance only, for no
/// shadow ray goes round a corner; but where such light may come from is known. Directions into the
/// cones in which these balls are seen find it more often. Jensen, Global Illumination Using Photon
/// Maps (Rendering Techniques 1996), "Projection maps", sends photons there for the same reason.
#[derive(Clone, Debug, Default)]
pub struct Casters(Vec<Ball>);

#[derive(Clone, Copy, Debug)]
struct Ball {
    center: DVec3,
    radius: f64,
}

/// The cone in which a ball is seen.
#[derive(Clone, Copy)]
struct Cone {
    axis: Vec3,
    one_minus_cos: f32,
}

impl Casters {
    /// Those among the objects of a scene, of which `owners` says which shape belongs to which.
    pub(super) fn new(objects: &[Object], shapes: &[Shape], owners: &[u32]) -> Self {
        let specular = |object: &Object| object.material.is_some_and(|m| !m.is_smooth());
        let ids = (0..).zip(objects).filter(|(_, object)| specular(object));
        let ids: Vec<u32> = ids.map(|(id, _)| id).take(MOST + 1).collect();
        if ids.len() > MOST {
            return Casters::default();
        }
        let shapes_of = |id: u32| {
            let all = owners.iter().zip(shapes);
            all.filter(move |(owner, _)| **owner == id)
                .map(|(_, shape)| *shape)
        };
        let ball = |id| Ball::around(&shapes_of(id).collect::<Vec<_>>());
        Casters(ids.into_iter().filter_map(ball).collect())
    }

    /// True where nothing focuses light.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many objects focus light and are aimed at.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Those that can be aimed at from `p`: it is not within their balls.
    pub fn seen_from(&self, p: Vec3) -> SeenCasters {
        let mut seen = SeenCasters {
            cones: [Cone {
                axis: Vec3::Z,
                one_minus_cos: 0.0,
            }; MOST],
            count: 0,
        };
        for cone in self.0.iter().filter_map(|ball| ball.seen_from(p)) {
            seen.cones[seen.count] = cone;
            seen.count += 1;
        }
        seen
    }
}

/// The cones in which specular objects are seen from a point.
pub struct SeenCasters {
    cones: [Cone; MOST],
    count: usize,
}

impl SeenCasters {
    /// True where none is seen.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Draws a direction: one of the cones, each as likely, and uniformly in its solid angle; not
    /// for none.
    ///
    /// Density: the mean of the cones' ([`SeenCasters::pdf`]), in 1/sr.
    pub fn sample(&self, choice: f32, u: [f32; 2]) -> Vec3 {
        let index = (choice * self.count as f32) as usize;
        let cone = self.cones[index.min(self.count - 1)];
        Frame::new(cone.axis).to_world(warps::sample_cone(u, cone.one_minus_cos))
    }

    /// Density of [`SeenCasters::sample`] at the unit direction `wi`, in 1/sr.
    pub fn pdf(&self, wi: Vec3) -> f32 {
        let inside = self.cones[..self.count].iter().filter(|cone| {
            // 1 - cos of the angle between unit vectors, in which nothing cancels.
            0.5 * (wi - cone.axis).length_squared() <= cone.one_minus_cos
        });
        let sum: f32 = inside.map(|cone| warps::pdf_cone(cone.one_minus_cos)).sum();
        sum / self.count.max(1) as f32
    }
}

impl Ball {
    /// A ball around some shapes; `None` around none, or where it is not finite.
    fn around(shapes: &[Shape]) -> Option<Ball> {
        if let [Shape::Sphere(sphere)] = shapes {
            return Some(Ball {
                center: sphere.center.as_dvec3(),
                radius: f64::from(sphere.radius),
            });
        }
        let bounds = shapes
            .iter()
            .fold(Aabb::EMPTY, |all, shape| all.union(shape.bounds()));
        bounds.is_finite().then(|| {
            let (low, high) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
            Ball {
                center: (low + high) * 0.5,
                radius: (high - low).length() * 0.5,
            }
        })
    }

    fn seen_from(&self, p: Vec3) -> Option<Cone> {
        let way = self.center - p.as_dvec3();
        let distance2 = way.length_squared();
        let sin2 = self.radius * self.radius / distance2;
        let one_minus_cos = one_minus_cos(sin2 as f32);
        (sin2 < 1.0 && one_minus_cos > 0.0).then(|| Cone {
            axis: (way / distance2.sqrt()).as_vec3(),
            one_minus_cos,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::geometry::Sphere;
    use crate::materials::{Glass, Lambert, Material};
    use crate::sampling::stream::{Purpose, Stream};

    fn glass() -> Material {
        Material::Glass(Glass { ior: 1.5 })
    }

    /// Balls on the x axis.
    fn casters<const N: usize>(balls: [(Material, f32, f32); N]) -> Casters {
        let object = |(material, _, _)| Object {
            material: Some(material),
            emission: Rgb::BLACK,
            light: None,
        };
        let shape = |(_, x, radius)| Shape::Sphere(Sphere::new(Vec3::new(x, 0.0, 0.0), radius));
        let owners: Vec<u32> = (0..N as u32).collect();
        Casters::new(&balls.map(object), &balls.map(shape), &owners)
    }

    #[test]
    fn only_what_focuses_and_is_not_around_us() {
        let white = Material::Lambert(Lambert { albedo: Rgb::WHITE });
        let casters = casters([(glass(), 3.0, 1.0), (white, -3.0, 1.0), (glass(), 0.0, 9.0)]);
        let seen = casters.seen_from(Vec3::ZERO);
        assert_eq!((casters.0.len(), seen.count), (2, 1));
        assert!(seen.pdf(Vec3::X) > 0.0);
        assert_eq!(seen.pdf(Vec3::NEG_X), 0.0);
    }

    #[test]
    fn directions_follow_their_density() {
        // Two cones that overlap, one inside the other's rim.
        let both = casters([(glass(), 3.0, 1.5), (glass(), 2.0, 0.3)]);
        let seen = both.seen_from(Vec3::ZERO);
        let (n, mut inside, mut reciprocal) = (200_000, 0, 0.0);
        for i in 0..n {
            let mut numbers = Stream::new(1, i, 0).at(0, Purpose::Direction);
            let wi = seen.sample(numbers.one(), numbers.two());
            let pdf = seen.pdf(wi);
            assert!(pdf > 0.0, "{wi}");
            inside += u32::from(wi.x > f32::sqrt(1.0 - 0.15 * 0.15));
            reciprocal += 1.0 / f64::from(pdf);
        }
        // The mean of 1 / pdf is the solid angle of all directions that are drawn.
        let solid_angle = |sin: f64| std::f64::consts::TAU * (1.0 - (1.0 - sin * sin).sqrt());
        let measured = reciprocal / f64::from(n);
        assert!(
            (measured / solid_angle(0.5) - 1.0).abs() < 0.01,
            "{measured}"
        );
        // All of the narrow cone's, and its share of the wide one's.
        let share = 0.5 + 0.5 * solid_angle(0.15) / solid_angle(0.5);
        assert!((f64::from(inside) / f64::from(n) - share).abs() < 0.005);
    }
}
