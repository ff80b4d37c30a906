//! Scenes of any size in any place, and scenes in which little shines.

use super::mirrored::{ONCE, exact};
use super::{fixed, mean, rendered, scene};
use crate::checks::{alike, unlike};
use halfdisk::integrators::{Integrator, Path, Photons};
use halfdisk::scene::Scene;

/// The floor under a mirror and a lamp, `scale` times as large, and `far` from the origin in each coordinate.
fn mirrored(scale: f64, far: f64) -> Scene {
    let at = |p: [f64; 3]| p.map(|x| far + scale * x);
    let along = |v: [f64; 3]| v.map(|x| scale * x);
    scene(&format!(
        "camera = {{ from = {:?}, to = {:?}, up = [0, 0, 1], fov = 55.5 }}\n\
         materials.half.lambert.albedo = 0.5\nmaterials.ideal.mirror.reflectance = 1\n\
         [[objects]]\nmaterial = 'half'\nquad = {{ corner = {:?}, u = {:?}, v = {:?} }}\n\
         [[objects]]\nmaterial = 'ideal'\nquad = {{ corner = {:?}, u = {:?}, v = {:?} }}\n\
         [[lights]]\npoint = {{ position = {:?}, intensity = {:?} }}\n",
        at([0.0, 1.9, 0.0]),
        at([0.0; 3]),
        at([-9.0, 0.0, 9.0]),
        along([18.0, 0.0, 0.0]),
        along([0.0, 0.0, -18.0]),
        at([-99.0, 2.0, -99.0]),
        along([198.0, 0.0, 0.0]),
        along([0.0, 0.0, 198.0]),
        at([0.0, 1.0, 0.0]),
        scale * scale,
    ))
}

#[test]
fn a49_scenes_of_any_size_and_far_away_have_the_same_light() {
    for (scale, far) in [
        (1e-3, 0.0),
        (1.0, 0.0),
        (1e3, 0.0),
        (1e6, 0.0),
        (1.0, 1e5),
        (1e-3, 30.0),
    ] {
        let scene = mirrored(scale, far);
        let truth = {
            let pixels = exact(&scene, 8, 0.1);
            pixels.iter().sum::<f64>() / 64.0
        };
        let ours = mean(&scene, &fixed(ONCE, (0.1 * scale) as f32, 1 << 14), 4, 16);
        alike(
            &format!("scale {scale}, {far} away"),
            ours,
            (truth, 0.0),
            0.02,
        );
        // A radius that was not scaled along.
        let other = exact(&scene, 8, 2.0).iter().sum::<f64>() / 64.0;
        unlike("blurred more", ours, (other, 0.0));
        // The usual radius is one of the scene.
        let (_, radius, _) = Photons::new(ONCE).first(&scene);
        let of_scene = f64::from(radius) / scale;
        assert!((0.1..2.5).contains(&of_scene), "{of_scene}");
    }
}

#[test]
fn a49_radii_near_rounding_and_beyond_the_scene_make_no_number_that_is_none() {
    let scene = mirrored(1.0, 0.0);
    let direct = exact(&scene, 8, 1e6).iter().sum::<f64>() / 64.0;
    for radius in [1e-30_f32, 1e-12, 1e-7, 1e-5, 1e3, 1e18] {
        let made = rendered(&scene, &fixed(ONCE, radius, 1 << 12), 4, 1);
        let (mean, _) = made.film.mean();
        println!("radius {radius:e}: {mean:.4}, direct {direct:.4}");
        assert_eq!(made.faults, Default::default());
        assert!(mean.is_finite() && mean > 0.9 * direct, "{radius}: {mean}");
    }
}

/// A floor, seen from above.
const FLOOR: &str = "camera = { from = [0, 1.9, 0], to = [0, 0, 0], up = [0, 0, 1], fov = 55.5 }\n\
    materials.half.lambert.albedo = 0.5\nmaterials.clear.glass.ior = 1.5\n\
    [[objects]]\nmaterial = 'half'\nquad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n";

#[test]
fn a49_no_lamp_and_no_photon_is_black_and_a_sky_alone_is_seen() {
    let dark = scene(FLOOR);
    for photons in [Photons::new(6), fixed(6, 0.1, 1), fixed(6, 0.1, 0)] {
        assert_eq!(rendered(&dark, &photons, 4, 1).film.mean().0, 0.0);
    }
    // Under a sky, with a ball so that some light is focused.
    let ball =
        "[[objects]]\nmaterial = 'clear'\nsphere = { center = [0.3, 0.4, 0], radius = 0.3 }\n";
    let sky = scene(&format!("background = 0.5\n{FLOOR}{ball}"));
    let ours = mean(&sky, &fixed(8, 0.05, 1 << 13), 16, 24);
    let truth = rendered(&sky, &Path::new(8), 1024, 3).mean();
    alike("sky", ours, truth, 0.12);
    // Not by direct light alone.
    let direct = rendered(&sky, &Photons::new(2), 64, 3).mean();
    unlike("direct", direct, truth);
}

#[test]
fn a49_a_camera_in_glass_sees_what_paths_see() {
    // The eye in the middle of a ball of glass looks at a floor with light from two sides.
    let text = format!(
        "{FLOOR}[[objects]]\nmaterial = 'clear'\nsphere = {{ center = [0, 1.9, 0], radius = 0.2 }}\n\
         [[objects]]\nemits = 4\nquad = {{ corner = [-1, 3, -1], u = [2, 0, 0], v = [0, 0, 2] }}\n\
         [[objects]]\nmaterial = 'half'\nquad = {{ corner = [3, 0, -9], u = [0, 9, 0], v = [0, 0, 18] }}\n"
    );
    let inside = scene(&text);
    let truth = rendered(&inside, &Path::new(8) as &dyn Integrator, 2048, 5).mean();
    let ours = mean(&inside, &fixed(8, 0.1, 1 << 12), 16, 24);
    alike("inside", ours, truth, 0.12);
    let direct = rendered(&inside, &Photons::new(2), 256, 5).film.mean().0;
    assert!(
        direct < 0.5 * truth.0,
        "without what photons bring: {direct}"
    );
}
