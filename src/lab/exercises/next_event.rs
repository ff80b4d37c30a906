//! Exercise 9: next-event estimation of a rectangular lamp.

use super::exam::mistake;
use super::{Entry, Exam, Question};
use crate::numeric::sin_cos;
use crate::radiosity::point_to_polygon;
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, FRAC_PI_6};
use std::f64::consts::PI;

/// A rectangular lamp, and a wall that may hide some of it.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// One of its corners.
    pub corner: Vec3,
    /// The two edges that begin there.
    pub edges: [Vec3; 2],
    /// The unit normal of the side that shines.
    pub normal: Vec3,
    /// The radiance of every point of that side, in every direction.
    pub radiance: f32,
    /// True where a wall stands in the half space of negative x.
    walled: bool,
}

impl Lamp {
    /// A shadow ray: true where a point of a surface sees a point of the lamp.
    pub fn is_visible(&self, _from: Vec3, to: Vec3) -> bool {
        !self.walled || to.x > 0.0
    }

    fn area(&self) -> f32 {
        self.edges[0].cross(self.edges[1]).length()
    }

    fn point(&self, [u, v]: [f32; 2]) -> Vec3 {
        self.corner + self.edges[0] * u + self.edges[1] * v
    }
}

/// One estimate of the irradiance at a point with this unit normal, from one point of the lamp: lamp, point, normal,
/// two uniforms.
pub type Direct = fn(&Lamp, Vec3, Vec3, [f32; 2]) -> f32;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 9,
    name: "next-event",
    title: "estimate the light of a lamp by one shadow ray",
    page: "ch09-aim-at-the-light",
    points: 10,
    hints: &[
        "Draw a point of the lamp, uniformly in area. Which density has it, and what does the geometry term turn into what?",
        "L cos θ cos θ' A / r², with θ at the surface and θ' at the lamp. Both cosines count only where they are above 0.",
        "A point that the shadow ray does not reach brings nothing.",
    ],
    source: include_str!("../../../examples/exercises/ex09_next_event.rs"),
};

/// A lamp of 2 by 1 one above the floor, which shines downwards with radiance 3.
const OVERHEAD: Lamp = Lamp {
    corner: Vec3::new(-1.0, -0.5, 1.0),
    edges: [Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)],
    normal: Vec3::NEG_Z,
    radiance: 3.0,
    walled: false,
};

/// A lamp in a wall to the right, half of it below the floor.
const ASIDE: Lamp = Lamp {
    corner: Vec3::new(1.5, -1.0, -1.0),
    edges: [Vec3::new(0.0, 2.0, 0.0), Vec3::new(0.0, 0.0, 2.0)],
    normal: Vec3::NEG_X,
    ..OVERHEAD
};

/// What arrives at the origin, exactly, where no wall stands.
fn truth(lamp: &Lamp, n: Vec3) -> f64 {
    let [a, b] = lamp.edges;
    let corners = [Vec3::ZERO, a, a + b, b].map(|edge| (lamp.corner + edge).as_dvec3());
    let factor = point_to_polygon(glam::DVec3::ZERO, n.as_dvec3(), &corners);
    PI * f64::from(lamp.radiance) * factor
}

/// What a mistake is made of: the factors of the estimate.
#[derive(Clone, Copy)]
struct Parts {
    li: f32,
    cos: f32,
    cos_lamp: f32,
    area: f32,
    r2: f32,
    visible: bool,
}

fn with(lamp: &Lamp, p: Vec3, n: Vec3, u: [f32; 2], product: impl Fn(Parts) -> f32) -> f32 {
    let q = lamp.point(u);
    let way = q - p;
    let wi = way.normalize();
    product(Parts {
        li: lamp.radiance,
        cos: n.dot(wi),
        cos_lamp: -lamp.normal.dot(wi),
        area: lamp.area(),
        r2: way.length_squared(),
        visible: lamp.is_visible(p, q),
    })
}

