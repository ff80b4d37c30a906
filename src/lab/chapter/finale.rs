//! The picture that ends a chapter: of a scene made for it, large, clean and well exposed.

use super::{Desk, DeskError, Number};
use crate::integrators::{Integrator, Path};
use crate::output::{Display, Provenance, png_bytes};
use crate::render::accuracy::{Accuracy, Measure};
use crate::render::stopping::fewest;
use crate::render::{Options, Rendered, render};
use crate::sampling::stream::Sampler;
use crate::scene::read::Source;
use crate::scene::{Scene, gallery};

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
    /// Stops by which the picture is brightened.
    pub stops: f64,
}

impl Desk {
    /// Renders a last picture of the chapter by the path tracer, of the text of a scene file; the rays it took.
    ///
    /// # Errors
    ///
    /// Those of the scene, of [`Desk::finale`], and of writing the picture.
    pub fn finale_of(
        &mut self,
        file: &'static str,
        text: &str,
        finale: &Finale,
    ) -> Result<u64, DeskError> {
        let scene = gallery::from_text(Source { file, text }, None, |_| {})?;
        let path = Path::new(scene.suggested.max_depth);
        Ok(self.finale(&scene, &path, finale)?.rays.total())
    }

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
            sampler: Sampler::Sobol,
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
            // Few samples that lie evenly only bound their error.
            let most = match options.spp < fewest(options.sampler) {
                true => "at most, ",
                false => "",
            };
            let error = Number::new(
                &format!("error of {}, {most}by its own account", finale.file),
                (100.0 * error).round() / 100.0,
            );
            self.number(&format!("error_of_{name}"), error.unit("%"));
        }
        let depth = scene.suggested.max_depth;
        let spp = u64::from(options.spp);
        let facts = Provenance {
            sampler: Sampler::Sobol,
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
