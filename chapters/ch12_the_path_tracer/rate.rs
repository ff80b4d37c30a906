//! The variance of many paths, in the flat room whose answer is known.

use crate::SEGMENTS;
use crate::checks::flat_path;
use glam::Vec2;
use halfdisk::color::Rgb;
use halfdisk::flatland::{self, exact};
use halfdisk::integrators::world::FlatTracer;
use halfdisk::integrators::{Kajiya, NextEvent};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::estimators::walks;
use halfdisk::lab::experiment::convergence::{Convergence, Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::space::{Flat, Ray};

/// Who looks for the light, by which points.
#[derive(Clone, Copy)]
enum Way {
    Chance,
    Aiming,
    Path(Sampler),
}

const WAYS: [(&str, Way); 4] = [
    ("by chance", Way::Chance),
    ("aiming", Way::Aiming),
    ("path", Way::Path(Sampler::Independent)),
    ("path, even points", Way::Path(Sampler::Sobol)),
];

impl Way {
    fn walk(self, world: &mut FlatTracer, stream: &Stream) -> f64 {
        let eye = Ray::<Flat>::new(Vec2::splat(0.5), Vec2::NEG_Y);
        let max_depth = SEGMENTS;
        let li = match self {
            Way::Chance => Kajiya { max_depth }.walk(world, &eye, stream),
            Way::Aiming => NextEvent { max_depth }.walk(world, &eye, stream),
            Way::Path(_) => flat_path(max_depth, world, &eye, stream),
        };
        f64::from(li.r)
    }

    fn sampler(self) -> Sampler {
        match self {
            Way::Path(sampler) => sampler,
            _ => Sampler::Independent,
        }
    }
}

/// The variance of the mean of `N` paths, by each way; the rays that the variances of one path took.
pub fn chart(desk: &mut Desk) -> Result<u64, DeskError> {
    let design = Design {
        replicates: desk.choose(256, 64),
        doublings: desk.choose(10, 6),
        first: 4,
        seed: desk.options.seed,
    };
    let (room, truth) = (flatland::load("room")?, exact::ROOM_FLOOR);
    let count = desk.choose(400_000, 40_000);
    let mut runs: Vec<(Convergence, Option<f64>)> = Vec::new();
    let mut rays = 0;
    for (number, (name, way)) in WAYS.into_iter().enumerate() {
        let estimator = Estimator {
            name,
            about: "",
            truth,
            rays_per_sample: 1,
            sizes: Sizes::Doublings,
            run: |n: u32, seed: u64| {
                let mut world = FlatTracer::new(&room);
                // Even points lie evenly among the samples of one pixel.
                let stream = |i| Stream::with(way.sampler(), seed, 0, i);
                let mut path = |i| way.walk(&mut world, &stream(i));
                (0..n).map(&mut path).sum::<f64>() / f64::from(n)
            },
        };
        let of_one = walks::flat(&room, truth, count, desk.options.seed, |world, stream| {
            Rgb::grey(way.walk(world, stream) as f32)
        });
        rays += of_one.rays;
        // Each even point alone is a random point, with the variance of any.
        let key = ["chance", "aiming", "path", "even"][number];
        if key != "even" {
            desk.estimate(
                &format!("room_variance_{key}"),
                &format!("flat room: variance of one path, {name}"),
                &of_one.squares,
                None,
            );
            desk.value(&format!("room_rays_{key}"), "  rays", of_one.rays_each());
        }
        runs.push((converge(&estimator, &design), Some(of_one.squares.mean())));
    }
    if let [.., (path, _), (even, _)] = &runs[..] {
        gain(desk, path, even);
    }
    let chart = variance_chart("Paths in the flat room", &runs);
    let caption = "Independent paths follow σ²/N, whichever way they find the light; dashed, with the σ² of many \
                   single paths. Even points fall faster, up to 64 paths. After that they fall as all others do.";
    desk.figure("rate.svg", caption, chart.to_svg()?)?;
    Ok(rays)
}

/// How much lower the variance of 64 even paths is than that of 64 others.
fn gain(desk: &mut Desk, path: &Convergence, even: &Convergence) {
    let replicates = path.replicates;
    let of = |run: &Convergence| {
        let size = run.sizes.iter().find(|size| size.samples == 64);
        size.and_then(|size| size.variance)
    };
    if let (Some(path), Some(even)) = (of(path), of(even)) {
        let number = Number::new("64 even paths: times less variance", path / even);
        // Two variances of so many normal means, each known to this share.
        let share = (2.0 / (f64::from(replicates) - 1.0)).sqrt();
        let error = Some(path / even * share * std::f64::consts::SQRT_2);
        desk.number("even_gain", Number { error, ..number });
    }
}
