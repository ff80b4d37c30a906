//! Work that takes a while, and who watches it.

/// Who watches while a scene is solved.
pub trait Watch: Sync {
    /// `done` of `total` parts of the work are finished.
    fn tell(&self, done: u64, total: u64);
    /// True to give up soon.
    fn stop(&self) -> bool;
}

/// Nobody watches and nobody stops.
impl Watch for () {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        false
    }
}
