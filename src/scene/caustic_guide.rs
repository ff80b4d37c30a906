//! What focuses light: perfectly specular objects, as targets for rays that look for their light.

use super::Object;
use super::ball::{Ball, Sight};
use super::images::{Image, VirtualLight, Way};
use super::motion::PlacedInstance;
use crate::geometry::Shape;
use crate::materials::{Bsdf, Material};
use crate::sampling::{frame::Frame, warps};
use arrayvec::ArrayVec;
use glam::Vec3;

/// With more objects than this nobody aims at them: each asks for its angle at every surface.
const MOST: usize = 8;
/// With more lamps in them than this nobody aims at those.
const MOST_IMAGES: usize = 8;

/// The share of rays that look anywhere at them, where a point sees some.
const AT_CASTERS: f32 = 0.2;
/// The share that looks at lamps in them, where the lamps themselves are nothing beside these.
const AT_IMAGES: f32 = 0.6;

/// How a mirror shows a lamp.
const MIRROR: [Way; 1] = [Way {
    ior: None,
    crossings: 0,
    strength: 1.0,
}];
/// In how many ways glass does.
const WAYS: usize = 2;

/// Through the ball, and reflected by it, which is roughly a tenth of the light. Images by reflection
/// within the ball cost more time than they save.
fn through(ior: f32) -> [Way; WAYS] {
    [(1, 1.0), (0, 0.1)].map(|(crossings, strength)| Way {
        ior: Some(f64::from(ior)),
        crossings,
        strength,
    })
}

/// Balls around the specular objects of a scene, and lamps that are seen in those which are balls.
///
/// Light that reaches a diffuse surface by way of a mirror or glass is found by chance only, for no
/// shadow ray goes round a corner; but where such light may come from is known. Directions into the
/// cones in which these balls are seen find it more often, and those to the images of lamps in them
/// more often still. Jensen, Global Illumination Using Photon Maps (Rendering Techniques 1996),
/// "Projection maps", sends photons there for the same reason.
#[derive(Clone, Debug, Default)]
pub struct CausticGuide {
    all: Vec<Caster>,
    /// Balls around the lamps that are seen in them.
    lamps: Vec<Ball>,
}

/// A specular object.
#[derive(Clone, Debug)]
struct Caster {
    ball: Ball,
    /// Seen in it, where it is a ball.
    lamps: Vec<VirtualLight>,
}

impl CausticGuide {
    /// Those among the objects of a scene; `owners` are the objects that the shapes belong to.
    pub(super) fn new(
        objects: &[Object],
        shapes: &[Shape],
        owners: &[u32],
        instances: &[PlacedInstance],
    ) -> Self {
        let among = |which: fn(&Object) -> bool| {
            let ids = (0..).zip(objects).filter(move |(_, object)| which(object));
            ids.map(|(id, _)| id).take(MOST + 1).collect::<Vec<u32>>()
        };
        let shapes_of = |id: u32| {
            let all = owners.iter().zip(shapes);
            let its = all.filter(move |(owner, _)| **owner == id);
            let placed = instances.iter().filter(move |placed| placed.object == id);
            let triangles = placed.flat_map(PlacedInstance::triangles);
            let its = its.map(|(_, shape)| *shape);
            its.chain(triangles.map(Shape::Triangle))
                .collect::<Vec<_>>()
        };
        let specular = among(|object| {
            object
                .material
                .as_ref()
                .is_some_and(|m| !m.brightest().is_smooth())
        });
        let bright = among(|object| object.light.is_some());
        if specular.len() > MOST {
            return CausticGuide::default();
        }
        let mut lamps: Vec<Ball> = Vec::new();
        if bright.len() * specular.len() * WAYS <= MOST_IMAGES {
            let balls = bright.iter().map(|id| Ball::around(&shapes_of(*id)));
            lamps.extend(balls.flatten());
        }
        let caster = |id: u32| {
            let shapes = shapes_of(id);
            let ball = Ball::around(&shapes)?;
            let material = objects[id as usize]
                .material
                .as_ref()
                .map(Material::brightest);
            let ways = match (shapes.as_slice(), material) {
                ([Shape::Sphere(_)], Some(Bsdf::Mirror(_))) => MIRROR.to_vec(),
                ([Shape::Sphere(_)], Some(Bsdf::Glass(glass))) => through(glass.ior).to_vec(),
                _ => Vec::new(),
            };
            let seen = ways.iter().flat_map(|way| {
                let lamps = lamps.iter();
                lamps.filter_map(|lamp| VirtualLight::new(&ball, lamp, *way))
            });
            let lamps = seen.collect();
            Some(Caster { ball, lamps })
        };
        let mut all: Vec<Caster> = Vec::new();
        for caster in specular.into_iter().filter_map(caster) {
            // Two in one place are looked at once.
            if all.iter().all(|other| other.ball != caster.ball) {
                all.push(caster);
            }
        }
        CausticGuide { all, lamps }
    }

