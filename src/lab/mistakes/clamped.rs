//! Bright samples cut off: less noise, and an answer that no number of samples makes right.

use crate::color::Rgb;
use crate::geometry::Ray;
use crate::integrators::Integrator;
use crate::sampling::stream::Stream;
use crate::scene::Tracer;

/// An integrator whose samples are clamped, the usual remedy for fireflies.
///
/// What lies above the limit is lost in each sample, so the mean of any number of them lacks it: where
/// a sample is `x` with probability `p` and else 0, it reads `p limit` in place of `p x`.
#[derive(Clone, Copy, Debug)]
pub struct Clamped<I> {
    /// Whose samples.
    pub inner: I,
    /// The largest value of a channel.
    pub limit: f32,
}

impl<I: Integrator> Integrator for Clamped<I> {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let li = self.inner.li(tracer, ray, stream);
        // A NaN stays one, to be noticed.
        let cut = |x: f32| if x > self.limit { self.limit } else { x };
        let [r, g, b] = li.channels().map(cut);
        Rgb::new(r, g, b)
    }
}
