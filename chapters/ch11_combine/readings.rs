//! Readings that must be right, and readings that must not.

use crate::sweep::to;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::world::FlatTracer;
use halfdisk::integrators::{Combine, Integrator, Kajiya, NextEvent};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::estimators::overhead::{Overhead, Technique};
use halfdisk::lab::mistakes::misled::{Misled, Slip};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::description::Material;
use halfdisk::scene::value::Albedo;
use halfdisk::scene::{Tracer, gallery};
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::{FOUR, Largest, z_test};

/// What each walk reads in a closed room whose walls glow: the rays, and how far
/// they are from the truth.
pub fn furnace(desk: &mut Desk) -> Result<(u64, Largest), DeskError> {
    let walks = desk.choose(2_000, 1_000);
    let mut rays = 0;
    let mut compared = Largest::default();
    for (percent, max_depth) in [(50, 24), (75, 48)] {
        let albedo = f64::from(percent) / 100.0;
        let scene = gallery::load_with("furnace", |said| {
            for material in said.materials.values_mut() {
                *material = Material::Lambert {
                    albedo: Albedo([albedo; 3]).into(),
                };
            }
        })?;
        let exact = (1.0 - albedo.powi(max_depth as i32)) / (1.0 - albedo);
        let mut tracer = Tracer::new(&scene);
        let mut read = |integrator: &dyn Fn(&mut Tracer, &Ray, &Stream) -> Rgb| -> Estimate {
            let one = |i| {
                let stream = Stream::new(desk.options.seed, i, 1);
                let ray = scene.camera.ray(0.3, 0.6);
                f64::from(integrator(&mut tracer, &ray, &stream).r)
            };
            (0..walks).map(one).collect()
        };
        let heuristic = Heuristic::Power;
        let both = Combine {
            max_depth,
            heuristic,
        };
        let found = [
            ("chance", read(&|t, r, s| Kajiya { max_depth }.li(t, r, s))),
            (
                "aiming",
                read(&|t, r, s| NextEvent { max_depth }.li(t, r, s)),
            ),
            ("both", read(&|t, r, s| both.li(t, r, s))),
        ];
        rays += tracer.counts().total();
        for (way, estimate) in found {
            let says = format!("glowing room of albedo {albedo}, {way}");
            desk.estimate(
                &format!("furnace_{way}_{percent}"),
                &says,
                &estimate,
                Some(exact),
            );
            let says = format!("variance in that room, {way}");
            desk.value(
                &format!("furnace_variance_{way}_{percent}"),
                &says,
                estimate.variance(),
            );
            compared.add(z_test(&estimate, exact, FOUR).z);
        }
    }
    Ok((rays, compared))
}

/// What combined walks read that are misled, under a lamp in two parts.
pub fn mistakes(desk: &mut Desk) -> Result<(), DeskError> {
    let (lamp, heuristic) = (Overhead::new(1.0), Heuristic::Balance);
    let world = lamp.world(2)?;
    let walks = desk.choose(40_000, 10_000);
    let seven = 0.93;
    for (name, says, slip) in [
        ("twice", "both weights one", Slip::CountedTwice),
        (
            "density",
            "density 7 % off everywhere",
            Slip::Density(seven),
        ),
        ("both", "7 % off in both weights", Slip::BothWeights(seven)),
        ("one", "7 % off in one weight", Slip::OneWeight(seven)),
        ("selection", "selection forgotten", Slip::Selection),
    ] {
        let mut misled = Misled {
            world: FlatTracer::new(&world),
            slip,
        };
        let mut one = |i| {
            let stream = Stream::new(desk.options.seed, i, 2);
            Technique::Both(heuristic).walk(&mut misled, &stream)
        };
        let read: Estimate = (0..walks).map(&mut one).collect();
        let exact = slip.reading(&lamp, 2, heuristic);
        desk.estimate(
            &format!("slip_{name}"),
            &format!("reads: {says}"),
            &read,
            Some(exact),
        );
        let z = Number::new(
            "its distance from the truth, standard errors",
            to(10.0, read.z(lamp.mean())),
        );
        desk.number(&format!("slip_z_{name}"), z);
    }
    desk.value("slip_truth", "the truth", lamp.mean());
    Ok(())
}
