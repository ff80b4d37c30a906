//! Light as it leaves its source: the first ray of a path that starts at a light.
//!
//! Source: Arvo, Backward Ray Tracing (SIGGRAPH course notes 1986); Dutré, Bala, Bekaert, Advanced Global
//! Illumination (2006), chapter 5.

use super::{Light, mean, triangle};
use crate::color::Rgb;
use crate::geometry::{Aabb, Ray, Surface};
use crate::sampling::discrete::Discrete;
use crate::sampling::frame::Frame;
use crate::sampling::{as_uniform, hemisphere, warps};
use glam::Vec3;
use std::f64::consts::PI;

/// A ray along which light leaves a light.
#[derive(Clone, Copy, Debug)]
pub struct EmissionSample {
    /// The ray, from the light on; of a light that is infinitely far away, from a disc outside the scene.
    pub ray: Ray,
    /// What is emitted along it: radiance in W/(m² sr); of a point its intensity in W/sr, of a direction its
    /// irradiance in W/m².
    pub emitted: Rgb,
    /// The cosine at the light over the density of the ray, in units that make of `emitted` a power.
    pub over_density: f32,
    /// Which of the light's surfaces it leaves: the number of a triangle of a mesh, 0 for all other lights.
    pub part: u32,
    /// The point on a quad or triangle, as in [`Intersection`](crate::geometry::Intersection).
    pub place: [f32; 2],
    /// The unit normal on the side that the ray leaves; of lights without a surface, its direction.
    pub n: Vec3,
}

impl EmissionSample {
    /// The power that the ray stands for, in W: its mean is all the power of the light.
    pub fn power(&self) -> Rgb {
        self.emitted * self.over_density
    }
}

/// The uniforms of one emission.
#[derive(Clone, Copy, Debug)]
pub struct EmissionUniforms {
    /// In `[0, 1)`; refines `place` where one of many is chosen, a triangle of a mesh or a pixel of an image.
    pub pick: f64,
    /// In `[0, 1)²`: a point of the light, or the direction of one that is infinitely far away.
    pub place: [f32; 2],
    /// In `[0, 1)²`: the direction in which the ray leaves the point, or the point of the disc that it
    /// passes.
    pub direction: [f32; 2],
}

/// A ball around all that rays can meet: light from infinitely far away passes through it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Surroundings {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, in scene units; 0 where there is nothing.
    pub radius: f32,
}

impl Surroundings {
    /// The ball around a box.
    pub fn of(bounds: Aabb) -> Self {
        if !bounds.is_finite() {
            return Surroundings::default();
        }
        let center = bounds.center();
        let radius = (bounds.max - center)
            .length()
            .max((center - bounds.min).length());
        Surroundings {
            center,
            // Rounded outwards.
            radius: radius * (1.0 + 4.0 * f32::EPSILON),
        }
    }

    /// Area of its cross-section.
    fn disc(&self) -> f64 {
        PI * f64::from(self.radius).powi(2)
    }

    /// A ray through it against the unit direction `from`, through a uniform point of its cross-section.
    fn ray(&self, from: Vec3, u: [f32; 2]) -> Ray {
        let aside = warps::sample_disk_concentric(u) * self.radius;
        let across = Frame::new(from).to_world(aside.extend(0.0));
        Ray::new(self.center + across + from * self.radius, -from)
    }
}