    /// True where nothing focuses light.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// How many objects focus light and are aimed at.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Those that can be aimed at from `p`: it is not within their balls.
    #[inline(always)]
    pub fn seen_from(&self, p: Vec3) -> GuideAt {
        let mut seen = GuideAt::default();
        for caster in &self.all {
            let Some(sight) = caster.ball.seen_from(p) else {
                continue;
            };
            seen.cones.push(sight);
            for lamp in &caster.lamps {
                if let Some(image) = lamp.seen_in(&sight) {
                    seen.worth += image.worth();
                    seen.images.push(image);
                }
            }
        }
        if seen.worth > 0.0 {
            let direct: f32 = self.lamps.iter().map(|lamp| lamp.solid_angle(p)).sum();
            seen.at_images = AT_IMAGES * seen.worth / (seen.worth + direct);
        }
        seen
    }
}

/// The cones in which specular objects are seen from a point, and the lamps in them.
#[derive(Debug, Default)]
pub struct GuideAt {
    cones: ArrayVec<Sight, MOST>,
    images: ArrayVec<Image, MOST_IMAGES>,
    /// What the images are worth together.
    worth: f32,
    /// The share of all rays that looks at images.
    at_images: f32,
}

impl GuideAt {
    /// True where none is seen.
    pub fn is_empty(&self) -> bool {
        self.cones.is_empty()
    }

    /// The share of all rays from here that had better look at them.
    ///
    /// The more, the more light comes from lamps in them, compared with what the lamps themselves
    /// would give.
    pub fn share(&self) -> f32 {
        AT_CASTERS + self.at_images
    }

    /// Draws a direction: one of the cones, each as likely, and in it any direction, uniformly in
    /// solid angle; or a lamp in one of them. Not for none.
    ///
    /// Density: [`GuideAt::pdf`], in 1/sr.
    pub fn sample(&self, choice: f32, u: [f32; 2]) -> Vec3 {
        let choice = choice * self.share();
        if choice < self.at_images {
            let mut rest = choice / self.at_images * self.worth;
            let chosen = self.images.iter().find(|image| {
                rest -= image.worth();
                rest < 0.0
            });
            if let Some(image) = chosen.or(self.images.last()) {
                return image.sample(u);
            }
        }
        let choice = (choice - self.at_images) / AT_CASTERS;
        let index = (choice * self.cones.len() as f32) as usize;
        let cone = self.cones[index.min(self.cones.len() - 1)];
        Frame::new(cone.axis).to_world(warps::sample_cone(u, cone.one_minus_cos))
    }

