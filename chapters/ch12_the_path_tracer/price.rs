//! What each ingredient of the path tracer buys: the price of a picture without it.

use crate::SEGMENTS;
use crate::left_out::{LeftOut, PathWithout};
use halfdisk::integrators::Integrator;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::render::{Options, render};
use halfdisk::scene::description::{Object, Shape};
use halfdisk::scene::value::{Emission, Triple};
use halfdisk::scene::{Scene, SceneError, gallery};
use halfdisk::stats::Estimate;
use halfdisk::stats::price::{Paid, ratio};
use halfdisk::stats::slope::student_95;
use halfdisk::stats::z_test::{FOUR, z_test};

/// All that can be left out, and its name among the numbers.
const ALL: [(LeftOut, &str, &str); 5] = [
    (LeftOut::Nothing, "path", "nothing"),
    (LeftOut::Aiming, "aiming", "shadow rays"),
    (LeftOut::Weights, "weights", "weights"),
    (LeftOut::Roulette, "roulette", "roulette"),
    (LeftOut::Choice, "choice", "the choice of one lamp"),
];

/// Lamps along each side of the ceiling.
const ROW: u32 = 8;

/// Several renders of a scene by one integrator.
#[derive(Clone, Debug, Default)]
pub struct Renders {
    /// Of each render the variance of a sample, and the rays of a sample.
    pub paid: Vec<Paid>,
    /// Of each render the mean of the picture, and its squared error.
    means: Vec<[f64; 2]>,
    /// All rays.
    pub rays: u64,
}

impl Renders {
    /// The mean of all renders, and its standard error.
    pub fn mean(&self) -> (f64, f64) {
        let n = self.means.len() as f64;
        let sum = |part: usize| self.means.iter().map(|m| m[part]).sum::<f64>();
        (sum(0) / n, sum(1).sqrt() / n)
    }

    /// The differences of the means from those of `other`, render by render.
    fn apart(&self, other: &Renders) -> Estimate {
        let pairs = self.means.iter().zip(&other.means);
        pairs.map(|(own, others)| own[0] - others[0]).collect()
    }

    /// Variance and rays of a sample.
    pub fn of_one(&self) -> Paid {
        let n = self.paid.len() as f64;
        [0, 1].map(|part| self.paid.iter().map(|p| p[part]).sum::<f64>() / n)
    }

    /// Variance times rays, relative to that of `other`, and its standard error.
    pub fn price(&self, other: &Renders) -> Option<(f64, f64)> {
        let found = ratio(&self.paid, &other.paid)?;
        // The interval is so many standard errors of the logarithm wide, on either side.
        let widths = 2.0 * student_95(self.paid.len() - 1);
        Some((
            found.ratio,
            found.ratio * libm::log(found.high / found.low) / widths,
        ))
    }
}

/// Renders a scene some times, without the upper quarter of the picture: the edges of lamps that are seen there
/// would drown all other variance, and no path can help them.
pub fn renders(
    desk: &Desk,
    scene: &Scene,
    by: &impl Integrator,
    seed: u64,
) -> Result<Renders, DeskError> {
    let mut all = Renders::default();
    for replicate in 0..6 {
        let options = Options {
            spp: 4,
            seed: desk.options.seed + 1000 * seed + replicate,
            ..Options::default()
        };
        let rendered = render(scene, by, &options, &desk.bar("prices"));
        if rendered.interrupted {
            return Err(DeskError::Interrupted);
        }
        let film = rendered.film.rows(scene.size[1] / 4..scene.size[1]);
        let per_sample = rendered.rays.total() as f64 / rendered.rays.camera as f64;
        all.paid.push([film.sample_variance(), per_sample]);
        let (mean, error) = film.mean();
        all.means.push([mean, error * error]);
        all.rays += rendered.rays.total();
    }
    Ok(all)
}

