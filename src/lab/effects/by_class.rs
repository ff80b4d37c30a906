//! The light of a picture by the classes of its paths: all from one render.

use super::language::Class;
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::integrators::{Arrival, Pass, Passes, Path, PathObserver, Prepared, Splat};
use crate::materials::Event;
use crate::notation::{Expression, Letter, State};
use crate::render::{Options, Progress, Recorded, Recorder, record};
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use arrayvec::ArrayVec;

/// A render of a scene by `path`, whose further pictures are those of some classes. Where the classes are
/// all that the scene has, they add up to the picture.
pub fn by_class(
    scene: &Scene,
    path: Path,
    classes: &[Class],
    options: &Options,
    progress: &dyn Progress,
) -> Recorded<()> {
    let expressions = classes.iter().map(|class| class.expression()).collect();
    record(scene, &ByClass { path, expressions }, options, progress)
}

struct ByClass {
    path: Path,
    expressions: ArrayVec<Expression, { Class::ALL.len() }>,
}

impl Recorder for ByClass {
    type Notes = ();

    fn pictures(&self) -> usize {
        self.expressions.len()
    }

    fn record(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        stream: &Stream,
        parts: &mut [Rgb],
        _: &mut (),
    ) -> Rgb {
        parts.fill(Rgb::BLACK);
        let paths = self.expressions.iter().map(Expression::eye_first);
        let mut sorter = Sorter {
            states: paths.map(|p| p.start().next(Letter::Eye)).collect(),
            parts,
            li: Rgb::BLACK,
        };
        self.path.trace(tracer, ray, stream, &mut sorter);
        sorter.li
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.path.traces_caustics(scene).then_some(self)
    }

    fn arrive(&self, _: Rgb, splats: impl Iterator<Item = Splat>, parts: &mut [Rgb], _: &mut ()) {
        // Added up as in the whole picture, so that each is the picture of its class alone.
        let mut sums = [[0.0_f64; 3]; Class::ALL.len()];
        for splat in splats {
            let its = sums.iter_mut().enumerate();
            let its = its.filter(|(class, _)| splat.path >> class & 1 == 1);
            for (sum, x) in its.flat_map(|(_, sum)| sum.iter_mut().zip(splat.light.channels())) {
                *sum += f64::from(x);
            }
        }
        for (part, sum) in parts.iter_mut().zip(sums) {
            *part += Rgb::from(sum.map(|x| x as f32));
        }
    }
}

impl Passes for ByClass {
    /// Keeps of each path a bit for each class that it is in.
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        self.path.caustics(pass, |letters| {
            let word = |expression: &Expression| {
                let start = expression.light_first().start();
                let light = letters
                    .iter()
                    .fold(start, |state, &letter| state.next(letter));
                u64::from(light.next(Letter::Eye).is_accepting())
            };
            let classes = self.expressions.iter().enumerate();
            Arrival::Kept(classes.map(|(i, e)| word(e) << i).sum())
        })
    }
}

/// Books light in the classes of its path.
struct Sorter<'a> {
    /// How far each class has read the path, from the eye.
    states: ArrayVec<State<'a>, { Class::ALL.len() }>,
    parts: &'a mut [Rgb],
    li: Rgb,
}

impl PathObserver for Sorter<'_> {
    fn scattered(&mut self, event: Event) -> bool {
        for state in &mut self.states {
            *state = state.next(event.into());
        }
        true
    }

    fn wants(&self, _: Event) -> bool {
        true
    }

    fn aimed(&mut self, last: Event, li: Rgb) {
        self.li += li;
        for (state, part) in self.states.iter().zip(&mut *self.parts) {
            if state.next(last.into()).next(Letter::Light).is_accepting() {
                *part += li;
            }
        }
    }

    fn arrived(&mut self, li: Rgb, _: bool) {
        self.li += li;
        for (state, part) in self.states.iter().zip(&mut *self.parts) {
            if state.next(Letter::Light).is_accepting() {
                *part += li;
            }
        }
    }
}
