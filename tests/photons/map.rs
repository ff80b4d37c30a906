//! The grid finds what is there.

use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::photons::{Kernel, Photon, PhotonMap};
use halfdisk::sampling::stream::{Purpose, Stream};

#[test]
fn the_map_finds_what_a_loop_finds() {
    let stream = Stream::new(1, 0, 0);
    for (place, scale) in [1e-3_f32, 1.0, 1e6].into_iter().enumerate() {
        let mut numbers = stream.at(place as u64, Purpose::Integrand);
        let mut point = || Vec3::from_array([(); 3].map(|()| scale * (2.0 * numbers.one() - 1.0)));
        let photons: Vec<Photon> = (0..2000_u32)
            .map(|segments| Photon {
                // Half of them in a plane, and some in the corners of cells.
                p: match segments % 4 {
                    0 | 1 => point() * Vec3::new(1.0, 0.0, 1.0),
                    2 => (point() / (0.2 * scale)).round() * (0.2 * scale),
                    _ => point(),
                },
                n: Vec3::Y,
                wi: Vec3::Y,
                power: Rgb::WHITE,
                segments,
            })
            .collect();
        let (mut found, mut wrong) = (0, 0);
        for share in [1e-3, 0.1, 0.3, 5.0] {
            let map = PhotonMap::new(photons.clone(), 1, share * scale, Kernel::Constant);
            assert_eq!(map.photons().len(), photons.len());
            for i in 0..300 {
                let p = if i < 50 { photons[40 * i].p } else { point() };
                let (mut near, mut all) = (Vec::new(), Vec::new());
                map.near(p, |photon| near.push(photon.segments));
                map.near_by_loop(p, |photon| all.push(photon.segments));
                let order = near.clone();
                map.near(p, |photon| near.push(photon.segments));
                assert_eq!(near[order.len()..], order, "the same order each time");
                near.truncate(order.len());
                near.sort_unstable();
                all.sort_unstable();
                assert_eq!(near, all, "radius {share}, at {p}");
                found += all.len();
                // The mistake of looking in one cell only.
                let cell = |p: Vec3| (p / (2.0 * share * scale)).floor();
                let own = |&&s: &&u32| cell(photons[s as usize].p) == cell(p);
                wrong += usize::from(all.iter().filter(own).count() != all.len());
            }
        }
        assert!(found > 100_000 && wrong > 300, "{found} {wrong}");
    }
    for radius in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let map: PhotonMap = PhotonMap::new(Vec::new(), 1, radius, Kernel::Constant);
        map.near(Vec3::ZERO, |_| unreachable!());
    }
}

#[test]
fn a_photon_on_the_edge_of_a_disc_or_of_a_cell_counts_once() {
    let photon = |p: Vec3| -> Photon {
        Photon {
            p,
            n: Vec3::Y,
            wi: Vec3::Y,
            power: Rgb::WHITE,
            segments: 2,
        }
    };
    // Cells have the side 1: this one lies in a corner of eight of them.
    let map = PhotonMap::new(vec![photon(Vec3::ONE)], 1, 0.5, Kernel::Constant);
    let disc = std::f32::consts::PI * 0.25;
    let read = |p| map.estimate(p, Vec3::Y, 0.5, |photon| photon.power).g * disc;
    for (aside, counts) in [
        (0.0, 1.0),
        (0.499, 1.0),
        (0.5, 0.0),
        (-0.499, 1.0),
        (-0.5, 0.0),
    ] {
        for axis in [Vec3::X, Vec3::Z] {
            let x = read(Vec3::ONE + axis * aside);
            assert!((x - counts).abs() < 1e-6, "{aside}: {x}");
        }
    }
    // A radius so small that a disc has no measure in f32, and one so large that it has no end.
    for radius in [1e-23, 1e30] {
        let map = PhotonMap::new(vec![photon(Vec3::ONE)], 1, radius, Kernel::Constant);
        let light = map.estimate(Vec3::ONE, Vec3::Y, radius, |photon| photon.power);
        assert_eq!(light, Rgb::BLACK, "{radius}");
    }
}
