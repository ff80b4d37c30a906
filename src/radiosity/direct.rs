//! Light that reaches patches from lights that are no patches: points, directions, spheres, the sky.

use super::patches::{Patch, Patches};
use super::quadrature::{gauss_legendre, points_on};
use super::system::Channels;
use crate::geometry::Surface;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Scene, Tracer};
use std::f64::consts::FRAC_1_PI;

/// Seed of the points on lights: the same in every picture.
const SEED: u64 = 0x006c_616d_7073;
/// Points along each side of a patch.
const POINTS: usize = 3;
/// Points drawn on a light with extent for each of those.
const DRAWN: u32 = 16;

/// The mean radiance over each patch's hemisphere, in W/(m² sr), that arrives straight from the lights
/// whose light starts from no patch: irradiance over π.
pub(super) fn arriving(scene: &Scene, patches: &Patches) -> Vec<Channels> {
    let lights: Vec<usize> = (0..scene.lights.len())
        .filter(|&light| !patches.lights.contains(&(light as u32)))
        .collect();
    if lights.is_empty() {
        return vec![[0.0; 3]; patches.all.len()];
    }
    let mut tracer = Tracer::new(scene);
    let each = patches.all.iter().zip(0..);
    each.map(|(patch, i)| of_patch(&mut tracer, patch, i, &lights))
        .collect()
}

fn of_patch(tracer: &mut Tracer, patch: &Patch, number: u32, lights: &[usize]) -> Channels {
    let mut sum = [0.0; 3];
    if patch.albedo == [0.0; 3] {
        return sum;
    }
    let points = points_on(&patch.polygon, &gauss_legendre(POINTS));
    for (place, (p, weight)) in points.iter().enumerate() {
        let here = Surface {
            p: p.as_vec3(),
            error: glam::Vec3::splat(patch.close as f32),
            n: patch.normal.as_vec3(),
            time: 0.0,
        };
        for &light in lights {
            let drawn = if tracer.scene().lights[light].is_delta() {
                1
            } else {
                DRAWN
            };
            for sample in 0..drawn {
                let stream = Stream::new(SEED, number, sample);
                let mut u = stream.at_item(place as u64, Purpose::LightPoint, light as u32);
                let (uv, pick) = (u.two(), u.fine());
                let Some(found) = tracer.light_sample(light, &here, pick, uv) else {
                    continue;
                };
                let cos = f64::from(found.wi.dot(here.n));
                if cos <= 0.0 || !tracer.visible(light, &found) {
                    continue;
                }
                let scale = weight * cos * FRAC_1_PI / f64::from(drawn);
                let facing = found.incident.facing_irradiance().channels();
                (0..3).for_each(|c| sum[c] += scale * f64::from(facing[c]));
            }
        }
    }
    sum
}
