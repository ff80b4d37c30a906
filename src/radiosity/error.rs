//! Why a scene's light cannot be put onto patches.

/// Why a scene's light cannot be put onto patches, as one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RadiosityError {
    /// Nothing reflects diffusely.
    #[error(
        "nothing in the scene is diffuse, so there is no light that patches could hold; use another \
         integrator"
    )]
    NothingDiffuse,
    /// A round shape reflects diffusely.
    #[error("{}", of_spheres(*.0))]
    Spheres(usize),
    /// Something moves.
    #[error(
        "something moves while the shutter is open, and patches stand still; use another integrator"
    )]
    Motion,
    /// Shapes that are stored once for several objects.
    #[error(
        "{0} objects share a mesh or are of a shape of one's own, and patches need flat shapes of \
         their own: give each object its own file, or use another integrator"
    )]
    Shared(usize),
    /// A polygon that is no patch.
    #[error("a patch needs three corners or more, finite and not on one line")]
    Degenerate,
    /// A patch size that is no length.
    #[error("a patch cannot be {0} long: give a length above 0 in scene units")]
    Size(f64),
    /// Fewer patches than the scene has sides.
    #[error(
        "{asked} patches are too few: the scene has {least} sides, and each needs one at least"
    )]
    TooFew {
        /// The number asked for.
        asked: usize,
        /// The smallest number possible.
        least: usize,
    },
    /// The matrix would be too large.
    #[error(
        "{patches} patches have {} of form factors, and {} ({} patches) are allowed: take fewer or \
         larger patches",
        gigabytes(*patches), gigabytes(MOST_PATCHES), MOST_PATCHES
    )]
    TooMany {
        /// How many there would be, or more.
        patches: usize,
    },
    /// Patches that rounding moves by a good part of their own size.
    #[error(
        "patches of about {side:.1e} stand where rounding moves points by up to {close:.1e}: move the \
         camera nearer to them, or take larger patches"
    )]
    TooFar {
        /// The root of the area of one, in scene units.
        side: f64,
        /// How far rounding moves its points, in scene units.
        close: f64,
    },
    /// Walls that absorb nothing.
    #[error(
        "the light does not settle: walls that reflect all light enclose a lamp, and it grows without \
         end; give them an albedo below 1"
    )]
    Unsettled,
    /// Whoever watches asked for it.
    #[error("stopped before the patches were lit")]
    Stopped,
}

/// The most patches: their matrix takes a gigabyte.
pub const MOST_PATCHES: usize = 16_384;

/// Bytes of the matrix of so many patches.
pub fn bytes(patches: usize) -> u128 {
    4 * (patches as u128) * (patches as u128)
}

fn of_spheres(count: usize) -> String {
    let are = if count == 1 {
        "is a sphere"
    } else {
        "are spheres"
    };
    format!(
        "{count} of the diffuse shapes {are}, and patches are flat: use meshes in their place, or another \
         integrator"
    )
}

fn gigabytes(patches: usize) -> String {
    let bytes = bytes(patches) as f64;
    match bytes {
        b if b < 1e9 => format!("{:.0} MB", b / 1e6),
        b if b < 1e10 => format!("{:.1} GB", b / 1e9),
        b => format!("{:.0} GB", b / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_memory_is_said() {
        let said = RadiosityError::TooMany { patches: 100_000 }.to_string();
        assert!(said.starts_with("100000 patches have 40 GB"), "{said}");
        assert!(said.contains("1.1 GB (16384 patches)"), "{said}");
    }
}