impl Light {
    /// Draws a ray along which the light emits, moved by a vector as [`Light::sample_moved`] moves it;
    /// `None` where rounding takes it to nothing, and for a light of one's own.
    ///
    /// A point of a surface is uniform in area and its direction is drawn by the cosine; a point light
    /// emits uniformly over the sphere. Light from infinitely far away comes from a direction drawn as
    /// [`Light::sample`] draws it, of a sky of one colour uniformly, and passes a uniform point of the
    /// cross-section of `around`.
    pub fn sample_emission(
        &self,
        around: &Surroundings,
        by: Vec3,
        u: EmissionUniforms,
    ) -> Option<EmissionSample> {
        let beyond = |from: Vec3, emitted: Rgb, over_density: f64| EmissionSample {
            ray: around.ray(from, u.direction),
            emitted,
            over_density: (over_density * around.disc()) as f32,
            part: 0,
            place: [0.0; 2],
            n: -from,
        };
        match self {
            Light::Point(l) => {
                let direction = warps::sample_sphere(u.direction).normalize();
                Some(EmissionSample {
                    ray: Ray::new(l.position, direction),
                    emitted: l.intensity,
                    over_density: (1.0 / warps::pdf_sphere()),
                    part: 0,
                    place: [0.0; 2],
                    n: direction,
                })
            }
            Light::Directional(l) => Some(beyond(l.from, l.irradiance, 1.0)),
            Light::Environment(l) => {
                let (from, pdf) = l.sample_direction(u.pick, u.place)?;
                Some(beyond(from, l.radiance(from), 1.0 / f64::from(pdf)))
            }
            Light::Sky(l) => {
                let from = warps::sample_sphere(u.place).normalize();
                Some(beyond(
                    from,
                    l.radiance,
                    1.0 / f64::from(warps::pdf_sphere()),
                ))
            }
            Light::Quad(l) => {
                let [s, t] = u.place;
                let quad = l.quad().moved(by);
                let mut from = quad.surface_at(s, t);
                from.error += l.quad().bend(&quad);
                let area = f64::from(quad.area());
                let sample = leave(from, l.is_two_sided(), area, l.radiance(), u.direction);
                Some(EmissionSample {
                    place: [s, t],
                    ..sample
                })
            }
            Light::Sphere(l) => {
                let mut sphere = l.sphere;
                sphere.center += by;
                let from =
                    sphere.surface_towards(warps::sample_sphere(u.place).as_dvec3().normalize());
                Some(leave(from, false, l.area(), l.radiance, u.direction))
            }
            Light::Triangle(l) => {
                let place = warps::sample_triangle(u.place);
                let from = triangle::at(&l.triangle.moved(by), place[0], place[1]);
                let sample = leave(
                    from,
                    l.two_sided,
                    l.triangle.area(),
                    l.radiance,
                    u.direction,
                );
                Some(EmissionSample { place, ..sample })
            }
            Light::Mesh(l) => {
                let (part, place) = l.sample_point(u.pick, u.place);
                let from = triangle::at(&l.triangles()[part].moved(by), place[0], place[1]);
                let sample = leave(from, l.is_two_sided(), l.area(), l.radiance(), u.direction);
                let part = part as u32;
                Some(EmissionSample {
                    part,
                    place,
                    ..sample
                })
            }
            Light::Custom(_) => None,
        }
    }

    /// The power that [`Light::sample_emission`] has in the mean, in W, mean over channels: of light from
    /// infinitely far away, what passes the cross-section of `around`.
    pub fn power(&self, around: &Surroundings) -> f64 {
        let sides = |two_sided: bool| if two_sided { 2.0 } else { 1.0 };
        match self {
            Light::Point(l) => 4.0 * PI * mean(l.intensity),
            Light::Quad(l) => {
                PI * f64::from(l.quad().area()) * sides(l.is_two_sided()) * mean(l.radiance())
            }
            Light::Sphere(l) => PI * l.area() * mean(l.radiance),
            Light::Triangle(l) => PI * l.triangle.area() * sides(l.two_sided) * mean(l.radiance),
            Light::Mesh(l) => PI * l.area() * sides(l.is_two_sided()) * mean(l.radiance()),
            Light::Directional(_) | Light::Environment(_) | Light::Sky(_) => {
                self.fluence_from_afar() * around.disc()
            }
            Light::Custom(_) => 0.0,
        }
    }
}

/// Light that leaves the point `from` of a surface of this area on its normal's side, or on both.
fn leave(
    from: Surface,
    two_sided: bool,
    area: f64,
    radiance: Rgb,
    [a, b]: [f32; 2],
) -> EmissionSample {
    // One half of the uniforms for each side.
    let (n, a, sides) = match two_sided {
        false => (from.n, a, 1.0),
        true if a < 0.5 => (from.n, 2.0 * a, 2.0),
        true => (-from.n, as_uniform(2.0 * a - 1.0), 2.0),
    };
    let local = hemisphere::sample_cosine([a, b]);
    let direction = Frame::new(n).to_world(local).normalize();
    EmissionSample {
        ray: from.spawn(direction),
        emitted: radiance,
        // cos θ over the density cos θ / (π A).
        over_density: (PI * area * sides) as f32,
        part: 0,
        place: [0.0; 2],
        n,
    }
}

/// Chooses the light of a scene that a path starts from, by its power.
#[derive(Clone, Debug, Default)]
pub struct EmissionChoice {
    by_power: Option<Discrete>,
    around: Surroundings,
}

impl EmissionChoice {
    /// The choice among `lights`, around all that stands within `bounds`.
    pub fn new(lights: &[Light], bounds: Aabb) -> Self {
        let around = Surroundings::of(bounds);
        EmissionChoice {
            by_power: Discrete::new(lights.iter().map(|light| light.power(&around))),
            around,
        }
    }

    /// The ball around the scene.
    pub fn around(&self) -> &Surroundings {
        &self.around
    }

    /// The index of a light, its probability and a uniform that is left of `u` in `[0, 1)`; `None` where
    /// none emits.
    pub fn choose(&self, u: f64) -> Option<(usize, f32, f64)> {
        let chosen = self.by_power.as_ref()?.sample(u);
        Some((chosen.index, chosen.probability, chosen.rest))
    }
}
