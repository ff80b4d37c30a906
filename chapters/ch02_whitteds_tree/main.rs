//! Chapter 2: Whitted's tree.
//!
//! Question: what does a tree of mirror, glass and shadow rays see, and what does it cost?
//! New here: `integrators::Whitted`. Simulates `LD?S*E`. Builds on: chapter 1 (rays from the eye).

mod figures;
mod interface;

use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{TreeCount, TreeObserver, TreeRecord, Whitted};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use halfdisk::render::{Options, Rendered, compare, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer, gallery};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch02",
    title: "Whitted's tree",
    question: "What does a tree of mirror, glass and shadow rays see, and what does it cost?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // The picture, and the tree of one of its pixels.
    let scene = gallery::load("whitted")?.sized([640, 400]);
    let max_depth = scene.suggested.max_depth;
    let picture = desk.finale(&scene, &Whitted { max_depth }, &figures::FINALE)?;
    let mut record = TreeRecord::default();
    let [s, t] = figures::PIXEL;
    tree(&scene, scene.camera.ray(s, t), 7, &mut record);
    let says = "rays in the tree of one pixel, seven segments deep";
    desk.value("tree_rays", says, record.rays.len() as f64);
    figures::one_tree(desk, &record)?;

    interface::drawings(desk)?;

    // ANCHOR: splitter
    // Sheets of glass in which every ray splits: 1, 2, 4, 8 … rays, of the same weight in all.
    let splitter = gallery::load("splitter")?;
    let mut count = TreeCount::default();
    tree(&splitter, straight(&splitter), 14, &mut count);
    // ANCHOR_END: splitter
    let split = figures::growth(desk, &count)?;

    // ANCHOR: slab
    // What a slab lets through and reflects, when its rays have bounced inside thirty times.
    let slab = gallery::load("slab")?;
    let li = tree(&slab, straight(&slab), 32, &mut ());
    let f = 0.04; // what one face reflects at normal incidence
    let through = (1.0 - f) / (1.0 + f);
    desk.known(
        "slab_through",
        "glass slab: share of light let through",
        li.r.into(),
        through,
    );
    let back = 2.0 * f / (1.0 + f);
    desk.known(
        "slab_back",
        "glass slab: share of light reflected",
        li.g.into(),
        back,
    );
    // ANCHOR_END: slab
    let bound = f64::powi(f, 30);
    desk.value(
        "slab_left",
        "bound on the weight of all rays not followed",
        bound,
    );

    // ANCHOR: tunnel
    // A mirror corridor: the lamp at its end, mirrored n times by 0.9.
    let tunnel = gallery::load("tunnel")?;
    let mut worst = 0.0_f64;
    for n in 0..=6 {
        let toward = Vec3::new(6.0, n as f32, 0.0).normalize();
        let li = tree(&tunnel, Ray::new(Vec3::ZERO, toward), 16, &mut ());
        worst = worst.max((f64::from(li.r) - f64::powi(0.9, n)).abs());
    }
    // ANCHOR_END: tunnel
    let says = "mirror corridor: largest distance from 0.9^n, n = 0 … 6";
    desk.known("tunnel_error", says, worst, 0.0);

    // What each further depth adds to the picture, and costs.
    let mut gains = Vec::new();
    let small = scene.clone().sized([160, 100]);
    let mut before = whole(desk, &small, 2)?;
    let mut spent = picture.rays.total() + before.rays.total();
    for depth in 3..=desk.choose(10, 6) {
        let now = whole(desk, &small, depth)?;
        spent += now.rays.total();
        let change = compare::mse(&now.film.picture(), &before.film.picture()).sqrt();
        let added = now.rays.total() - before.rays.total();
        let per_sample = added as f64 / now.rays.camera as f64;
        gains.push((f64::from(depth), change, per_sample));
        before = now;
    }
    figures::gain(desk, &gains)?;

    let variance = picture.film.sample_variance();
    let rays_per_sample = picture.rays.total() as f64 / picture.rays.camera as f64;
    Ok(Ledger {
        rays: spent + split,
        variance: Some(variance),
        efficiency: Some(1.0 / (variance * rays_per_sample)),
        ..Ledger::of(
            "Mirrors and glass, sharp and exact; each further depth may double the rays and adds \
             less to the picture.",
        )
    })
}

/// The radiance along one ray, with someone looking on.
fn tree(scene: &Scene, ray: Ray, max_depth: u32, watcher: &mut impl TreeObserver) -> Rgb {
    let stream = Stream::new(0, 0, 0);
    Whitted { max_depth }.watch(&mut Tracer::new(scene), &ray, &stream, watcher)
}

/// The ray through the middle of the picture.
fn straight(scene: &Scene) -> Ray {
    scene.camera.ray(0.5, 0.5)
}

/// The whole picture, by paths of up to `max_depth` segments.
fn whole(desk: &Desk, scene: &Scene, max_depth: u32) -> Result<Rendered, DeskError> {
    let options = Options {
        spp: desk.spp(9, 4),
        seed: desk.options.seed,
        ..Options::default()
    };
    let rendered = render(
        scene,
        &Whitted { max_depth },
        &options,
        &desk.bar("whitted"),
    );
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