/// The right product, of parts of which one may be wrong.
fn product(x: Parts) -> f32 {
    match x.visible {
        true => x.li * x.cos.max(0.0) * x.cos_lamp.max(0.0) * x.area / x.r2,
        false => 0.0,
    }
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Direct> {
    let slip = mistake::<Direct>;
    let (sin, cos) = sin_cos(FRAC_PI_6);
    let tilted = Vec3::new(sin, 0.0, cos);
    let walled = Lamp {
        walled: true,
        ..OVERHEAD
    };
    let upwards = Lamp {
        normal: Vec3::Z,
        ..OVERHEAD
    };
    let ask = |what, truth, lamp: Lamp, n: Vec3| {
        Question::mean(what, truth, move |a: &Direct, d| {
            a(&lamp, Vec3::ZERO, n, d.two()).into()
        })
    };
    let (overhead, aside) = (truth(&OVERHEAD, Vec3::Z), truth(&ASIDE, Vec3::Z));
    Exam::new(
        &ENTRY,
        vec![
            ask(
                "the irradiance from a lamp overhead",
                overhead,
                OVERHEAD,
                Vec3::Z,
            ),
            ask(
                "the irradiance of a floor that is tilted by 30 degrees",
                truth(&OVERHEAD, tilted),
                OVERHEAD,
                tilted,
            ),
            ask(
                "the irradiance from a lamp aside, half of it below the floor,",
                aside,
                ASIDE,
                Vec3::Z,
            ),
            ask(
                "the irradiance from a lamp of which a wall hides half",
                0.5 * overhead,
                walled,
                Vec3::Z,
            ),
            ask(
                "the irradiance from a lamp that shines the other way",
                0.0,
                upwards,
                Vec3::Z,
            ),
        ],
        vec![
            slip(
                "cosine at the lamp forgotten",
                "the cosine at the lamp: a lamp that is seen askew covers less of the view",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        product(Parts {
                            cos_lamp: x.cos_lamp.signum(),
                            ..x
                        })
                    })
                },
            ),
            slip(
                "cosine at the surface forgotten",
                "the cosine at the surface, of Lambert's law",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        product(Parts {
                            cos: x.cos.signum(),
                            ..x
                        })
                    })
                },
            ),
            slip(
                "distance not squared",
                "to square the distance: light spreads over an area",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        product(Parts {
                            r2: x.r2.sqrt(),
                            ..x
                        })
                    })
                },
            ),
            slip(
                "distance forgotten",
                "the squared distance: cosines are those of unit vectors, and the geometry term still has its 1/r²",
                |l, p, n, u| with(l, p, n, u, |x| product(Parts { r2: 1.0, ..x })),
            ),
            slip(
                "area forgotten",
                "to divide by the density of the point, which is 1/A",
                |l, p, n, u| with(l, p, n, u, |x| product(Parts { area: 1.0, ..x })),
            ),
            slip(
                "divided by the area",
                "that to divide by the density 1/A is to multiply by A",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        product(Parts {
                            area: 1.0 / x.area,
                            ..x
                        })
                    })
                },
            ),
            slip(
                "shadow ray forgotten",
                "the shadow ray: a wall may stand between",
                |l, p, n, u| with(l, p, n, u, |x| product(Parts { visible: true, ..x })),
            ),
            slip(
                "shadow ray the wrong way",
                "that light arrives where the shadow ray reaches the lamp, and not where it does not",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        product(Parts {
                            visible: !x.visible,
                            ..x
                        })
                    })
                },
            ),
            slip(
                "lamp shines on both sides",
                "that the lamp shines on one side: a cosine below 0 brings nothing",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        product(Parts {
                            cos_lamp: x.cos_lamp.abs(),
                            ..x
                        })
                    })
                },
            ),
            slip(
                "light from below",
                "that light from below the surface brings nothing: its cosine is below 0, and yours has no sign",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        product(Parts {
                            cos: x.cos.abs(),
                            ..x
                        })
                    })
                },
            ),
            slip(
                "light below takes away",
                "that light from below the surface brings nothing: a cosine below 0 must not take light away",
                |l, p, n, u| {
                    with(l, p, n, u, |x| {
                        let positive = product(Parts {
                            cos: x.cos.abs(),
                            ..x
                        });
                        positive * x.cos.signum()
                    })
                },
            ),
            slip(
                "both cosines unclamped",
                "that neither cosine may be below 0: nothing arrives from below, and nothing leaves the lamp's back",
                |l, p, n, u| {
                    with(l, p, n, u, |x| match x.visible {
                        true => x.li * x.cos * x.cos_lamp * x.area / x.r2,
                        false => 0.0,
                    })
                },
            ),
            slip(
                "BRDF counted in",
                "that irradiance has no BRDF in it: 1/π comes where the surface reflects",
                |l, p, n, u| FRAC_1_PI * with(l, p, n, u, product),
            ),
            slip(
                "radiance forgotten",
                "the radiance of the lamp",
                |l, p, n, u| with(l, p, n, u, |x| product(Parts { li: 1.0, ..x })),
            ),
        ],
    )
}
