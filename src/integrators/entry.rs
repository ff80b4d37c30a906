//! What everyone needs to know of an integrator that can be asked for by name.

use super::{Integrator, Refused, Settings};
use crate::scene::Scene;

/// An integrator of the table: its name, its constructor, and the light it finds.
///
/// Each integrator states its own beside its algorithm. The command line, prices, coverage, the
/// classes of light and the book read it there.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// How it is written.
    pub name: &'static str,
    /// How it finds light, in a few words.
    pub about: &'static str,
    /// The same in a sentence, for who has to choose one.
    pub help: &'static str,
    /// How it is made: see [`Entry::prepare`].
    pub(super) make: Make,
    /// What its pictures show.
    pub shows: Shows,
    /// The longest path it can follow, in segments.
    pub longest: u32,
    /// True where its paths end by chance, whatever their longest is said to be.
    pub is_endless: bool,
    /// Why its expectation is not the light that it finds, at any number of samples, so that the scatter of
    /// samples is not all of its error; `None` where it is unbiased.
    pub biased: Option<&'static str>,
}

/// Makes an integrator for a scene, or refuses.
pub(super) type MakePrepared = fn(&Scene, &Settings) -> Result<Box<dyn Integrator>, Refused>;

/// How an integrator is made.
#[derive(Clone, Copy, Debug)]
pub(super) enum Make {
    /// From the longest path that it follows, in segments.
    Plain(fn(max_depth: u32) -> Box<dyn Integrator>),
    /// From the longest path and how many photons there are.
    Photons(fn(&Settings) -> Box<dyn Integrator>),
    /// From the scene.
    Prepared(MakePrepared),
}

/// What the pictures of an integrator show.
#[derive(Clone, Copy, Debug)]
pub enum Shows {
    /// Radiance: these paths of these sources.
    Light(Finds),
    /// Numbers that belong to the geometry; on a screen this one is white, or the largest.
    Geometry {
        /// Shown as white; `None` for the largest number of the picture.
        white: Option<f64>,
    },
}

/// The light that an integrator finds, by its sources.
#[derive(Clone, Copy, Debug)]
pub struct Finds {
    /// Of lamps with extent.
    pub lamps: Found,
    /// Of an image around the scene.
    pub image: Found,
    /// Of a background of one colour.
    pub sky: Found,
    /// Of points and directions.
    pub points: Found,
    /// True where it meets lamps by chance alone, so that it may not have met one yet.
    pub by_chance: bool,
}

/// The paths that an integrator finds from one kind of source.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// Its paths as an expression; `None` where there are none.
    pub paths: Option<&'static str>,
    /// Why it finds no others; empty where it finds all.
    pub because: &'static str,
}

impl Found {
    /// All paths there are.
    pub const ALL: Found = Found {
        paths: Some("L(D|S|G)*E"),
        because: "",
    };
}

impl Finds {
    /// What a walk from the eye finds that meets lamps and the sky by chance.
    pub const BY_CHANCE: Finds = Finds {
        lamps: Found::ALL,
        image: Found::ALL,
        sky: Found::ALL,
        points: Found {
            paths: None,
            because: "a random walk never meets a point or a direction",
        },
        by_chance: true,
    };

    /// What a walk from the eye finds that also aims at lights from every rough surface.
    pub const BY_AIMING: Finds = Finds {
        points: Found {
            paths: Some("L(D|G)(D|S|G)*E"),
            because: "no walk from the eye meets a point or a direction, and no shadow ray goes through \
                      mirrors or glass",
        },
        by_chance: false,
        ..Finds::BY_CHANCE
    };
}

impl Entry {
    /// An integrator of light, whose paths may be of any length.
    pub(super) const fn of_light(
        names: [&'static str; 3],
        finds: Finds,
        make: fn(u32) -> Box<dyn Integrator>,
    ) -> Entry {
        Entry::new(names, finds, Make::Plain(make))
    }

    /// An integrator of light that looks at the scene before it answers.
    pub(super) const fn of_solved_light(
        names: [&'static str; 3],
        finds: Finds,
        make: MakePrepared,
    ) -> Entry {
        Entry::new(names, finds, Make::Prepared(make))
    }

    /// An integrator of light that photons bring.
    pub(super) const fn of_photons(
        names: [&'static str; 3],
        finds: Finds,
        make: fn(&Settings) -> Box<dyn Integrator>,
    ) -> Entry {
        Entry::new(names, finds, Make::Photons(make))
    }

    const fn new([name, about, help]: [&'static str; 3], finds: Finds, make: Make) -> Entry {
        Entry {
            name,
            about,
            help,
            make,
            shows: Shows::Light(finds),
            longest: u32::MAX,
            is_endless: false,
            biased: None,
        }
    }

    /// A picture of the geometry, in which `white` is shown as [`Shows::Geometry`] says.
    pub(super) const fn of_geometry(
        [name, about, help]: [&'static str; 3],
        white: Option<f64>,
        make: fn(u32) -> Box<dyn Integrator>,
    ) -> Entry {
        Entry {
            shows: Shows::Geometry { white },
            ..Entry::of_light([name, about, help], Finds::BY_CHANCE, make)
        }
    }

    /// The integrator for `scene`, whose paths have at most [`Settings::max_depth`] segments, and at most
    /// [`Entry::longest`].
    ///
    /// Most are made at once for any scene. One that solves the scene beforehand takes its time, tells
    /// how far it is, and refuses what it cannot hold.
    pub fn prepare(
        &self,
        scene: &Scene,
        settings: &Settings,
    ) -> Result<Box<dyn Integrator>, Refused> {
        let max_depth = settings.max_depth.min(self.longest);
        let settings = Settings {
            max_depth,
            ..*settings
        };
        match self.make {
            Make::Plain(make) => Ok(make(max_depth)),
            Make::Photons(make) => Ok(make(&settings)),
            Make::Prepared(make) => make(scene, &settings),
        }
    }

    /// True where photons bring its light: how many, and on how large discs, can be asked for.
    pub const fn has_photons(&self) -> bool {
        matches!(self.make, Make::Photons(_))
    }

    /// True where it looks at the scene before it answers: making it takes time, and it may refuse.
    pub const fn is_prepared(&self) -> bool {
        matches!(self.make, Make::Prepared(_))
    }

    /// The light it finds; `None` for pictures of something else.
    pub const fn finds(&self) -> Option<&Finds> {
        match &self.shows {
            Shows::Light(finds) => Some(finds),
            Shows::Geometry { .. } => None,
        }
    }

    /// Why its answer may not be the truth, whatever the scatter of its samples says; `None` where it is.
    pub const fn leaves_out(&self) -> Option<&'static str> {
        match self.finds() {
            Some(finds) if !finds.lamps.because.is_empty() => Some(finds.lamps.because),
            _ => self.biased,
        }
    }
}

impl PartialEq for Entry {
    fn eq(&self, other: &Entry) -> bool {
        self.name == other.name
    }
}

impl Eq for Entry {}
