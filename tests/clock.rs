//! Pictures that the clock ended, of scenes of the gallery: their mean is that of long ones.

use crate::checks::CRITICAL;
use crate::stopping::{Counted, Work, for_time, options, small};
use halfdisk::integrators::Path;
use halfdisk::render::stopping::{StoppedBy, render_to};
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::stats::Estimate;

#[test]
fn pictures_that_the_clock_ended_have_the_mean_of_long_ones() {
    clock_ended("cornell", 5, 4500, Sampler::Sobol, [600, 4096], 0.08);
}

#[test]
#[ignore = "takes minutes"]
fn long_pictures_that_the_clock_ended_have_the_mean_of_long_ones() {
    clock_ended(
        "cornell",
        5,
        4500,
        Sampler::Independent,
        [3000, 40_000],
        0.04,
    );
    clock_ended("cornell", 5, 4500, Sampler::Sobol, [3000, 40_000], 0.04);
    clock_ended("spheres", 6, 22_500, Sampler::Sobol, [3000, 40_000], 0.04);
}

/// Pictures of `runs` seeds against one of `long` samples; a bias of `smallest` would be seen.
fn clock_ended(
    name: &str,
    depth: u32,
    time: u64,
    sampler: Sampler,
    [runs, long]: [u32; 2],
    smallest: f64,
) {
    let scene = small(name, [12, 12]);
    let long = Options {
        spp: long,
        ..options(1 << 40, Sampler::Sobol)
    };
    let (truth, off) = render(&scene, &Path::new(depth), &long, &()).film.mean();
    let (mut means, mut spp) = (Estimate::new(), Estimate::new());
    for seed in 0..u64::from(runs) {
        let work = Work::default();
        let path = Counted(Path::new(depth), &work);
        let outcome = render_to(
            &scene,
            &path,
            &options(seed, sampler),
            &for_time(time),
            &work,
        );
        assert_eq!(outcome.stopped_by, StoppedBy::Time);
        means.add(outcome.rendered.film.mean().0);
        spp.add(outcome.spp.into());
    }
    let error = means.std_error().hypot(off);
    let bias = (means.mean() - truth) / truth;
    let seen = CRITICAL * error / truth;
    println!(
        "{name}, {sampler:?}: {:.1} samples, bias {:+.3} %; the smallest seen is {:.3} %",
        spp.mean(),
        100.0 * bias,
        100.0 * seen
    );
    assert!(bias.abs() <= seen, "{name}, {sampler:?}: {bias} {seen}");
    assert!(seen < smallest && spp.mean() > 2.0, "{seen} {}", spp.mean());
}
