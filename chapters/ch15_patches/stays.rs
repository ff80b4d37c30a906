//! The error that stays with patches: measured as a difference along the same rays.

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::world::World;
use halfdisk::integrators::{Integrator, Path, Radiosity};
use halfdisk::materials::Event;
use halfdisk::render::Film;
use halfdisk::render::accuracy::Scale;
use halfdisk::sampling::hemisphere;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::{Interaction, Tracer};
use halfdisk::stats::{Estimate, Measurement};

/// What patches say of the indirect light of a pixel, less what paths say of it. Its expectation is the bias of
/// the integrator `radiosity`, and the noise of direct light is not in it.
pub struct Off<'a> {
    pub patches: &'a Radiosity,
    pub path: Path,
}

/// Numbers of the eye's own surfaces: those of the path that goes on from them are smaller.
const VERTICES: u64 = 1000;

// ANCHOR: off
impl Integrator for Off<'_> {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let (mut off, mut beta, mut ray) = (Rgb::BLACK, Rgb::WHITE, *ray);
        for vertex in VERTICES..VERTICES + u64::from(self.path.max_depth) {
            let Some(here) = tracer.camera_ray(&ray) else {
                break;
            };
            let albedo = tracer.diffuse(&here).albedo;
            if !albedo.is_black() {
                off += beta * albedo * self.at(tracer, &here, vertex, stream);
                break;
            }
            let step = tracer.sample_bsdf(&here, vertex, stream);
            let Some(step) = step.filter(|step| step.event != Event::Diffuse) else {
                break;
            };
            beta *= step.weight;
            ray = step.ray;
        }
        off
    }
}

impl Off<'_> {
    /// The difference in one random direction.
    fn at(&self, tracer: &mut Tracer, here: &Interaction, vertex: u64, stream: &Stream) -> Rgb {
        let u = stream.at_item(vertex, Purpose::Direction, 1).two();
        let mut local = hemisphere::sample_cosine(u);
        local.z *= here.wo.z.signum();
        let ray = here.surface.spawn(here.frame.to_world(local).normalize());
        let Some(there) = tracer.camera_ray(&ray) else {
            return Rgb::BLACK;
        };
        let (p, front) = (there.surface.p.as_dvec3(), there.wo.z > 0.0);
        let held = self.patches.solution().constant(there.shape, p, front);
        let reflected = self.path.li(tracer, &ray, stream) - there.emission;
        Rgb::from(held.map(|x| x as f32)) - reflected
    }
}
// ANCHOR_END: off

/// The mean square of the bias, relative to the brightness around each pixel, from a film of independent
/// differences; without bias of its own, so it may come out below zero. Its error is the noise of the film.
pub fn squared_bias(film: &Film, scale: &Scale) -> Measurement {
    let (mut squares, mut variance) = (Estimate::new(), 0.0);
    for (i, pixel) in film.pixels().iter().enumerate() {
        let [mut square, mut its_variance] = [0.0; 2];
        for channel in &pixel.channels {
            // The square of a mean is too large by the variance of that mean.
            let noise = channel.std_error() * channel.std_error();
            let found = channel.mean() * channel.mean() - noise;
            square += found / 3.0;
            its_variance += (4.0 * found.max(0.0) * noise + 2.0 * noise * noise) / 3.0;
        }
        squares.add(scale.relative(i, square));
        let relative = scale.relative(i, its_variance.sqrt());
        variance += relative * relative;
    }
    Measurement {
        value: squares.mean(),
        error: variance.sqrt() / squares.count() as f64,
    }
}
