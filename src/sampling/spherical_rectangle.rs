//! Directions to a rectangle, uniformly in solid angle.

/// A rectangle seen from the origin: `x` and `y` range over intervals in the plane at distance `z`.
#[derive(Clone, Copy, Debug)]
pub struct SphericalRectangle {
    x: [f64; 2],
    y: [f64; 2],
    z: f64,
    /// Solid angle of the strip of the rectangle's height from `x = 0` to each end, with its sign.
    strips: [f64; 2],
}

impl SphericalRectangle {
    /// The rectangle of two intervals, low end first, in the plane at the distance `z > 0`.
    pub fn new(x: [f64; 2], y: [f64; 2], z: f64) -> Self {
        // The signed solid angle of the rectangle between the foot of the plane and its far corner.
        let corner = |x: f64, y: f64| libm::atan2(x * y, z * (x * x + y * y + z * z).sqrt());
        SphericalRectangle {
            x,
            y,
            z,
            strips: x.map(|x| corner(x, y[1]) - corner(x, y[0])),
        }
    }

    /// Its solid angle in sr.
    ///
    /// Four angles are added that may cancel: the error is some 1e-15 sr, whatever the sum.
    pub fn solid_angle(&self) -> f64 {
        self.strips[1] - self.strips[0]
    }

    /// Draws a point of the rectangle.
    ///
    /// * Domain: `u` in `[0, 1)²` → `(x, y)` within the two intervals.
    /// * Density: the reciprocal of [`SphericalRectangle::solid_angle`], per steradian
    ///   ([`SphericalRectangle::pdf`]).
    /// * Method: `x` inverts the solid angle of a strip; in the circle of directions that share it
    ///   the sine of the elevation is uniform. Written with the angles of strips instead of those at
    ///   the corners, so that nothing cancels with 2π.
    /// * Source: Ureña, Fajardo, King, An Area-Preserving Parametrization for Spherical Rectangles
    ///   (EGSR 2013).
    pub fn sample(&self, u: [f32; 2]) -> [f64; 2] {
        let [u, v] = u.map(f64::from);
        let strip = self.strips[0] + u * self.solid_angle();
        let x = self.end_of_strip(strip).clamp(self.x[0], self.x[1]);
        let d = length(x, self.z);
        let [low, high] = self.y.map(|y| y / length(d, y));
        let sin = low + v * (high - low);
        let y = sin * d / ((1.0 - sin) * (1.0 + sin)).sqrt();
        [x, y.clamp(self.y[0], self.y[1])]
    }

    /// Density of [`SphericalRectangle::sample`] inside the rectangle, per steradian.
    pub fn pdf(&self) -> f64 {
        1.0 / self.solid_angle()
    }

    /// The `x` up to which a strip from `x = 0` has so large a solid angle, with its sign.
    fn end_of_strip(&self, angle: f64) -> f64 {
        // Mirrored so that the lower edge is the farther one: the difference of squares below
        // loses as many digits as that edge is nearer than x.
        let [y0, y1] = match self.y {
            [low, high] if low.abs() >= high.abs() => [low, high],
            [low, high] => [-high, -low],
        };
        let (l0, l1) = (length(y0, self.z), length(y1, self.z));
        let (c0, c1) = (y0 / l0, y1 / l1);
        let (sin, half) = (libm::sin(angle), libm::sin(0.5 * angle));
        // c1 - c0 cos φ over sin φ.
        let f = ((c1 - c0) + 2.0 * c0 * half * half) / sin;
        let square = f * f - (self.z / l0) * (self.z / l0);
        // An empty strip ends where it begins; beyond the horizon there is no end.
        if sin == 0.0 {
            0.0
        } else if square > 0.0 {
            self.z / square.sqrt() * angle.signum()
        } else {
            f64::INFINITY * angle.signum()
        }
    }
}

/// The length of the vector of two coordinates of at most 1e150.
fn length(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}
