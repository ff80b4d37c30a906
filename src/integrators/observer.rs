//! What becomes of the light that a path finds: all of it counts, or that of some paths only.

use super::{Arrival, Caustics, Integrator, Pass, Passes, Path, Prepared};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::materials::Event;
use crate::notation::{Expression, Language, Letter, State};
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};

/// Goes along with a path from the eye, hears of each of its vertices and of all light it finds.
pub trait PathObserver {
    /// The path goes on from a surface that scattered like this. False where no light from beyond
    /// counts: the path ends.
    fn scattered(&mut self, event: Event) -> bool;

    /// False where light from a lamp to the surface the path has come to, which scatters it like
    /// `last`, would not count: no shadow ray is sent.
    fn wants(&self, last: Event) -> bool;

    /// Light found by aiming at a lamp from the surface the path has come to.
    fn aimed(&mut self, last: Event, li: Rgb);

    /// Light at the end of the path itself.
    ///
    /// * `beyond`: true where it comes from around the scene, and no surface emits it.
    fn arrived(&mut self, li: Rgb, beyond: bool);
}

/// All light, whichever way it came.
#[derive(Clone, Copy, Debug, Default)]
pub struct AllLight {
    /// Its sum.
    pub li: Rgb,
}

impl PathObserver for AllLight {
    fn scattered(&mut self, _: Event) -> bool {
        true
    }

    fn wants(&self, _: Event) -> bool {
        true
    }

    fn aimed(&mut self, _: Event, li: Rgb) {
        self.li += li;
    }

    fn arrived(&mut self, li: Rgb, _: bool) {
        self.li += li;
    }
}

// ANCHOR: among
/// The light of the paths whose words are in a language.
#[derive(Clone, Copy, Debug)]
pub struct PathFilter<'a> {
    /// How far the word has been read, from the eye.
    state: State<'a>,
    /// The sum.
    pub li: Rgb,
}

impl<'a> PathFilter<'a> {
    /// At the eye.
    ///
    /// * `paths`: words from the eye to the light (see
    ///   [`Expression::eye_first`](crate::notation::Expression::eye_first)).
    pub fn new(paths: &'a Language) -> Self {
        PathFilter {
            state: paths.start().next(Letter::Eye),
            li: Rgb::BLACK,
        }
    }
}

impl PathObserver for PathFilter<'_> {
    fn scattered(&mut self, event: Event) -> bool {
        self.state = self.state.next(event.into());
        self.state.can_still_accept()
    }

    fn wants(&self, last: Event) -> bool {
        let end = self.state.next(last.into()).next(Letter::Light);
        end.is_accepting()
    }

    fn aimed(&mut self, _: Event, li: Rgb) {
        self.li += li;
    }

    fn arrived(&mut self, li: Rgb, _: bool) {
        if self.state.next(Letter::Light).is_accepting() {
            self.li += li;
        }
    }
}
// ANCHOR_END: among

// ANCHOR: from_eye
/// The light of a path from the eye but for what [`Caustics`] traces from the lights.
#[derive(Debug)]
pub struct FromEye<'f, F> {
    follow: &'f mut F,
    /// True where light from around the scene is traced from there, too.
    with_beyond: bool,
    /// The first surface and the last.
    ends: Option<[Event; 2]>,
}

impl<'f, F: PathObserver> FromEye<'f, F> {
    /// At the eye; all other light is told to `follow`.
    pub fn new(scene: &Scene, follow: &'f mut F) -> Self {
        FromEye {
            follow,
            with_beyond: scene.environment_light.is_some(),
            ends: None,
        }
    }
}

impl<F: PathObserver> PathObserver for FromEye<'_, F> {
    fn scattered(&mut self, event: Event) -> bool {
        let first = self.ends.map_or(event, |[first, _]| first);
        self.ends = Some([first, event]);
        self.follow.scattered(event)
    }

    fn wants(&self, last: Event) -> bool {
        self.follow.wants(last)
    }

    fn aimed(&mut self, last: Event, li: Rgb) {
        self.follow.aimed(last, li);
    }

    fn arrived(&mut self, li: Rgb, beyond: bool) {
        let is_focused = self.ends == Some([Event::Diffuse, Event::Specular]);
        if !is_focused || beyond && !self.with_beyond {
            self.follow.arrived(li, beyond);
        }
    }
}
// ANCHOR_END: from_eye

/// Path tracing, of the paths of a language alone.
///
/// What is left is the light of [`Path`] that came by these paths, sample by sample: pictures of
/// languages that have no word in common add up to the picture of both.
#[derive(Clone, Copy, Debug)]
pub struct FilteredPath<'a> {
    /// How paths are traced.
    pub path: Path,
    /// Words from the eye to the light.
    pub paths: &'a Language,
}

impl FilteredPath<'_> {
    /// True where some of its paths are traced from the lights.
    fn traces_caustics(&self, scene: &Scene) -> bool {
        let traced = Expression::parse(Caustics::PATHS);
        self.path.traces_caustics(scene)
            && traced.is_ok_and(|traced| !self.paths.intersection(traced.eye_first()).is_empty())
    }
}

impl Integrator for FilteredPath<'_> {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut only = PathFilter::new(self.paths);
        self.path.trace(tracer, ray, stream, &mut only);
        only.li
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.traces_caustics(scene).then_some(self)
    }
}

impl Passes for FilteredPath<'_> {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        self.path.caustics(pass, |letters| {
            let eye = self.paths.start().next(Letter::Eye);
            let state = letters
                .iter()
                .rev()
                .fold(eye, |state, letter| state.next(*letter));
            match state.is_accepting() {
                true => Arrival::Counts,
                false => Arrival::LeftOut,
            }
        })
    }

    fn light_paths(&self, scene: &Scene) -> Option<u32> {
        self.path.free_light_paths(scene)
    }

    fn with_light_paths(&self, light_paths: u32) -> Option<Box<dyn Integrator + '_>> {
        Some(Box::new(FilteredPath {
            path: self.path.with(light_paths),
            ..*self
        }))
    }
}
