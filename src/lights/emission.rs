//! Light as it leaves its source: the first ray of a path that starts at a light.
//!
//! Source: Arvo, Backward Ray Tracing (SIGGRAPH course notes 1986); Dutré, Bala, Bekaert, Advanced Global
//! Illumination (2006), chapter 5.

use super::bounding_sphere::BoundingSphere;
use super::targets::{Emitter, Targets};
use super::{Light, LightBounds, mean, triangle};
use crate::color::Rgb;
use crate::geometry::{Aabb, Ray, Surface};
use crate::sampling::discrete::Discrete;
use crate::sampling::frame::Frame;
use crate::sampling::warps;
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
    /// True for a light without extent: see [`Light::is_delta`].
    pub is_delta: bool,
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

impl BoundingSphere {
    /// Light from infinitely far away in the unit direction `from`, whose ray passes its centre at `across`.
    fn pass(&self, from: Vec3, across: Vec3, emitted: Rgb, over_density: f64) -> EmissionSample {
        EmissionSample {
            ray: Ray::new(self.center + across + from * self.radius, -from),
            emitted,
            over_density: over_density as f32,
            part: 0,
            place: [0.0; 2],
            n: -from,
            is_delta: false,
        }
    }
}

/// Where light leaves its source, before it is known in which direction.
enum Origin {
    /// A point.
    Near(Place),
    /// Infinitely far away in the unit direction `from`.
    Afar {
        from: Vec3,
        emitted: Rgb,
        /// One over the density of the direction, in sr, or 1 for the only one.
        over_density: f64,
    },
}

/// A point that light leaves, drawn uniformly in area where it is one of a surface.
struct Place {
    from: Surface,
    emitter: Emitter,
    emitted: Rgb,
    /// The area, or 1 for a point without one.
    area: f64,
    part: u32,
    place: [f32; 2],
}

impl Place {
    /// Light that leaves it in the unit direction `w`.
    ///
    /// * `over_density`: the cosine there over the density of `w`.
    fn leave(self, w: Vec3, over_density: f64) -> EmissionSample {
        let n = match self.emitter {
            Emitter::Point => w,
            Emitter::OneSided(n) => n,
            Emitter::TwoSided(n) => n * 1_f32.copysign(n.dot(w)),
        };
        EmissionSample {
            ray: match self.emitter {
                Emitter::Point => Ray::new(self.from.p, w),
                Emitter::OneSided(_) | Emitter::TwoSided(_) => self.from.spawn(w),
            },
            emitted: self.emitted,
            over_density: (self.area * over_density) as f32,
            part: self.part,
            place: self.place,
            n,
            is_delta: self.emitter == Emitter::Point,
        }
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
        around: &BoundingSphere,
        by: Vec3,
        u: EmissionUniforms,
    ) -> Option<EmissionSample> {
        Some(match self.origin(by, u.pick, u.place)? {
            Origin::Near(place) => {
                let w = place.emitter.sample(u.direction).normalize();
                let over_density = place.emitter.cos_over_pdf();
                place.leave(w, over_density)
            }
            Origin::Afar {
                from,
                emitted,
                over_density,
            } => {
                let aside = warps::sample_disk_concentric(u.direction) * around.radius;
                let across = Frame::new(from).to_world(aside.extend(0.0));
                EmissionSample {
                    is_delta: self.is_delta(),
                    ..around.pass(from, across, emitted, over_density * around.disc())
                }
            }
        })
    }

    /// Draws a ray along which the light emits towards one of the balls of `targets`; `None` where none of them is
    /// on the side that shines, for a light of one's own and where there are no balls.
    ///
    /// Points are drawn as by [`Light::sample_emission`], and so are directions of light from infinitely far
    /// away; but rays go where the balls are, and what would miss them all is never drawn.
    ///
    /// * `aim` in `[0, 1)` chooses the ball.
    pub fn sample_emission_towards(
        &self,
        targets: &Targets,
        around: &BoundingSphere,
        by: Vec3,
        u: EmissionUniforms,
        aim: f32,
    ) -> Option<EmissionSample> {
        match self.origin(by, u.pick, u.place)? {
            Origin::Near(place) => {
                let Place { from, emitter, .. } = place;
                let (w, pdf) = targets.sample_direction(from.p, emitter, aim, u.direction)?;
                let cos = emitter.cos(w);
                (cos > 0.0).then(|| place.leave(w, f64::from(cos) / f64::from(pdf)))
            }
            Origin::Afar {
                from,
                emitted,
                over_density,
            } => {
                let (across, pdf) = targets.sample_line(around, from, aim, u.direction)?;
                Some(EmissionSample {
                    is_delta: self.is_delta(),
                    ..around.pass(from, across, emitted, over_density / pdf)
                })
            }
        }
    }

