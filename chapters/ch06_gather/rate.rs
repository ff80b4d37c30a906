//! The variance of many trees, in a room that glows.

use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::worlds::Furnace;
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;
use halfdisk::sampling::stream::Stream;
use halfdisk::space::Solid;

/// Trees of one, four and sixteen uniform directions at each of two levels; the rays.
pub fn chart(desk: &mut Desk) -> Result<u64, DeskError> {
    let design = Design {
        replicates: desk.choose(128, 64),
        doublings: desk.choose(7, 5),
        first: 1,
        seed: desk.options.seed,
    };
    let (room, depth) = (Furnace { albedo: 0.5 }, 2);
    let (mut runs, mut rays) = (Vec::new(), 0);
    for (name, samples) in [
        ("one direction: 3 rays", 1),
        ("four directions: 21 rays", 4),
        ("sixteen directions: 273 rays", 16),
    ] {
        let gather = Gather {
            samples,
            depth,
            recipe: Recipe::Uniform,
        };
        let trees = move |n: u32, seed: u64| {
            let tree = |i| {
                let stream = Stream::new(seed, i, 0);
                f64::from(
                    gather
                        .li(&mut room.clone(), &Furnace::eye::<Solid>(), &stream)
                        .r,
                )
            };
            (0..n).map(tree).sum::<f64>() / f64::from(n)
        };
        let estimator = Estimator {
            name,
            about: "",
            truth: room.radiance(depth),
            rays_per_sample: gather.rays() as u32,
            sizes: Sizes::Doublings,
            run: trees,
        };
        let run = converge(&estimator, &design);
        rays += run.sizes.iter().map(|size| size.rays).sum::<u64>() * u64::from(run.replicates);
        runs.push((run, None));
    }
    let chart = variance_chart("Trees in a glowing room", &runs);
    let caption = "The mean of N trees follows the law 1/N, whatever their shape. A tree of sixteen has less \
                   variance than one of four, but takes thirteen times the rays.";
    desk.figure("rate.svg", caption, chart.to_svg()?)?;
    Ok(rays)
}
