//! How long whole pictures take: samples of each integrator on scenes of the gallery.
#![allow(missing_docs, clippy::expect_used)]

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use halfdisk::integrators::{Integrator, Kajiya, NextEvent, Path, Whitted};
use halfdisk::render::{Options, render};
use halfdisk::scene::gallery;

const SIDE: u32 = 64;

fn picture(group: &mut BenchmarkGroup<WallTime>, scene: &str, name: &str, by: &impl Integrator) {
    let loaded = gallery::load(scene).expect("a scene of the gallery");
    let loaded = loaded.sized([SIDE; 2]);
    let options = Options {
        spp: 1,
        ..Options::default()
    };
    group.bench_function(format!("{scene}, {name}"), |b| {
        b.iter(|| render(&loaded, by, &options, &()).rays);
    });
}

fn pictures(c: &mut Criterion) {
    let mut group = c.benchmark_group("samples");
    group.throughput(Throughput::Elements(u64::from(SIDE * SIDE)));
    for scene in ["cornell", "spheres", "mesh"] {
        picture(&mut group, scene, "whitted", &Whitted { max_depth: 8 });
        picture(&mut group, scene, "kajiya", &Kajiya { max_depth: 8 });
        picture(&mut group, scene, "next-event", &NextEvent { max_depth: 8 });
        picture(&mut group, scene, "path", &Path::new(8));
    }
    group.finish();
}

criterion_group!(all, pictures);
criterion_main!(all);
