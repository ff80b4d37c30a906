//! Patches that are too small for where they stand.

use super::error::RadiosityError;
use super::patches::Patch;

/// A patch is told apart from its neighbours where its side is so many times the rounding of its points. The
/// outermost of two Gauss points lies a fifth of the side away from a wall that the patch touches, and must be
/// in front of it.
const TOLD_APART: f64 = 8.0;
/// The share of all area that may lie in smaller patches, such as slivers.
const MAY_BE: f64 = 0.01;

/// Refuses patches where rounding changes more than a hundredth of their area: they stand far from the camera, which
/// is the origin of all coordinates.
pub(super) fn refuse_coarse(patches: &[Patch]) -> Result<(), RadiosityError> {
    let [mut coarse, mut all] = [0.0; 2];
    let mut worst: Option<&Patch> = None;
    for patch in patches {
        all += patch.area;
        if patch.area.sqrt() < TOLD_APART * patch.close {
            coarse += patch.area;
            if worst.is_none_or(|worst| patch.close > worst.close) {
                worst = Some(patch);
            }
        }
    }
    match worst {
        Some(patch) if coarse > MAY_BE * all => Err(RadiosityError::TooFar {
            side: patch.area.sqrt(),
            close: patch.close,
        }),
        _ => Ok(()),
    }
}
