//! A wish to stop is heard at once, also within a long step.

use halfdisk::integrators::Path;
use halfdisk::lab::effects::measure::{Setup, difference_watched};
use halfdisk::lab::effects::words::words_watched;
use halfdisk::lab::experiment::convergence::{Convergence, Design, converge, converge_watched};
use halfdisk::lab::experiment::named;
use halfdisk::render::{Options, Progress, render};
use halfdisk::scene::gallery;
use std::sync::atomic::{AtomicU64, Ordering};

/// Wants to stop when it is asked for the time after `after`.
struct Questions {
    after: u64,
    asked: AtomicU64,
}

fn stop_after(after: u64) -> Questions {
    let asked = AtomicU64::new(0);
    Questions { after, asked }
}

impl Progress for Questions {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.after
    }
}

fn alone<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.unwrap().install(work)
}

#[test]
fn a_render_asks_before_each_sample_and_keeps_those_before() {
    let scene = gallery::load("lamp").unwrap().sized([16, 16]);
    let options = Options {
        spp: 64,
        ..Options::default()
    };
    // One tile of 256 pixels; its last pass has 32 samples for each.
    for after in [0, 1, 100, 8 * 256 + 77, 32 * 256 + 33, 63 * 256] {
        let progress = stop_after(after);
        let found = alone(|| render(&scene, &Path::new(4), &options, &progress));
        let samples = found.film.pixels().iter().map(|p| p.count()).sum::<u64>();
        assert!(found.interrupted);
        assert_eq!(samples, after);
        assert_eq!(found.rays.camera, after);
    }
}

#[test]
fn words_are_counted_whole_or_not_at_all() {
    let scene = gallery::load("lamp").unwrap().sized([8, 4]);
    let options = Options {
        spp: 2,
        ..Options::default()
    };
    let words = |after| {
        let progress = stop_after(after);
        let words = words_watched(&scene, &Path::new(4), &options, 3, &progress);
        (words.is_some(), progress.asked.into_inner())
    };
    // 8 x 4 pixels, 2 samples, 3 replicates.
    assert_eq!(words(192), (true, 192));
    for after in [0, 1, 70, 191] {
        let (complete, asked) = words(after);
        // Each row that is still at work asks once more.
        assert!(!complete && asked <= after + 4, "{after}: {asked}");
    }
}

#[test]
fn a_comparison_ends_within_its_first_picture() {
    let scene = gallery::load("lamp").unwrap().sized([16, 16]);
    let wanted = None;
    let setup = Setup { scene, wanted };
    let progress = stop_after(300);
    let found = alone(|| difference_watched(&setup, &setup, 1 << 20, 3, &progress));
    assert!(found.is_none());
    // The sample that stops the first picture, and the first one of the second.
    assert!(progress.asked.into_inner() <= 302);
}

#[test]
fn what_is_kept_of_an_estimator_is_a_design_of_fewer_replicates() {
    let estimator = named::find("half-disk").unwrap();
    let design = Design {
        replicates: 1 << 20,
        doublings: 10,
        ..Design::default()
    };
    // Asked after each run that was finished.
    let kept = converge_watched(&estimator, &design, &stop_after(20)).unwrap();
    assert!((1..=20).contains(&kept.replicates), "{}", kept.replicates);
    let fewer = Design {
        replicates: kept.replicates,
        ..design
    };
    // The slope of very few replicates is not a number, which is equal to nothing.
    let text = |c: &Convergence| serde_json::to_string(c).unwrap();
    assert_eq!(text(&kept), text(&converge(&estimator, &fewer)));
    let nothing = converge_watched(&estimator, &design, &stop_after(0));
    assert!(nothing.is_none());
}

#[test]
fn an_estimator_is_run_by_the_only_thread_there_is() {
    let estimator = named::find("darts").unwrap();
    let design = Design {
        replicates: 8,
        doublings: 4,
        ..Design::default()
    };
    let watched = |stop| alone(|| converge_watched(&estimator, &design, &stop_after(stop)));
    // Where the pool's thread waits for itself, this is asked for ever and stops without any run.
    let all = watched(100).expect("runs before the wish to stop");
    assert_eq!(all, converge(&estimator, &design));
    assert_eq!(watched(3).map(|some| some.replicates), Some(3));
}
