//! Lights one can aim at: closed forms, densities, and the choice of one among many.

mod choice;
mod densities;
mod emission;
mod environment;
mod rectangle;
mod skies;
mod sphere;
mod tree;
mod triangle;

use glam::{DVec3, Vec3};
use halfdisk::geometry::Surface;
use halfdisk::lights::{Incident, Light};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Scene;
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;
use halfdisk::stats::Estimate;

/// The ground at the origin, facing up.
pub const GROUND: Surface = Surface {
    p: Vec3::ZERO,
    error: Vec3::ZERO,
    n: Vec3::Y,
    time: 0.0,
};

/// A scene of these objects and lights, seen from the origin.
pub fn scene(objects: &str) -> Scene {
    let text = "name = 'test'\ncamera = { from = [0, 0, 0], to = [0, 0, 1], fov = 40 }\n\
                materials.half.lambert.albedo = 0.5\n"
        .to_owned()
        + objects;
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

/// The irradiance at `from` that samples of a light estimate.
pub fn irradiance(light: &Light, from: &Surface, samples: u32) -> Estimate {
    irradiance_by(from, samples, |u| {
        let sample = light.sample(from, 0.5, u)?;
        Some((sample.wi, sample.incident))
    })
}

/// The same by any way of sampling.
pub fn irradiance_by(
    from: &Surface,
    samples: u32,
    sample: impl Fn([f32; 2]) -> Option<(Vec3, Incident)>,
) -> Estimate {
    let one = |i: u32| {
        let u = Stream::new(9, i, 0).at(0, Purpose::LightPoint).two();
        sample(u).map_or(0.0, |(wi, incident)| {
            let cos = f64::from(wi.dot(from.n).max(0.0));
            f64::from(incident.facing_irradiance().g) * cos
        })
    };
    (0..samples).map(one).collect()
}

/// The irradiance at the origin, facing along `n`, by a polygon of radiance 1 above its horizon.
///
/// Source: Lambert, Photometria (1760): half the sum over the edges of angle times the cosine of
/// the plane through edge and eye.
pub fn polygon(corners: &[DVec3], n: DVec3) -> f64 {
    let edge = |i: usize| {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        let across = a.cross(b);
        let angle = libm::atan2(across.length(), a.dot(b));
        angle * n.dot(across) / across.length()
    };
    0.5 * (0..corners.len()).map(edge).sum::<f64>().abs()
}
