//! Pictures that are put together from their parts.

use halfdisk::integrators::{Integrator, LightTracer, Path, Photons};
use halfdisk::output::{self, Display, Merged, Parts, Provenance, merged};
use halfdisk::render::{Film, Options, Pixel, Shard, State, Tally, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::Estimate;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::path::{Path as File, PathBuf};

/// A kind of picture.
struct Kind {
    scene: Scene,
    integrator: Box<dyn Integrator>,
    sampler: Sampler,
    spp: u32,
}

fn kind(scene: &str, integrator: Box<dyn Integrator>, sampler: Sampler, spp: u32) -> Kind {
    let scene = gallery::load(scene).unwrap().sized([12, 10]);
    Kind {
        scene,
        integrator,
        sampler,
        spp,
    }
}

impl Kind {
    /// Renders a picture, or a part of it.
    fn write(&self, file: &File, seed: u64, shard: Option<Shard>) {
        let options = Options {
            spp: self.spp,
            seed,
            sampler: self.sampler,
            shard,
            ..Options::default()
        };
        let rendered = render(&self.scene, &*self.integrator, &options, &());
        let shards = shard.map_or(Vec::new(), |s| vec!["--shard".to_owned(), s.to_string()]);
        let command = ["render", "scene", "--seed", &seed.to_string()].map(str::to_owned);
        let facts = Provenance {
            sampler: self.sampler,
            shard,
            command: [command.to_vec(), shards].concat(),
            fingerprint: self.scene.fingerprint().ok(),
            tally: Some(Tally::from(&rendered)),
            ..Provenance::new(&self.scene, "name", 6, self.spp.into(), seed)
        };
        output::write(file, &rendered.film, Display::Radiance, &facts).unwrap();
    }

    /// The average of `count` pictures of seeds that no other average has.
    fn average(&self, folder: &File, number: u64, count: u64) -> Merged {
        let file = |i| folder.join(format!("{i}.exr"));
        for i in 0..count {
            self.write(&file(i), number * count + i, None);
        }
        let files: Vec<PathBuf> = (0..count).map(file).collect();
        merged(&files, Parts::Seeds).unwrap()
    }
}

/// Of averages of four seeds each: what they claim of their pixels' squared errors and of their mean's, over what the
/// scatter of the averages is.
fn claimed_over_true(kind: &Kind, averages: u64) -> [f64; 2] {
    let folder = tempfile::tempdir().unwrap();
    let pixels = kind.scene.size.iter().product::<u32>() as usize;
    let (mut truth, mut claims) = (
        vec![[Estimate::new(); 3]; pixels],
        vec![[Estimate::new(); 3]; pixels],
    );
    let [mut means, mut of_means] = [Estimate::new(); 2];
    for number in 0..averages {
        let average = kind.average(folder.path(), number, 4);
        let pixels = average
            .film
            .pixels()
            .iter()
            .zip(truth.iter_mut().zip(&mut claims));
        for (pixel, (truth, claims)) in pixels {
            assert_eq!(pixel.count(), 4 * u64::from(kind.spp));
            let (mean, errors) = (pixel.mean().unwrap(), pixel.std_errors());
            for i in 0..3 {
                truth[i].add(mean[i]);
                claims[i].add(errors[i] * errors[i]);
            }
        }
        let mean = average.mean.unwrap();
        means.add(mean.value);
        of_means.add(mean.error * mean.error);
    }
    // Pixel by pixel, for a few bright samples decide over the sum.
    let pairs = claims.iter().flatten().zip(truth.iter().flatten());
    let ratios = pairs
        .filter(|(_, truth)| truth.variance() > 0.0)
        .map(|(claim, truth)| claim.mean() / truth.variance());
    [
        ratios.collect::<Estimate>().mean(),
        of_means.mean() / means.variance(),
    ]
}

#[test]
fn the_error_of_an_average_is_that_of_its_seeds() {
    let path = || Box::new(Path::new(5));
    for (kind, most) in [
        // A picture too short for a run of even samples is one.
        (kind("cornell", path(), Sampler::Sobol, 4), 0.12),
        (kind("cornell", path(), Sampler::Sobol, 40), 0.12),
        (kind("cornell", path(), Sampler::Independent, 4), 0.12),
        (
            kind(
                "caustic",
                Box::new(LightTracer { max_depth: 5 }),
                Sampler::Independent,
                4,
            ),
            0.12,
        ),
    ] {
        let [pixels, mean] = claimed_over_true(&kind, 60);
        assert!(
            (pixels - 1.0).abs() < most,
            "{:?} {}: {pixels}",
            kind.sampler,
            kind.spp
        );
        assert!(mean > 0.6 && mean < 2.5, "{mean}");
    }
}

/// Where all pixels of a picture are too bright together, they seem to know its mean far better than they do.
#[test]
fn the_mean_of_an_average_knows_what_pixels_share() {
    let folder = tempfile::tempdir().unwrap();
    let kind = kind("cornell", Box::new(Path::new(5)), Sampler::Independent, 2);
    let files = [1.0, 2.0].map(|light| {
        let pixel = Pixel {
            channels: [[light, light + 0.001].into_iter().collect(); 3],
            taken: 2,
            ..Pixel::default()
        };
        let file = folder.path().join(format!("{light}.exr"));
        let facts = Provenance {
            tally: Some(Tally::default()),
            ..Provenance::new(&kind.scene, "name", 6, 2, light as u64)
        };
        let film = Film::new(12, vec![pixel; 120]);
        output::write(&file, &film, Display::Radiance, &facts).unwrap();
        file
    });
    let mean = merged(&files, Parts::Seeds).unwrap().mean.unwrap();
    assert!((mean.value - 1.5005).abs() < 1e-9, "{mean:?}");
    assert!((mean.error - 0.5).abs() < 1e-9, "{mean:?}");
}

fn same(a: &Merged, b: &Merged) -> bool {
    a.film == b.film && a.facts == b.facts && a.mean == b.mean
}

#[test]
fn an_average_is_the_same_in_any_order_of_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let kind = kind("cornell", Box::new(Path::new(5)), Sampler::Sobol, 20);
    let mut files: Vec<PathBuf> = [7, 3, 11, 4, 5]
        .map(|seed| {
            let file = folder.path().join(format!("{seed}.exr"));
            kind.write(&file, seed, None);
            file
        })
        .to_vec();
    let first = merged(&files, Parts::Seeds).unwrap();
    assert_eq!(first.facts.seeds, [3, 4, 5, 7, 11]);
    assert_eq!((first.facts.spp, first.facts.seed), (100, 3));
    assert_eq!(first.facts.command, ["render", "scene", "--seed", "3"]);
    assert!(first.facts.tally.is_none(), "no render goes on from it");
    for _ in 0..4 {
        files.rotate_left(2);
        files.swap(0, 1);
        assert!(same(&first, &merged(&files, Parts::Seeds).unwrap()));
    }
}