    /// Density of [`GuideAt::sample`] at the unit direction `wi`, in 1/sr.
    pub fn pdf(&self, wi: Vec3) -> f32 {
        let inside = self.cones.iter().filter(|cone| {
            // 1 - cos of the angle between unit vectors, in which nothing cancels.
            0.5 * (wi - cone.axis).length_squared() <= cone.one_minus_cos
        });
        let sum: f32 = inside.map(|cone| warps::pdf_cone(cone.one_minus_cos)).sum();
        if sum == 0.0 {
            return 0.0;
        }
        let mut pdf = AT_CASTERS * sum / self.cones.len() as f32;
        if self.at_images > 0.0 {
            // Each is drawn by its worth, and in it all directions evenly: of its solid angle only
            // the strength is left.
            let shown = self.images.iter().filter(|image| image.shows(wi));
            let strength: f32 = shown.map(|image| image.strength).sum();
            pdf += self.at_images * strength / self.worth;
        }
        pdf / self.share()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::geometry::Sphere;
    use crate::materials::{Bsdf, Glass, Lambert, Material, Mirror};
    use crate::sampling::stream::{Purpose, Stream};
    use crate::stats::Estimate;

    fn glass() -> Material {
        Bsdf::Glass(Glass { ior: 1.5 }).into()
    }

    /// Balls on the x axis.
    fn casters<const N: usize>(balls: [(Material, f32, f32); N]) -> CausticGuide {
        let shape = |x, radius| Shape::Sphere(Sphere::new(Vec3::new(x, 0.0, 0.0), radius));
        let owners: Vec<u32> = (0..N as u32).collect();
        let shapes: Vec<Shape> = balls
            .iter()
            .map(|(_, x, radius)| shape(*x, *radius))
            .collect();
        let objects = balls.map(|(material, _, _)| Object {
            material: Some(material),
            ..Object::default()
        });
        CausticGuide::new(&objects, &shapes, &owners, &[])
    }

    #[test]
    fn only_what_focuses_and_is_not_around_us() {
        let white = Bsdf::Lambert(Lambert { albedo: Rgb::WHITE }).into();
        let casters = casters([(glass(), 3.0, 1.0), (white, -3.0, 1.0), (glass(), 0.0, 9.0)]);
        let seen = casters.seen_from(Vec3::ZERO);
        assert_eq!((casters.len(), seen.cones.len()), (2, 1));
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

    #[test]
    fn directions_to_lamps_follow_their_density_too() {
        // A lamp behind a glass ball that is before us, and a mirror ball beside us.
        let mirror = Bsdf::Mirror(Mirror {
            reflectance: Rgb::WHITE,
        });
        let object = |material: Option<Material>| Object {
            light: material.is_none().then_some(0),
            material,
            ..Object::default()
        };
        let ball = |x, y, radius| Shape::Sphere(Sphere::new(Vec3::new(x, y, 0.0), radius));
        let objects = [Some(glass()), Some(mirror.into()), None].map(object);
        let shapes = [
            ball(1.5, 0.0, 1.0),
            ball(0.0, 4.0, 1.5),
            ball(6.0, 0.5, 0.5),
        ];
        let casters = CausticGuide::new(&objects, &shapes, &[0, 1, 2], &[]);
        let seen = casters.seen_from(Vec3::ZERO);
        // The lamp is behind the glass, which does not reflect it this way.
        assert_eq!((seen.cones.len(), seen.images.len()), (2, 2));
        assert!(seen.share() > AT_CASTERS + 0.2, "{}", seen.share());
        // Of directions drawn: the mean of 1 / pdf, and how many the largest image shows.
        let through = &seen.images[0];
        let (mut reciprocal, mut shown) = (Estimate::new(), Estimate::new());
        let (mut by_density, mut without_lamps) = (Estimate::new(), 0.0);
        let cone = |sight: &Sight| std::f64::consts::TAU * f64::from(sight.one_minus_cos);
        for i in 0..200_000 {
            let mut numbers = Stream::new(1, i, 0).at(0, Purpose::Direction);
            let wi = seen.sample(numbers.one(), numbers.two()).normalize();
            reciprocal.add(1.0 / f64::from(seen.pdf(wi)));
            shown.add(f64::from(u8::from(through.shows(wi))));
            // The same by directions that are drawn evenly, and by the density alone.
            let sight = &seen.cones[0];
            let local = warps::sample_cone(numbers.two(), sight.one_minus_cos);
            let wi = Frame::new(sight.axis).to_world(local).normalize();
            let value = f64::from(u8::from(through.shows(wi))) * cone(sight);
            by_density.add(value * f64::from(seen.pdf(wi)));
            without_lamps += value / (cone(sight) * 2.0) / 200_000.0;
        }
        let solid_angle: f64 = seen.cones.iter().map(cone).sum();
        assert!(reciprocal.z(solid_angle).abs() < 4.4, "{reciprocal:?}");
        let difference = shown.mean() - by_density.mean();
        let error = shown.std_error().hypot(by_density.std_error());
        assert!(difference.abs() < 4.4 * error, "{difference} ± {error}");
        assert!(
            shown.z(without_lamps) > 44.0,
            "a density that knows no lamps is noticed"
        );
    }
}
