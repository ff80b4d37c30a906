//! Further views of a scene that is rendered: the cameras of other scene files.

use super::{Stop, stem};
use crate::integrators::Integrator;
use crate::output;
use crate::scene::{Scene, gallery};
use clap::Args;
use std::path::{Path, PathBuf};

/// Further views.
#[derive(Clone, Debug, Args)]
pub(super) struct Views {
    /// Render the scene from the camera of this scene file, too, into OUT-FILE beside the picture; may be
    /// given several times. What is solved on patches is solved once
    #[arg(long = "camera", value_name = "FILE", conflicts_with_all = ["paths", "without"])]
    files: Vec<String>,
}

/// The scene from another camera, and where its picture goes.
pub(super) struct View {
    pub scene: Scene,
    pub path: PathBuf,
}

impl Views {
    /// The views that are asked for, checked before any work.
    ///
    /// * `out`: where the first picture goes.
    pub fn of(&self, scene: &Scene, out: &Path) -> Result<Vec<View>, Stop> {
        let mut views: Vec<View> = Vec::new();
        for file in &self.files {
            let path = beside(out, &stem(file));
            if views.iter().any(|view| view.path == path) {
                let what = format!(
                    "--camera {file}: another view goes to {}, too",
                    path.display()
                );
                return Err(Stop::Input(what));
            }
            let scene = scene.with_camera_of(&gallery::load(file)?)?;
            output::prepare(&path, &scene)?;
            views.push(View { scene, path });
        }
        Ok(views)
    }
}

impl View {
    /// The integrator of `scene` for this view of it; `None` where it is the same.
    pub fn integrator(&self, scene: &Scene, made: &impl Integrator) -> Option<Box<dyn Integrator>> {
        made.moved(self.scene.origin() - scene.origin())
    }
}

/// `name.png` becomes `name-view.png`.
fn beside(out: &Path, view: &str) -> PathBuf {
    let [name, ending] = [out.file_stem(), out.extension()].map(Option::unwrap_or_default);
    let [name, ending] = [name, ending].map(|part| part.to_string_lossy());
    out.with_file_name(format!("{name}-{view}.{ending}"))
}
