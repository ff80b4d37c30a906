//! Where lights are, which way they shine and how strong they are: what a light tree goes by.

use super::{Light, mean};
use crate::geometry::{Aabb, Shape};
use glam::{DVec3, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A bound on the light of one light, or of several, that are not infinitely far away.
///
/// Source: Conty Estevez, Kulla, Importance Sampling of Many Lights with Adaptive Tree Splitting
/// (PACMCGIT 1(2), 2018).
#[derive(Clone, Copy, Debug)]
pub struct LightBounds {
    aabb: Aabb,
    normals: Cone,
    /// Radiant intensity in W/sr, mean over channels, in the direction in which it is largest.
    intensity: f64,
}

/// A cone around the normals of surfaces that shine; each shines up to a right angle from its normal.
#[derive(Clone, Copy, Debug)]
struct Cone {
    /// Unit.
    axis: DVec3,
    /// Between the axis and the outermost normal, in radians.
    angle: f64,
    sin: f64,
    cos: f64,
}

impl Cone {
    /// All directions.
    const ALL: Cone = Cone {
        axis: DVec3::Z,
        angle: PI,
        sin: 0.0,
        cos: -1.0,
    };

    fn new(axis: DVec3, angle: f64) -> Cone {
        match axis.try_normalize() {
            Some(axis) if angle < PI => {
                let (sin, cos) = libm::sincos(angle);
                Cone {
                    axis,
                    angle,
                    sin,
                    cos,
                }
            }
            _ => Cone::ALL,
        }
    }

    /// The smallest cone around both.
    fn union(self, other: Cone) -> Cone {
        let (wide, narrow) = if self.angle >= other.angle {
            (self, other)
        } else {
            (other, self)
        };
        let between = angle(wide.axis, narrow.axis);
        if between + narrow.angle <= wide.angle {
            return wide;
        }
        let half = 0.5 * (wide.angle + between + narrow.angle);
        if half >= PI {
            return Cone::ALL;
        }
        // Turned from the wide one's axis towards the other's.
        let (sin, cos) = libm::sincos(half - wide.angle);
        let across = narrow.axis - wide.axis * wide.axis.dot(narrow.axis);
        match across.try_normalize() {
            Some(across) => Cone::new(wide.axis * cos + across * sin, half),
            None => Cone::ALL,
        }
    }

    /// The solid angle in which any of the surfaces shines, each weighted by its cosine: Conty
    /// Estevez, Kulla 2018, equation 1.
    fn measure(&self) -> f64 {
        let outer = (self.angle + FRAC_PI_2).min(PI);
        2.0 * PI * (1.0 - self.cos)
            + FRAC_PI_2
                * (2.0 * outer * self.sin
                    - libm::cos(self.angle - 2.0 * outer)
                    - 2.0 * self.angle * self.sin
                    + self.cos)
    }
}

/// The angle between two unit vectors, without loss of digits where it is small.
fn angle(a: DVec3, b: DVec3) -> f64 {
    2.0 * libm::atan2((a - b).length(), (a + b).length())
}

/// Larger than any value that counts: sums of two stay finite.
const LARGEST: f64 = f64::MAX / 4.0;

impl LightBounds {
    /// The bound of a light; `None` for one that is infinitely far away.
    pub fn of(light: &Light) -> Option<LightBounds> {
        let flat = |n: Vec3, two_sided: bool| match two_sided {
            true => Cone::ALL,
            false => Cone::new(n.as_dvec3(), 0.0),
        };
        let (aabb, normals, intensity) = match light {
            Light::Point(l) => (Aabb::of([l.position]), Cone::ALL, mean(l.intensity)),
            Light::Quad(l) => (
                l.quad().bounds(),
                flat(l.quad().normal(), l.is_two_sided()),
                f64::from(l.quad().area()) * mean(l.radiance()),
            ),
            Light::Sphere(l) => (
                Shape::Sphere(l.sphere).bounds(),
                Cone::ALL,
                0.25 * l.area() * mean(l.radiance),
            ),
            Light::Triangle(l) => (
                l.triangle.bounds(),
                flat(l.triangle.normal(), l.two_sided),
                l.triangle.area() * mean(l.radiance),
            ),
            Light::Mesh(l) => {
                let each = l.triangles().iter();
                let cones = each.clone().map(|t| flat(t.normal(), l.is_two_sided()));
                (
                    each.map(|t| t.bounds()).reduce(Aabb::union)?,
                    cones.reduce(Cone::union)?,
                    l.area() * mean(l.radiance()),
                )
            }
            Light::Directional(_) | Light::Environment(_) | Light::Sky(_) | Light::Custom(_) => {
                return None;
            }
        };
        Some(LightBounds {
            aabb,
            normals,
            intensity,
        })
    }

    /// The same for a light that moves by `span` while the shutter is open.
    #[must_use]
    pub fn swept(self, span: Vec3) -> LightBounds {
        let moved = Aabb {
            min: self.aabb.min + span,
            max: self.aabb.max + span,
        };
        LightBounds {
            aabb: self.aabb.union(moved),
            ..self
        }
    }

    /// The bound of both.
    #[must_use]
    pub fn union(self, other: LightBounds) -> LightBounds {
        LightBounds {
            aabb: self.aabb.union(other.aabb),
            normals: self.normals.union(other.normals),
            intensity: self.intensity + other.intensity,
        }
    }

    /// The middle of the box.
    pub fn center(&self) -> Vec3 {
        self.aabb.center()
    }

    /// The lengths of the box.
    pub fn size(&self) -> DVec3 {
        self.aabb.max.as_dvec3() - self.aabb.min.as_dvec3()
    }

    /// What grouping these lights costs: the more light they send, the farther apart they are and
    /// the more their normals differ.
    pub fn cost(&self) -> f64 {
        let size = self.size();
        // Lights on a line have no area.
        let area = self.aabb.half_area() + size.max_element() * size.max_element();
        self.intensity * area * self.normals.measure()
    }

    /// About the fluence at `p`, in W/m², if nothing were in the way: the intensity towards `p` over
    /// the square of the distance. Finite; 0 only where all normals point away.
    ///
    /// * Within the ball around the box all directions and the radius count: no light is nearer than
    ///   its own size allows.
    pub fn fluence(&self, p: Vec3) -> f64 {
        let center = 0.5 * (self.aabb.min.as_dvec3() + self.aabb.max.as_dvec3());
        let way = p.as_dvec3() - center;
        let radius2 = 0.25 * self.size().length_squared();
        let distance2 = way.length_squared();
        let cos = if distance2 <= radius2 || self.normals.angle >= PI {
            1.0
        } else {
            self.largest_cos(way / distance2.sqrt(), radius2 / distance2)
        };
        (self.intensity * cos / distance2.max(radius2)).min(LARGEST)
    }

    /// The largest cosine that any normal can have to the direction of a point that is seen along
    /// the unit vector `w`, where the square of the sine of half the angle of the ball around the box
    /// is `sin2`; 0 where all point away.
    fn largest_cos(&self, w: DVec3, sin2: f64) -> f64 {
        let cone = &self.normals;
        let (cos_w, cos_ball) = (cone.axis.dot(w).clamp(-1.0, 1.0), (1.0 - sin2).sqrt());
        let sin_w = (1.0 - cos_w * cos_w).sqrt();
        // The angle to the axis less those of the cone and of the ball, each not below zero.
        let (sin, cos) = less((sin_w, cos_w), (cone.sin, cone.cos));
        let (_, cos) = less((sin, cos), (sin2.sqrt(), cos_ball));
        cos.max(0.0)
    }
}

/// Sine and cosine of an angle less another, both in `[0, π]`; of 0 where the other is larger.
fn less((sin_a, cos_a): (f64, f64), (sin_b, cos_b): (f64, f64)) -> (f64, f64) {
    if cos_a >= cos_b {
        (0.0, 1.0)
    } else {
        (sin_a * cos_b - cos_a * sin_b, cos_a * cos_b + sin_a * sin_b)
    }
}