/// The Cornell box with its lamp cut into many, spread over the ceiling: about the same light.
fn ceiling() -> Result<Scene, SceneError> {
    gallery::load_with("cornell", |said| {
        said.objects.retain(|object| object.emits.is_none());
        for k in 0..ROW * ROW {
            let [x, z] = [k % ROW, k / ROW].map(|i| 554.0 * (f64::from(i) + 0.5) / f64::from(ROW));
            let shape = Shape::Quad {
                corner: Triple([x - 8.0, 554.0, z - 6.5]),
                u: Triple([16.0, 0.0, 0.0]),
                v: Triple([0.0, 0.0, 13.0]),
            };
            said.objects.push(Object {
                emits: Some(Emission([15.0; 3]).into()),
                ..Object::from(shape)
            });
        }
    })
}

/// What an ingredient saves where it is missed most: the factor of the price without it.
pub struct Saved {
    /// All rays.
    pub rays: u64,
    /// Shadow rays in the box.
    pub aiming: f64,
    /// Weights among the plates.
    pub weights: f64,
    /// Roulette in the box.
    pub roulette: f64,
    /// The choice of one lamp under the ceiling.
    pub choice: f64,
}

/// Prices of the path tracer without each of its ingredients, in three scenes.
pub fn work(desk: &mut Desk) -> Result<Saved, DeskError> {
    let side = desk.choose(24, 12);
    // Large, so that the smallest lamp is no smaller in its plate than a pixel: that noise is nobody's.
    let plates = gallery::load("veach")?.sized(desk.choose([96, 72], [48, 36]));
    // Direct light alone: what plates throw at each other is rare and bright, and nobody here looks for it.
    let direct = plates.suggested.max_depth;
    let scenes = [
        ("box", gallery::load("cornell")?.sized([side; 2]), SEGMENTS),
        ("plates", plates, direct),
        ("ceiling", ceiling()?.sized([side; 2]), SEGMENTS),
    ];
    let mut rays = 0;
    let mut prices = Vec::new();
    for (number, (name, scene, max_depth)) in (1..).zip(&scenes) {
        let mut path = Renders::default();
        for (left_out, key, says) in ALL {
            let by = PathWithout {
                max_depth: *max_depth,
                left_out,
            };
            // The same seeds for all: a scene is as hard for one as for the other.
            let found = renders(desk, scene, &by, number)?;
            rays += found.rays;
            if left_out == LeftOut::Nothing {
                path = found.clone();
            }
            let [variance, per_sample] = found.of_one();
            let says = format!("{name}, without {says}");
            desk.value(
                &format!("{name}_{key}_variance"),
                &format!("{says}: variance of a sample"),
                variance,
            );
            desk.value(
                &format!("{name}_{key}_rays"),
                "  rays of a sample",
                per_sample,
            );
            if left_out == LeftOut::Nothing {
                continue;
            }
            if let Some((price, error)) = found.price(&path) {
                let number = Number::new("  variance times rays, over that of path", price);
                let error = Some(error);
                desk.number(&format!("{name}_{key}_price"), Number { error, ..number });
                prices.push((*name, left_out, price));
            }
            // The same random numbers found both, so only the scatter of their difference tells its error.
            let apart = found.apart(&path);
            let z = z_test(&apart, 0.0, FOUR).z;
            desk.value(
                &format!("{name}_{key}_z"),
                "  distance of its mean from that of path, standard errors",
                z,
            );
        }
    }
    let price = |scene: &str, of: LeftOut| {
        let mut found = prices
            .iter()
            .filter(|(s, left_out, _)| *s == scene && *left_out == of);
        found.next().map_or(f64::NAN, |(.., price)| *price)
    };
    Ok(Saved {
        rays,
        aiming: price("box", LeftOut::Aiming),
        weights: price("plates", LeftOut::Weights),
        roulette: price("box", LeftOut::Roulette),
        choice: price("ceiling", LeftOut::Choice),
    })
}
