//! Four lamps over four plates.

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Combine, Integrator, Kajiya, NextEvent};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::render::{Film, Options, Rendered, render};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer, gallery};

/// Orange for what chance found, blue for what aiming found.
struct ByTechnique(Combine);

impl Integrator for ByTechnique {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let shares = self.0.walk(tracer, ray, stream);
        let (orange, blue) = (Rgb::new(1.0, 0.42, 0.03), Rgb::new(0.04, 0.3, 1.0));
        orange * shares.by_chance.mean() + blue * shares.by_aiming.mean()
    }
}

/// Paints the plates in all ways; the rays that took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let size = desk.choose([224, 168], [64, 48]);
    let scene = gallery::load("veach")?.sized(size);
    let max_depth = 2;
    let both = |heuristic| Combine {
        max_depth,
        heuristic,
    };
    let power = both(Heuristic::Power);
    let films = [
        (
            "chance",
            "Found by chance",
            paint(desk, &scene, &Kajiya { max_depth })?,
        ),
        (
            "aiming",
            "Found by aiming",
            paint(desk, &scene, &NextEvent { max_depth })?,
        ),
        (
            "balance",
            "Both, by the balance heuristic",
            paint(desk, &scene, &both(Heuristic::Balance))?,
        ),
        (
            "power",
            "Both, by the power heuristic",
            paint(desk, &scene, &power)?,
        ),
    ];
    let mut rays = 0;
    for (name, says, rendered) in &films {
        let per_sample = rendered.rays.total() as f64 / rendered.rays.camera as f64;
        let caption = format!("{says}: {per_sample:.2} rays a sample.");
        desk.picture(&format!("{name}.png"), &caption, &rendered.film, &scene)?;
        let film = below(&rendered.film);
        let (mean, error) = film.mean();
        let number = Number::new(&format!("mean of the plates, {name}"), mean);
        let error = Some(error);
        desk.number(&format!("plates_{name}"), Number { error, ..number });
        let variance = film.sample_variance();
        desk.value(
            &format!("plates_variance_{name}"),
            &format!("variance of one sample, {name}"),
            variance,
        );
        desk.value(
            &format!("plates_price_{name}"),
            &format!("variance times rays, {name}"),
            variance * per_sample,
        );
        rays += rendered.rays.total();
    }
    let weighted = paint(desk, &scene, &ByTechnique(power))?;
    let caption = "Which technique counted: by chance orange, by aiming blue. The lamps themselves are orange, because \
                   no shadow ray leaves the eye.";
    desk.picture("weights.png", caption, &weighted.film, &scene)?;
    Ok(rays + weighted.rays.total())
}

fn paint(desk: &Desk, scene: &Scene, by: &impl Integrator) -> Result<Rendered, DeskError> {
    let options = Options {
        spp: desk.spp(4, 4),
        seed: desk.options.seed,
        ..Options::default()
    };
    let rendered = render(scene, by, &options, &desk.bar("plates"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}

/// The part of a picture below the lamps: their edges would drown the variance of all the rest.
fn below(film: &Film) -> Film {
    let lamps = film.height() / 4 * film.width();
    Film::new(film.width(), film.pixels()[lamps as usize..].to_vec())
}
