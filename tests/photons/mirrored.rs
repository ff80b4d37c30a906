//! A lamp in a plane mirror: its image lights the floor.

use super::{fixed, mean, rendered, scene};
use crate::checks::{alike, unlike};
use halfdisk::integrators::{PhotonBlur, Photons};
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::Purpose;
use halfdisk::scene::Scene;
use halfdisk::stats::Estimate;

/// A floor under a mirror, and between them a lamp at height 1: the mirror shows another one at height 3.
pub const MIRRORED: &str = "camera = { from = [0, 1.9, 0], to = [0, 0, 0], up = [0, 0, 1], fov = 55.5 }\n\
    materials.half.lambert.albedo = 0.5\nmaterials.ideal.mirror.reflectance = 1\n\
    [[objects]]\nmaterial = 'half'\nquad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n\
    [[objects]]\nmaterial = 'ideal'\nquad = { corner = [-99, 2, -99], u = [198, 0, 0], v = [0, 0, 198] }\n\
    [[lights]]\npoint = { position = [0, 1, 0], intensity = 1 }\n";

/// Light to the mirror, to the floor, to the eye: no path of more segments.
pub const ONCE: u32 = 3;

/// The irradiance by a point of 1 W/sr at a height, so far aside of its foot.
pub fn irradiance(height: f64, aside2: f64) -> f64 {
    let distance2 = height * height + aside2;
    height / (distance2 * distance2.sqrt())
}

/// The same, blurred by Epanechnikov's kernel of a radius.
pub fn blurred(height: f64, [x, z]: [f64; 2], radius: f64) -> f64 {
    const N: u32 = 24;
    let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(N);
    let mut sum = 0.0;
    for i in 0..N {
        // Uniform in area.
        let share = middle(i);
        let aside = radius * share.sqrt();
        for j in 0..N {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * middle(j));
            let (x, z) = (x + aside * cos, z + aside * sin);
            sum += 2.0 * (1.0 - share) * irradiance(height, x * x + z * z);
        }
    }
    sum / f64::from(N * N)
}

/// The radiance of the middles of `side * side` pixels of the picture of [`MIRRORED`], row by row.
pub fn exact(scene: &Scene, side: u32, radius: f64) -> Vec<f64> {
    let half = 0.5 * f64::from(scene.camera.film_area()).sqrt() * 1.9;
    let at = |pixel: u32| half * (2.0 * (f64::from(pixel) + 0.5) / f64::from(side) - 1.0);
    let pixels = (0..side).flat_map(|y| (0..side).map(move |x| [at(x), at(y)]));
    let radiance = |p: [f64; 2]| {
        let sum = irradiance(1.0, p[0] * p[0] + p[1] * p[1]) + blurred(3.0, p, radius);
        0.5 / std::f64::consts::PI * sum
    };
    pixels.map(radiance).collect()
}

#[test]
fn s0_05_a_lamp_in_a_mirror_lights_the_floor_as_its_image_would() {
    let scene = scene(MIRRORED);
    let average = |pixels: Vec<f64>| pixels.iter().sum::<f64>() / pixels.len() as f64;
    let sharp = (average(exact(&scene, 8, 0.0)), 0.0);
    for radius in [2.0_f32, 1.0, 0.1] {
        let ours = mean(&scene, &fixed(ONCE, radius, 1 << 14), 8, 24);
        let soft = average(exact(&scene, 8, f64::from(radius)));
        println!("radius {radius}: blurred {soft:.6}, sharp {:.6}", sharp.0);
        alike("floor", ours, (soft, 0.0), 0.008);
        // What they bring is the light, the smaller the radius the closer.
        if radius > 1.5 {
            unlike("blur", ours, sharp);
        } else if radius < 0.2 {
            alike("sharp", ours, sharp, 0.008);
        }
        // A photon in ten too many.
        let (direct, error) = (average(exact(&scene, 8, 1e6)), ours.1);
        let more = direct + (ours.0 - direct) * 1.1;
        unlike("more", (more, error), (soft, 0.0));
    }
    // Nothing but light straight from the lamp where no photon is looked for.
    let direct = rendered(&scene, &Photons::new(2), 16, 3).mean();
    alike(
        "direct",
        direct,
        (average(exact(&scene, 8, 1e6)), 0.0),
        0.02,
    );
}

#[test]
fn the_blur_is_told_by_half_of_each_disc() {
    let scene = scene(MIRRORED);
    let radius = 1.0;
    let photons = fixed(ONCE, radius, 1 << 14);
    let blur = PhotonBlur::new(&photons, &scene, 4);
    let means: Estimate = (0..24_u64)
        .map(|seed| rendered_signed(&scene, &blur, 8, seed))
        .collect();
    let average = |radius: f64| exact(&scene, 8, radius).iter().sum::<f64>() / 64.0;
    let (whole, half) = (f64::from(radius), f64::from(radius) / 2.0_f64.sqrt());
    let said = 2.0 * (average(whole) - average(half));
    let bias = average(whole) - average(0.0);
    let ours = (means.mean(), means.std_error());
    println!("said {said:.6}, in truth {bias:.6}");
    alike("blur", ours, (said, 0.0), 0.2);
    assert!((said / bias - 1.0).abs() < 0.1, "{said} {bias}");
    // The difference without its factor is half of it.
    unlike("half", (0.5 * ours.0, 0.5 * ours.1), (said, 0.0));
    // Discs that shrink have the blur of their mean square.
    let shrinking = Photons {
        alpha: 0.5,
        ..photons
    };
    let less: Estimate = (0..24_u64)
        .map(|seed| rendered_signed(&scene, &PhotonBlur::new(&shrinking, &scene, 64), 8, seed))
        .collect();
    assert!(less.mean().abs() < 0.5 * bias.abs(), "{}", less.mean());
}

/// The mean of a picture whose samples may be negative.
fn rendered_signed(scene: &Scene, integrator: &PhotonBlur, spp: u32, seed: u64) -> f64 {
    let options = Options {
        spp,
        seed,
        fixed: &[Purpose::Pixel],
        ..Options::default()
    };
    render(scene, integrator, &options, &()).film.mean().0
}
