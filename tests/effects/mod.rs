//! Only what a scene calls for: what is absent costs nothing, and leaving it out changes no bit.

mod bits;
mod commands;
mod paths;

use halfdisk::integrators::{Integrator, Path};
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Effect, Scene, gallery};

pub const SMALL: [u32; 2] = [24, 18];

pub fn small(name: &str) -> Scene {
    gallery::load(name).unwrap().sized(SMALL)
}

/// A room with an open side: what follows `[camera]` goes on with `more`.
pub fn scene(camera: &str, more: &str) -> Scene {
    let text = format!(
        "name = 'test'\nfilm.size = [24, 18]\n[materials]\nhalf.lambert.albedo = 0.5\n\
         silver.mirror.reflectance = 0.9\nclear.glass.ior = 1.5\n\
         satin.glossy = {{ reflectance = 0.8, roughness = 0.2 }}\n\
         [camera]\nfrom = [0, 1, 5]\nto = [0, 0.5, 0]\nfov = 45\n{camera}\n{more}"
    );
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

pub const FLOOR: &str = "[[objects]]\nmaterial = 'half'\nquad = { corner = [-4, 0, 4], u = [8, 0, 0], v = [0, 0, -8] }\n";
pub const LAMP: &str = "[[objects]]\nemits = 9\nsphere = { center = [0, 2, 1], radius = 0.25 }\n";
pub const POINT: &str = "[[lights]]\npoint = { position = [0, 3, 1], intensity = 9 }\n";

pub fn ball(material: &str, more: &str) -> String {
    format!(
        "[[objects]]\nmaterial = '{material}'\n{more}\n\
         sphere = {{ center = [0, 0.5, 0], radius = 0.5 }}\n"
    )
}

pub fn with(scene: &Scene, integrator: &impl Integrator) -> Rendered {
    let options = Options {
        spp: 4,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    render(scene, integrator, &options, &())
}

pub fn path(scene: &Scene) -> Rendered {
    with(scene, &Path::new(scene.suggested.max_depth))
}

pub fn effects(scene: &Scene) -> Vec<Effect> {
    scene.inventory.effects().iter().collect()
}
