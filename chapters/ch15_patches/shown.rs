//! The box with its blocks: as patches, interpolated, and gathered.

use glam::DVec3;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Radiosity};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::radiosity::{Patch, PatchSize, Solution};
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::description::{Description, Material};
use halfdisk::scene::value::{Albedo, Roughness};
use halfdisk::scene::{Scene, Tracer, gallery};
use halfdisk::time::Moment;

/// How patches are looked at.
#[derive(Clone, Copy, PartialEq)]
enum How {
    Wires,
    Smooth,
}

/// Patches as they are.
struct Bare<'a> {
    solution: &'a Solution,
    how: How,
}

impl Integrator for Bare<'_> {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, _: &Stream) -> Rgb {
        let Some(hit) = tracer.camera_ray(ray) else {
            return Rgb::BLACK;
        };
        let (p, front) = (hit.surface.p.as_dvec3(), hit.wo.z > 0.0);
        let reflected = match self.how {
            How::Wires => self.solution.constant(hit.shape, p, front),
            How::Smooth => self.solution.smooth(hit.shape, p, front),
        };
        let patch = self.solution.patches.at(hit.shape, p, front);
        let near = |i: usize| rim(&self.solution.patches.all[i], p) < 1.2e-3 * f64::from(hit.t);
        if self.how == How::Wires && patch.is_some_and(near) {
            return Rgb::new(0.9, 0.75, 0.2) * 0.4;
        }
        hit.emission + Rgb::from(reflected.map(|x| x as f32))
    }
}

/// The distance of a point of a patch from its nearest edge.
fn rim(patch: &Patch, p: DVec3) -> f64 {
    let corners = &patch.polygon;
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges
        .map(|(a, b)| {
            let along = (*b - *a).normalize();
            (p - *a - along * along.dot(p - *a)).length()
        })
        .fold(f64::INFINITY, f64::min)
}

/// The tall block becomes rough metal, which patches cannot hold.
pub fn with_metal(said: &mut Description) {
    let metal = Material::Glossy {
        reflectance: Albedo([0.8; 3]).into(),
        roughness: Roughness(0.2),
    };
    said.materials.insert("metal".to_owned(), metal);
    if let Some(block) = said.objects.get_mut(6) {
        block.material = Some("metal".to_owned());
    }
}

/// Draws the box; the rays that took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    desk.say("\nthe box with its blocks");
    let scene = gallery::load("cornell")?.sized(desk.choose([192; 2], [48; 2]));
    let number = PatchSize::Number(desk.choose(600, 250));
    let bar = desk.bar("patches");
    let made = Radiosity::new(&scene, scene.suggested.max_depth, number, &bar)?;
    drop(bar);
    let effort = made.solution().effort;
    let patches = effort.patches;
    desk.value("box_patches", "patches of the box", patches as f64);
    desk.value(
        "box_sweeps",
        "sweeps to solve them",
        f64::from(effort.sweeps),
    );
    desk.value(
        "box_rays",
        "shadow rays for their form factors",
        effort.rays as f64,
    );
    if let Some(error) = made.solved().and_then(|report| report.mesh_error) {
        let says = "error that the patches leave of the indirect light, %";
        desk.value("box_mesh", says, 100.0 * error);
    }
    let mut rays = effort.rays + prices(desk, &scene)?;
    let solution = made.solution();
    for (file, how, caption) in [
        (
            "wires.png",
            How::Wires,
            format!(
                "The box in {patches} patches, each of one colour: direct and indirect light. The patches are cut \
                 where the blocks stand on the floor; edges of shadows are not cut, and show as stairs."
            ),
        ),
        (
            "smooth.png",
            How::Smooth,
            "The same patches, interpolated between their middles: it looks better, and is no nearer to the \
             truth at shadows."
                .to_owned(),
        ),
    ] {
        let drawn = paint(desk, &scene, &Bare { solution, how })?;
        desk.picture(file, &caption, &drawn.film, &scene)?;
        rays += drawn.rays.total();
    }
    let drawn = paint(desk, &scene, &made)?;
    let caption = "Direct light by shadow rays in every pixel, indirect light gathered from the patches by one ray more: the \
                   integrator radiosity.";
    desk.picture("gathered.png", caption, &drawn.film, &scene)?;
    Ok(rays + drawn.rays.total())
}

/// What a number of patches costs, and what more of them do; the shadow rays that took.
fn prices(desk: &mut Desk, scene: &Scene) -> Result<u64, DeskError> {
    let mut rays = 0;
    for (name, number) in [
        ("some", desk.choose(600, 250)),
        ("twice", desk.choose(900, 400)),
    ] {
        let bar = desk.bar("patches");
        let start = Moment::now();
        let made = Radiosity::new(scene, 2, PatchSize::Number(number), &bar)?;
        let seconds = start.elapsed().unwrap_or_default().as_secs_f64();
        drop(bar);
        let effort = made.solution().effort;
        let mut say = |key: &str, says: &str, value: f64| {
            let says = format!("at most {number} patches: {says}");
            desk.value(&format!("{key}_{name}"), &says, value);
        };
        say("patches", "patches", effort.patches as f64);
        say(
            "megabytes",
            "megabytes of form factors",
            effort.bytes as f64 / 1e6,
        );
        say("shadow", "million shadow rays", effort.rays as f64 / 1e6);
        say("time_solve", "seconds", seconds);
        if let Some(error) = made.solved().and_then(|report| report.mesh_error) {
            say(
                "mesh",
                "error of the indirect light, at most about, %",
                100.0 * error,
            );
        }
        rays += effort.rays;
    }
    Ok(rays)
}

fn paint(desk: &Desk, scene: &Scene, by: &impl Integrator) -> Result<Rendered, DeskError> {
    let options = Options {
        spp: desk.spp(10, 16),
        seed: desk.options.seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let rendered = render(scene, by, &options, &desk.bar("the box"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
