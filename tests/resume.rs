//! A render that goes on from a file is the one that never stopped.

use halfdisk::integrators::{Integrator, LightTracer, Path, Photons};
use halfdisk::output::{self, Display, Provenance, made};
use halfdisk::render::stopping::{Goal, render_from, render_to};
use halfdisk::render::{Options, Progress, Rendered, Session, State, Tally, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::{Scene, gallery};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::sync::atomic::{AtomicU32, Ordering};

fn scene(name: &str) -> Scene {
    gallery::load(name).unwrap().sized([20, 18])
}

fn options(spp: u32, sampler: Sampler) -> Options {
    Options {
        spp,
        seed: 3,
        sampler,
        ..Options::default()
    }
}

/// Scenes, what renders them, and how their samples lie: with caustics and without, with passes of every kind.
fn renders() -> Vec<(Scene, Box<dyn Integrator>, Sampler)> {
    let photons = Photons::new(6);
    vec![
        (scene("cornell"), Box::new(Path::new(6)), Sampler::Sobol),
        (scene("caustic"), Box::new(Path::new(6)), Sampler::Sobol),
        (scene("gloss"), Box::new(Path::new(6)), Sampler::Independent),
        (
            scene("caustic"),
            Box::new(LightTracer { max_depth: 6 }),
            Sampler::Independent,
        ),
        (scene("spheres"), Box::new(photons), Sampler::Independent),
    ]
}

/// Stops at the n-th question.
struct Until(AtomicU32);

impl Progress for Until {
    fn tell(&self, _: u64, _: u64) {}

    fn stop(&self) -> bool {
        let left = self.0.load(Ordering::Relaxed);
        self.0.store(left.saturating_sub(1), Ordering::Relaxed);
        left == 0
    }
}

/// What a render knows, but for the rays that passes took: one that was stopped takes its last again.
fn known(rendered: &Rendered) -> State {
    let mut state = State::from(rendered);
    state.tally.rays = Default::default();
    state.tally.pass_rays = Default::default();
    state.tally.passes = Default::default();
    state
}

#[test]
fn a_render_in_steps_is_the_render_at_once() {
    for (scene, integrator, sampler) in &renders() {
        let whole = render(scene, &**integrator, &options(150, *sampler), &());
        let mut state = None;
        for spp in [1, 5, 40, 64, 100, 150] {
            let options = options(spp, *sampler);
            let outcome = render_from(
                state.as_ref(),
                scene,
                &**integrator,
                &options,
                &Goal::default(),
                &(),
            );
            state = Some(State::from(&outcome.rendered));
        }
        assert_eq!(state.unwrap(), State::from(&whole), "{}", scene.name);
    }
}

#[test]
fn a_render_that_was_stopped_anywhere_goes_on() {
    let mut random = Pcg32::seed_from_u64(1);
    for (scene, integrator, sampler) in &renders() {
        let options = options(40, *sampler);
        let whole = render(scene, &**integrator, &options, &());
        for _ in 0..4 {
            let mut session = Session::new(scene, &**integrator, &options);
            let stop = Until(random.random_range(300..14_000).into());
            session.advance(40, &stop);
            let stopped = State::from(&session.rendered());
            let mut session = Session::resume(scene, &**integrator, &options, &stopped);
            session.advance(40, &());
            assert_eq!(known(&session.rendered()), known(&whole), "{}", scene.name);
        }
    }
}

#[test]
fn a_target_is_reached_by_the_same_samples() {
    let (scene, path) = (scene("cornell"), Path::new(6));
    let goal = Goal {
        error: Some(0.06),
        ..Goal::default()
    };
    let options = options(1, Sampler::Sobol);
    let whole = render_to(&scene, &path, &options, &goal, &());
    let few = render(&scene, &path, &Options { spp: 17, ..options }, &());
    let resumed = render_from(
        Some(&State::from(&few)),
        &scene,
        &path,
        &options,
        &goal,
        &(),
    );
    let before = resumed.rendered.rays_before;
    assert_eq!(before, few.rays, "speed is told of new rays alone");
    assert_eq!(whole.rendered.rays_before, Default::default());
    assert_eq!(State::from(&resumed.rendered), State::from(&whole.rendered));
}

/// A file, and the render that it holds.
fn file(folder: &std::path::Path) -> (std::path::PathBuf, State) {
    let scene = scene("cornell");
    let rendered = render(&scene, &Path::new(4), &options(70, Sampler::Sobol), &());
    let facts = Provenance {
        tally: Some(Tally::from(&rendered)),
        ..Provenance::new(&scene, "path", 4, 70, 3)
    };
    let path = folder.join("a.exr");
    output::write(&path, &rendered.film, Display::Radiance, &facts).unwrap();
    (path, State::from(&rendered))
}

#[test]
fn a_file_keeps_every_bit() {
    let folder = tempfile::tempdir().unwrap();
    let (path, state) = file(folder.path());
    assert_eq!(made(&path).unwrap().1.unwrap(), state);
}

#[test]
fn a_damaged_file_is_refused_or_has_the_same_state() {
    let folder = tempfile::tempdir().unwrap();
    let (path, state) = file(folder.path());
    let whole = std::fs::read(&path).unwrap();
    let mut random = Pcg32::seed_from_u64(2);
    let mut refused = 0;
    for i in 0..300 {
        let mut bytes = whole.clone();
        match i % 3 {
            0 => {
                let at = random.random_range(0..bytes.len());
                bytes[at] ^= 1 << random.random_range(0..8);
            }
            1 => bytes.truncate(random.random_range(0..whole.len())),
            _ => {
                let [from, to] = [0, 0].map(|_| random.random_range(0..bytes.len() - 32));
                bytes.copy_within(from..from + 32, to);
            }
        }
        std::fs::write(&path, bytes).unwrap();
        match made(&path) {
            // What the picture shows may have changed, not what goes on from it.
            Ok((_, Some(read))) => assert_eq!(read, state, "{i}"),
            Ok((_, None)) => panic!("{i}: its state is lost without a word"),
            Err(_) => refused += 1,
        }
    }
    assert!(refused > 200, "{refused}");
}