/// Bits that fall over, files that end too early, and heads on the wrong body.
fn damaged(random: &mut Pcg32, whole: &[u8], other: &[u8]) -> Vec<u8> {
    let mut bytes = whole.to_vec();
    match random.random_range(0..4) {
        0 => {
            let at = random.random_range(0..bytes.len());
            bytes[at] ^= 1 << random.random_range(0..8);
        }
        1 => bytes.truncate(random.random_range(0..whole.len())),
        2 => {
            let [from, to] = [0, 0].map(|_| random.random_range(0..bytes.len() - 32));
            bytes.copy_within(from..from + 32, to);
        }
        _ => {
            let cut = random.random_range(0..whole.len().min(other.len()));
            bytes = [&other[..cut], &whole[cut..]].concat();
        }
    }
    bytes
}

/// Where the digits stand in what a file says of its render.
fn digits_of_the_head(bytes: &[u8]) -> Vec<usize> {
    let find = |from: usize, text: &[u8]| {
        let mut windows = bytes[from..].windows(text.len());
        from + windows.position(|window| window == text).unwrap()
    };
    let start = find(0, b"{\"software\"");
    let end = find(start, b"\"checksum\"");
    (start..end)
        .filter(|&at| bytes[at].is_ascii_digit())
        .collect()
}

