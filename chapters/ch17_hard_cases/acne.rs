//! Shadow acne in pictures: the same shadow rays from three starting points.

use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::Integrator;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::naive;
use halfdisk::lights::Light;
use halfdisk::render::{Film, Options, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Interaction, Tracer, gallery, read::Source};

/// Where a shadow ray starts.
#[derive(Clone, Copy)]
enum Start {
    /// At the end of the ray that found the point.
    EndOfRay,
    /// 0.001 above it along the normal, whatever the size of the scene.
    Fixed,
    /// Off the point on the shape, by the bound on its error.
    Bounded,
}

/// Direct light of the points that shine, by shadow rays from a start.
struct Direct(Start);

// ANCHOR: start
impl Start {
    /// The shadow ray from the point `here`, which `ray` has met, to a light at `light`.
    fn shadow_ray(self, ray: &Ray, here: &Interaction, light: Vec3) -> Ray {
        let end = naive::hit_point(ray.origin, ray.direction, here.t);
        let start = match self {
            Start::EndOfRay => end,
            Start::Fixed => naive::offset_by(0.001, end, here.surface.n, light - end),
            Start::Bounded => return here.surface.spawn_to_point(light),
        };
        // A direction that is not of unit length: the light is at 1.
        Ray {
            t_max: 1.0,
            ..Ray::new(start, light - start)
        }
    }
}
// ANCHOR_END: start

impl Integrator for Direct {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, _: &Stream) -> Rgb {
        let Some(here) = tracer.camera_ray(ray) else {
            return Rgb::BLACK;
        };
        let mut li = Rgb::BLACK;
        for light in &tracer.scene().lights {
            if let (Light::Point(point), Some(bsdf)) = (light, &here.bsdf) {
                let toward = point.position - here.surface.p;
                let wi = here.frame.to_local(toward.normalize());
                let irradiance = point.intensity * (wi.z.max(0.0) / toward.length_squared());
                if tracer.unoccluded(&self.0.shadow_ray(ray, &here, point.position)) {
                    li += bsdf.f(here.wo, wi) * irradiance;
                }
            }
        }
        li
    }
}

/// The three pictures, and how much light is left in each; the rays they took.
pub fn pictures(desk: &mut Desk) -> Result<u64, DeskError> {
    let source = Source {
        file: "acne.toml",
        text: include_str!("acne.toml"),
    };
    let scene = gallery::from_text(source, None, |_| {})?;
    let scene = scene.sized(desk.choose([240, 180], [48, 36]));
    let options = Options {
        spp: desk.spp(4, 4),
        seed: desk.options.seed,
        ..Options::default()
    };
    let mut films = Vec::new();
    let mut rays = 0;
    for (file, start, caption) in [
        (
            "acne_end.png",
            Start::EndOfRay,
            "Shadow rays start where the ray from the eye ended. Look at the specks: these points lie below their own \
             surface, and shadow themselves. The bands begin where a coordinate passes a power of two and is rounded \
             differently.",
        ),
        (
            "acne_fixed.png",
            Start::Fixed,
            "They start 0.001 above it. No specks, but look at where the balls stand: the step is as long as a ball is \
             high, and the shadows have moved, as if the table top were that much higher.",
        ),
        (
            "acne_bounded.png",
            Start::Bounded,
            "They start off the point by the bound on its error: no specks, and each shadow begins at its ball.",
        ),
    ] {
        let made = render(&scene, &Direct(start), &options, &desk.bar(file));
        if made.interrupted {
            return Err(DeskError::Interrupted);
        }
        rays += made.rays.total();
        desk.picture(file, caption, &made.film, &scene)?;
        films.push(made.film);
    }
    // All three have the same rays from the eye, so what differs is the start of the shadow rays.
    let [end, fixed, bounded] = &films[..] else {
        return Ok(rays);
    };
    let lit = |film: &Film| -> Vec<f64> {
        let pixels = film.pixels().iter();
        pixels.map(|pixel| pixel.channels[0].mean()).collect()
    };
    let truth = lit(bounded);
    for (name, says, film) in [
        ("end", "the end of the ray", end),
        ("fixed", "0.001 above it", fixed),
    ] {
        let off = lit(film).iter().zip(&truth).filter(|(x, t)| x != t).count();
        let share = 100.0 * off as f64 / truth.len() as f64;
        let says = format!("pixels with wrong shadows, starting from {says}");
        desk.number(
            &format!("acne_{name}"),
            Number::new(&says, (10.0 * share).round() / 10.0).unit("%"),
        );
    }
    Ok(rays)
}
