//! The picture that ends a chapter: of a scene made for it, large, clean and well exposed.

use super::{Desk, DeskError, Number};
use crate::integrators::Integrator;
use crate::output::{Display, Provenance, png_bytes};
use crate::render::accuracy::{Accuracy, Measure};
use crate::render::{Options, Rendered, render};
use crate::sampling::stream::Sampler;
use crate::scene::Scene;

/// How many times smaller the picture of a quick run is, along each side.
const SMALLER: u32 = 8;

/// What a chapter ends with.
#[derive(Clone, Copy, Debug)]
pub struct Finale<'a> {
    /// The name of its PNG file.
    pub file: &'a str,
    /// What is seen, and where to look.
    pub title: &'a str,
    /// Samples per pixel; with `--fine` sixteen times as many.
    pub spp: u32,
    /// How the samples of a pixel lie to each other.
    pub sampler: Sampler,
    /// Stops by which the picture is brightened.
    pub stops: f64,
}

impl Desk {
    /// Renders a last picture of the chapter in the scene's own size; twice as wide with `--fine`. Its error, by its
    /// own account, is the number `error_of_` with the name of the file.
    pub fn finale(
        &mut self,
        scene: &Scene,
        by: &dyn Integrator,
        finale: &Finale,
    ) -> Result<Rendered, DeskError> {
        let [width, height] = scene.size;
        let size = match (self.options.quick, self.options.fine) {
            (true, _) => [width / SMALLER, height / SMALLER],
            (_, true) => [2 * width, 2 * height],
            _ => scene.size,
        };
        let scene = scene.clone().sized(size);
        let options = Options {
            spp: self.spp(finale.spp, finale.spp.div_ceil(2)),
            seed: self.options.seed,
            sampler: finale.sampler,
            ..Options::default()
        };
        let rendered = render(&scene, by, &options, &self.bar(finale.file));
        if rendered.interrupted {
            return Err(DeskError::Interrupted);
        }
        let error = 100.0 * Accuracy::of(&rendered.film).error(Measure::RootMeanSquare);
        // Where no noise was seen, no error is known.
        if error.is_finite() {
            let name = finale.file.trim_end_matches(".png");
            let error = Number::new(
                &format!("error of {}, by its own account", finale.file),
                (100.0 * error).round() / 100.0,
            );
            self.number(&format!("error_of_{name}"), error.unit("%"));
        }
        let depth = scene.suggested.max_depth;
        let spp = u64::from(options.spp);
        let facts = Provenance {
            sampler: finale.sampler,
            ..Provenance::new(&scene, &self.record.chapter, depth, spp, options.seed)
        };
        let exposed = Display::Exposed {
            stops: finale.stops,
        };
        if self.options.exr {
            let path = self.folder.join(finale.file).with_extension("exr");
            crate::output::write(&path, &rendered.film, Display::Radiance, &facts)?;
        }
        let png = png_bytes(&rendered.film, exposed, &facts)?;
        self.figure(finale.file, finale.title, png)?;
        Ok(rendered)
    }
}