    /// Draws where light leaves it, for `pick` and `place` of [`EmissionUniforms`].
    fn origin(&self, by: Vec3, pick: f64, place: [f32; 2]) -> Option<Origin> {
        let near = |from, emitter, emitted, area, part, place| {
            Origin::Near(Place {
                from,
                emitter,
                emitted,
                area,
                part,
                place,
            })
        };
        let afar = |from, emitted, over_density| Origin::Afar {
            from,
            emitted,
            over_density,
        };
        Some(match self {
            Light::Point(l) => {
                let from = Surface {
                    p: l.position,
                    error: Vec3::ZERO,
                    n: Vec3::Z,
                    time: 0.0,
                };
                near(from, Emitter::Point, l.intensity, 1.0, 0, [0.0; 2])
            }
            Light::Directional(l) => afar(l.from, l.irradiance, 1.0),
            Light::Environment(l) => {
                let (from, pdf) = l.sample_direction(pick, place)?;
                afar(from, l.radiance(from), 1.0 / f64::from(pdf))
            }
            Light::Sky(l) => {
                let from = warps::sample_sphere(place).normalize();
                afar(from, l.radiance, 1.0 / f64::from(warps::pdf_sphere()))
            }
            Light::Quad(l) => {
                let [s, t] = place;
                let quad = l.quad().moved(by);
                let mut from = quad.surface_at(s, t);
                from.error += l.quad().bend(&quad);
                let emitter = Emitter::of(from.n, l.is_two_sided());
                near(
                    from,
                    emitter,
                    l.radiance(),
                    f64::from(quad.area()),
                    0,
                    place,
                )
            }
            Light::Sphere(l) => {
                let mut sphere = l.sphere;
                sphere.center += by;
                let from =
                    sphere.surface_towards(warps::sample_sphere(place).as_dvec3().normalize());
                near(
                    from,
                    Emitter::OneSided(from.n),
                    l.radiance,
                    l.area(),
                    0,
                    [0.0; 2],
                )
            }
            Light::Triangle(l) => {
                let place = warps::sample_triangle(place);
                let from = triangle::at(&l.triangle.moved(by), place[0], place[1]);
                let emitter = Emitter::of(from.n, l.two_sided);
                near(from, emitter, l.radiance, l.triangle.area(), 0, place)
            }
            Light::Mesh(l) => {
                let (part, place) = l.sample_point(pick, place);
                let from = triangle::at(&l.triangles()[part].moved(by), place[0], place[1]);
                let emitter = Emitter::of(from.n, l.is_two_sided());
                near(from, emitter, l.radiance(), l.area(), part as u32, place)
            }
            Light::Custom(_) => return None,
        })
    }

    /// The power that [`Light::sample_emission`] has in the mean, in W, mean over channels: of light from
    /// infinitely far away, what passes the cross-section of `around`.
    pub fn power(&self, around: &BoundingSphere) -> f64 {
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

/// Chooses the light of a scene that a path starts from, by its power.
#[derive(Clone, Debug, Default)]
pub struct EmissionChoice {
    by_power: Option<Discrete>,
    around: BoundingSphere,
    /// Where its rays go; none for everywhere.
    targets: Targets,
}

/// The share of the power of all its rays by which a light is at least chosen, where rays are aimed.
const LEAST_AIMED: f64 = 0.01;

impl EmissionChoice {
    /// The choice among `lights`, around all that stands within `bounds`.
    pub fn new(lights: &[Light], bounds: Aabb) -> Self {
        let around = BoundingSphere::of(bounds);
        EmissionChoice {
            by_power: Discrete::new(lights.iter().map(|light| light.power(&around))),
            around,
            targets: Targets::default(),
        }
    }

    /// The choice for rays that are aimed at `targets`, by the power that they may get; a sky of one colour is never
    /// chosen.
    pub fn towards(lights: &[Light], bounds: Aabb, targets: Targets) -> Self {
        let around = BoundingSphere::of(bounds);
        let aimed = |light: &Light| match LightBounds::of(light) {
            _ if targets.is_empty() || matches!(light, Light::Sky(_)) => 0.0,
            Some(bounds) => {
                let at = |ball: &BoundingSphere| bounds.fluence(ball.center) * ball.disc();
                let sum: f64 = targets.balls().iter().map(at).sum();
                let power = light.power(&around);
                sum.clamp(LEAST_AIMED * power, power)
            }
            None => {
                let area: f64 = targets.balls().iter().map(BoundingSphere::disc).sum();
                light.power(&around) * (area / around.disc()).min(1.0)
            }
        };
        EmissionChoice {
            by_power: Discrete::new(lights.iter().map(aimed)),
            around,
            targets,
        }
    }

    /// The ball around the scene.
    pub fn around(&self) -> &BoundingSphere {
        &self.around
    }

    /// Where rays are aimed; none for everywhere.
    pub fn targets(&self) -> &Targets {
        &self.targets
    }

    /// True where no light is ever chosen.
    pub fn is_dark(&self) -> bool {
        self.by_power.is_none()
    }

    /// The index of a light, its probability and a uniform that is left of `u` in `[0, 1)`; `None` where
    /// none emits.
    pub fn choose(&self, u: f64) -> Option<(usize, f32, f64)> {
        let chosen = self.by_power.as_ref()?.sample(u);
        Some((chosen.index, chosen.probability, chosen.rest))
    }
}