#[test]
fn damaged_parts_are_refused_or_change_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = kind("cornell", Box::new(Path::new(4)), Sampler::Sobol, 17);
    let path = Kind {
        scene: path.scene.sized([40, 20]),
        ..path
    };
    let mut random = Pcg32::seed_from_u64(4);
    let mut refused = 0;
    for parts in [Parts::Shards, Parts::Seeds] {
        let files: Vec<PathBuf> = (1..=3)
            .map(|index| {
                let file = folder.path().join(format!("{parts:?}-{index}.exr"));
                match parts {
                    Parts::Shards => path.write(&file, 0, Some(Shard { index, count: 3 })),
                    Parts::Seeds => path.write(&file, index.into(), None),
                }
                file
            })
            .collect();
        let bytes: Vec<Vec<u8>> = files.iter().map(|f| std::fs::read(f).unwrap()).collect();
        let whole = merged(&files, parts).unwrap();
        let mut check = |which: usize, bad: Vec<u8>, what: &str| {
            std::fs::write(&files[which], bad).unwrap();
            match merged(&files, parts) {
                // What its picture shows may have changed, not what is merged.
                Ok(again) => assert!(same(&again, &whole), "{parts:?}: {what}"),
                Err(said) => {
                    refused += 1;
                    let said = said.to_string();
                    let name = files[which].display().to_string();
                    assert!(said.contains(&name), "{what}: {said}");
                }
            }
            std::fs::write(&files[which], &bytes[which]).unwrap();
        };
        for i in 0..500 {
            let which = random.random_range(0..3);
            let other = (which + random.random_range(0..3)) % 3;
            let bad = damaged(&mut random, &bytes[which], &bytes[other]);
            check(which, bad, &i.to_string());
        }
        // What the head says: compression notices nothing there.
        for at in digits_of_the_head(&bytes[1]) {
            let mut bad = bytes[1].clone();
            bad[at] = if bad[at] == b'9' { b'0' } else { bad[at] + 1 };
            check(1, bad, &format!("digit at byte {at}"));
        }
    }
    assert!(refused > 800, "{refused}");
}

#[test]
fn a_pixel_of_two_seeds_has_the_samples_of_both() {
    let pixel = |values: &[f64]| Pixel {
        channels: [values.iter().copied().collect(); 3],
        taken: values.len() as u32,
        ..Pixel::default()
    };
    let state = |values: &[f64]| State {
        film: Film::new(1, vec![pixel(values)]),
        tally: Tally::default(),
    };
    for (sampler, runs) in [(Sampler::Independent, 0), (Sampler::Sobol, 2)] {
        let mut both = state(&[1.0, 2.0, 6.0]);
        both.add_seed(&state(&[3.0, 4.0, 8.0]), sampler);
        let [pixel] = both.film.pixels() else {
            panic!()
        };
        assert_eq!((pixel.count(), pixel.taken), (6, 6));
        assert_eq!(pixel.mean(), Some([4.0; 3]));
        assert!((pixel.channels[0].variance() - 6.8).abs() < 1e-12);
        assert_eq!(pixel.runs[0].count(), runs);
        // The means of the pictures are 3 and 5.
        let error = if runs == 2 {
            1.0
        } else {
            (6.8_f64 / 6.0).sqrt()
        };
        assert!((pixel.std_errors()[0] - error).abs() < 1e-12);
    }
}

#[test]
fn shards_of_any_number_are_the_whole_for_every_integrator() {
    let size = [70, 50];
    for name in ["cornell", "caustic", "spheres"] {
        let scene = gallery::load(name).unwrap().sized(size);
        let photons = Photons {
            walks: Some(500),
            ..Photons::new(5)
        };
        let integrators: [(Box<dyn Integrator>, Sampler); 3] = [
            (Box::new(Path::new(5)), Sampler::Sobol),
            (Box::new(LightTracer { max_depth: 5 }), Sampler::Independent),
            (Box::new(photons), Sampler::Independent),
        ];
        for (integrator, sampler) in integrators {
            let state = |shard| {
                let options = Options {
                    spp: 2,
                    sampler,
                    shard,
                    ..Options::default()
                };
                State::from(&render(&scene, &*integrator, &options, &()))
            };
            let mut whole = state(None);
            // Known of whole pictures alone, and in no file.
            whole.tally.passes = Estimate::new();
            for count in [2, 7, 64] {
                let shard = |index| Shard { index, count };
                let mut merged = state(Some(shard(1)));
                for index in 2..=count {
                    let mut part = state(Some(shard(index)));
                    part.film = part.film.packed(shard(index));
                    merged.add_shard(&part, shard(index));
                }
                merged.tally.passes = Estimate::new();
                assert!(merged == whole, "{name}, {count} shards");
            }
        }
    }
}
