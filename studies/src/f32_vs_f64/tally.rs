//! Errors of many numbers: the greatest, where it was, and how they are distributed.

/// Values and densities far below this count as 0: at this value, light of radiance 1 from the whole hemisphere
/// reflects 6e-3. A relative error of 1e-4 is then less than 1e-4 of the reflectance plus 1e-6, for a lobe of any
/// shape.
pub const FLOOR: f64 = 1e-3;

/// |found - truth| / ([`FLOOR`] + |truth|), with the greatest error of a channel and the truth of the brightest one,
/// beside which an error is seen. Infinite if a channel is not finite.
pub fn relative<const N: usize>(found: [f32; N], truth: [f64; N]) -> f64 {
    relative_in_double(found.map(f64::from), truth)
}

/// The same for numbers in double precision.
pub fn relative_in_double<const N: usize>(found: [f64; N], truth: [f64; N]) -> f64 {
    if !found.into_iter().all(f64::is_finite) {
        return f64::INFINITY;
    }
    let brightest = truth
        .into_iter()
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    let errors = found.into_iter().zip(truth).map(|(f, t)| (f - t).abs());
    errors.fold(0.0, f64::max) / (FLOOR + brightest)
}

/// Bins per factor of two, and the exponents that they cover.
const PER_OCTAVE: f64 = 8.0;
const LEAST_EXPONENT: f64 = -40.0;
const BINS: usize = 512;

/// An error, and where it was found.
#[derive(Clone, Debug)]
pub struct Worst {
    pub error: f64,
    pub place: String,
}

/// The errors of one kind of number.
#[derive(Clone, Debug)]
pub struct Tally {
    pub count: u64,
    bins: Vec<u64>,
    pub worst: Option<Worst>,
}

impl Default for Tally {
    fn default() -> Self {
        Self {
            count: 0,
            bins: vec![0; BINS],
            worst: None,
        }
    }
}

impl Tally {
    /// Adds an error. `place` is called only if it is the worst so far.
    pub fn add(&mut self, error: f64, place: impl FnOnce() -> String) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.count += 1;
        let bin = (error.log2() - LEAST_EXPONENT) * PER_OCTAVE;
        self.bins[(bin.max(0.0) as usize).min(BINS - 1)] += 1;
        if self.worst.as_ref().is_none_or(|worst| error > worst.error) {
            let place = place();
            self.worst = Some(Worst { error, place });
        }
    }

    /// Adds the errors of another tally. The result does not depend on the order: of places that are equally bad it
    /// keeps the first by name.
    pub fn merge(&mut self, other: Self) {
        self.count += other.count;
        for (bin, more) in self.bins.iter_mut().zip(other.bins) {
            *bin += more;
        }
        let key = |worst: &Option<Worst>| worst.as_ref().map(|w| (w.error, w.place.clone()));
        let is_worse = match (key(&other.worst), key(&self.worst)) {
            (Some((a, here)), Some((b, there))) => a > b || a == b && here < there,
            (found, _) => found.is_some(),
        };
        if is_worse {
            self.worst = other.worst;
        }
    }

    pub fn greatest(&self) -> f64 {
        self.worst.as_ref().map_or(0.0, |worst| worst.error)
    }

    /// The error that this part of all does not exceed, to a twelfth of its size.
    pub fn quantile(&self, part: f64) -> f64 {
        let wanted = (part * self.count as f64).ceil() as u64;
        let mut below = 0;
        for (bin, count) in self.bins.iter().enumerate() {
            below += count;
            if below >= wanted {
                let edge = ((bin + 1) as f64 / PER_OCTAVE + LEAST_EXPONENT).exp2();
                return edge.min(self.greatest());
            }
        }
        self.greatest()
    }
}
