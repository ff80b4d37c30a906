//! A point in glass, seen in a mirror: three methods, and only photons find all of its light.

use super::scene;
use halfdisk::integrators::{Integrator, LightTracer, Path, Photons};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::render::{Options, render};

pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    desk.say("\nlight that nobody else sees");
    let scene = scene("bulb.toml", include_str!("bulb.toml"))?;
    let size = desk.choose([200, 150], [64, 48]);
    let scene = scene.sized(size);
    let depth = scene.suggested.max_depth;
    let photons = Photons {
        walks: Some(desk.choose(1 << 16, 1 << 14)),
        ..Photons::new(depth)
    };
    let methods: [(&str, &dyn Integrator, &str); 3] = [
        (
            "path",
            &Path::from_eye(depth),
            "Path tracing from the eye alone: black. No walk from the eye meets a point, and no shadow ray goes through \
             the glass of the bulb.",
        ),
        (
            "light_tracer",
            &LightTracer { max_depth: depth },
            "Light tracing: look at the floor, which is lit, and at the mirror and the ball on it, which are black.",
        ),
        (
            "photons",
            &photons,
            "Photons: all of it. The mirror shows the lit floor, and the ball shows it upside down.",
        ),
    ];
    let mut rays = 0;
    for (name, method, caption) in methods {
        let options = Options {
            spp: desk.spp(12, 12),
            seed: desk.options.seed,
            ..Options::default()
        };
        let made = render(&scene, method, &options, &desk.bar(name));
        rays += made.rays.total();
        if made.interrupted {
            return Err(DeskError::Interrupted);
        }
        let mean = made.film.mean().0;
        let says = format!("mean of the picture by {}", name.replace('_', "-"));
        match name {
            "path" => desk.known("unseen_path", &says, mean, 0.0),
            _ => desk.value(&format!("unseen_{name}"), &says, mean),
        }
        // Rows through the mirror, beside which there is nothing but the balls.
        let rows = made.film.rows(size[1] * 3 / 10..size[1] * 4 / 10).mean().0;
        let says = format!(
            "mean of some rows through the mirror by {}",
            name.replace('_', "-")
        );
        desk.value(&format!("unseen_mirror_{name}"), &says, rows);
        desk.picture(&format!("unseen_{name}.png"), caption, &made.film, &scene)?;
    }
    Ok(rays)
}
