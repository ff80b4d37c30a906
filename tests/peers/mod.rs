//! Agreement with another renderer.
//!
//! The pictures beside this file were made by Mitsuba 3.9.1 (`llvm_ad_rgb`, independent sampler) from
//! the same numbers as the scenes `cornell`, `spheres`, `caustic` and `mesh`: 8192, 16384, 65536 and
//! 8192 samples for each of 256 x 256 pixels, of which 4 x 4 make one here. Their errors come from
//! two halves of other seeds.

use crate::checks::CRITICAL;
use halfdisk::integrators::{Integrator, Path};
use halfdisk::output;
use halfdisk::render::{Options, Picture, compare, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::description::{Description, Material};
use halfdisk::scene::textures::Textured;
use halfdisk::scene::value::{Albedo, Emission};
use halfdisk::scene::{Scene, gallery};
use std::path::Path as FilePath;

const SIDE: u32 = 64;
fn reference(name: &str) -> Picture {
    let folder = FilePath::new(env!("CARGO_MANIFEST_DIR")).join("tests/peers");
    output::read(&folder.join(name).with_extension("exr")).unwrap()
}

fn scene(name: &str, change: impl FnOnce(&mut Description)) -> Scene {
    gallery::load_with(name, change).unwrap().sized([SIDE; 2])
}

fn picture(scene: &Scene, integrator: &impl Integrator, sampler: Sampler, spp: u32) -> Picture {
    let options = Options {
        spp,
        sampler,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &());
    assert_eq!(rendered.non_finite, 0);
    rendered.film.picture()
}

fn path(scene: &Scene) -> Path {
    Path::new(scene.suggested.max_depth)
}

/// What keeps a picture from agreeing with the reference; empty where it does.
///
/// Pixels are compared in squares of `side`: where the light of a pixel comes by events so rare that
/// it has seen none, it does not know its error.
fn complaints(name: &str, ours: &Picture, side: u32) -> Vec<String> {
    let theirs = reference(name).in_squares(side);
    let z = compare::z_scores(&ours.in_squares(side), &theirs).unwrap();
    let squares = z.squares.z(1.0);
    println!(
        "{name}: z of means {:+.2}, mean z² {:.3} ± {:.3}, largest |z| {:.2}, rejected {:.3} %",
        z.of_means,
        z.squares.mean(),
        z.squares.std_error(),
        z.largest,
        100.0 * z.rejected
    );
    let mut found = Vec::new();
    if z.of_means.abs() > CRITICAL {
        found.push(format!("the means are {:+.1} errors apart", z.of_means));
    }
    if squares > CRITICAL {
        found.push(format!("z² is {squares:.1} errors above 1"));
    }
    // The rule of that renderer's own tests.
    if z.rejected > 0.0025 {
        found.push(format!("{:.2} % of pixels differ", 100.0 * z.rejected));
    }
    found
}

#[test]
fn path_agrees_on_all_four_scenes() {
    for (name, spp, side) in [
        ("cornell", 512, 1),
        ("spheres", 2048, 2),
        ("caustic", 2048, 16),
        ("mesh", 256, 1),
    ] {
        let scene = scene(name, |_| {});
        let ours = picture(&scene, &path(&scene), Sampler::Independent, spp);
        assert_eq!(complaints(name, &ours, side), [""; 0], "{name}");
    }
}

#[test]
fn a_scene_that_is_slightly_off_does_not_agree() {
    // Walls a little darker, and a lamp of one percent less.
    let darker = scene("cornell", |said| {
        let white = said.materials.get_mut("white").unwrap();
        *white = Material::Lambert {
            albedo: Albedo([0.72; 3]).into(),
        };
    });
    let dimmer = scene("cornell", |said| {
        for object in &mut said.objects {
            if let Some(Textured::Constant(light)) = &mut object.emits {
                *light = Emission(light.0.map(|x| 0.99 * x));
            }
        }
    });
    for scene in [darker, dimmer] {
        let ours = picture(&scene, &path(&scene), Sampler::Independent, 512);
        assert_ne!(complaints("cornell", &ours, 1), [""; 0]);
    }
}
