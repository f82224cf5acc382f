//! A row of the table: the errors of one variant.

use super::bounds::{Between, Bounds};
use super::tally::Tally;

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// f |wi.z|.
    Value,
    /// The density of eval and sample.
    Pdf,
    /// Of a sample, times the true density at the direction that was found, against the value there.
    Weight,
    /// Of a sample: the distance between the ends of both instances' unit vectors.
    Direction,
    /// Values and densities where a direction is less than [`HORIZON`] above the horizon. They are a millionth of all
    /// directions, but formulas divide by their cosines.
    Horizon,
    /// Of a film: the difference of the clipped colours.
    Reflectance,
}

/// The cosine below which a direction is at the horizon.
pub const HORIZON: f32 = 1e-6;

impl Quantity {
    pub const ALL: [Self; 6] = [
        Self::Value,
        Self::Pdf,
        Self::Weight,
        Self::Direction,
        Self::Horizon,
        Self::Reflectance,
    ];

    pub fn name(self) -> &'static str {
        [
            "value",
            "pdf",
            "weight",
            "direction",
            "at the horizon",
            "reflectance",
        ][self as usize]
    }
}

#[derive(Clone, Debug)]
pub struct Row {
    pub name: String,
    pub bounds: Bounds,
    /// Elements that went through a batch of eval, sample or reflectance.
    pub evaluations: u64,
    tallies: [Tally; Quantity::ALL.len()],
    /// The number of errors of each quantity that are beyond the bound and not excused.
    beyond: [u64; Quantity::ALL.len()],
    /// Errors of any quantity that are beyond the bound because the inputs have too few digits.
    pub excused: Tally,
    /// The number of samples, and of those whose lobe differs from that in f64, or that exist in one precision only.
    pub samples: u64,
    pub switched: u64,
    /// Where one of these was found.
    pub switched_place: Option<String>,
    /// The number of elements for which two levels, or a level and the single call, have different bits.
    pub differing: u64,
    /// The sizes of these differences.
    pub between: Tally,
}

impl Row {
    pub fn new(name: &str, bounds: Bounds) -> Self {
        Self {
            name: name.to_owned(),
            bounds,
            evaluations: 0,
            tallies: std::array::from_fn(|_| Tally::default()),
            beyond: [0; Quantity::ALL.len()],
            excused: Tally::default(),
            samples: 0,
            switched: 0,
            switched_place: None,
            differing: 0,
            between: Tally::default(),
        }
    }

    pub fn tally(&self, quantity: Quantity) -> &Tally {
        &self.tallies[quantity as usize]
    }

    pub fn add(&mut self, quantity: Quantity, error: f64, place: impl FnOnce() -> String) {
        let is_within = error <= self.bounds.of(quantity);
        self.beyond[quantity as usize] += u64::from(!is_within);
        self.tallies[quantity as usize].add(error, place);
    }

    /// Adds an error. Beyond the bound it is excused if the last digits of the inputs explain as much.
    pub fn add_or_excuse(
        &mut self,
        quantity: Quantity,
        error: f64,
        spread: impl FnOnce() -> f64,
        place: impl FnOnce() -> String,
    ) {
        let bound = self.bounds.of(quantity);
        if error > bound && error <= bound + spread() {
            self.excused.add(error, place);
        } else {
            self.add(quantity, error, place);
        }
    }

    pub fn add_difference(&mut self, difference: f64, place: impl FnOnce() -> String) {
        self.differing += 1;
        self.between.add(difference, place);
    }

    pub fn add_switched(&mut self, place: impl FnOnce() -> String) {
        self.switched += 1;
        self.switched_place.get_or_insert_with(place);
    }

    pub fn merge(&mut self, other: Self) {
        self.evaluations += other.evaluations;
        self.samples += other.samples;
        self.switched += other.switched;
        let places = [self.switched_place.take(), other.switched_place];
        self.switched_place = places.into_iter().flatten().min();
        self.differing += other.differing;
        self.excused.merge(other.excused);
        self.between.merge(other.between);
        for (tally, more) in self.tallies.iter_mut().zip(other.tallies) {
            tally.merge(more);
        }
        for (count, more) in self.beyond.iter_mut().zip(other.beyond) {
            *count += more;
        }
    }

    /// Whether rounding chose the lobe of more samples than the bound allows, or chance explains among few.
    fn is_switched_too_often(&self) -> bool {
        const FEW: f64 = 5.0;
        self.switched as f64 > FEW + self.bounds.switched * self.samples as f64
    }

    /// The part of the samples whose lobe rounding chose.
    pub fn switched_share(&self) -> f64 {
        self.switched as f64 / self.samples.max(1) as f64
    }

    /// A sentence for each bound that is passed.
    pub fn failures(&self) -> Vec<String> {
        let mut failures = Vec::new();
        let mut fail = |what: String| failures.push(format!("{}: {what}", self.name));
        for quantity in Quantity::ALL {
            let (bound, tally) = (self.bounds.of(quantity), self.tally(quantity));
            let beyond = self.beyond[quantity as usize];
            let at_poles = (self.bounds.poles * tally.count as f64).ceil() as u64;
            if let Some(worst) = tally.worst.as_ref().filter(|_| beyond > at_poles) {
                let (name, error, place) = (quantity.name(), worst.error, &worst.place);
                fail(format!(
                    "{name} is off by more than {bound:e} at {beyond} elements, by {error:.2e} here: {place}"
                ));
            }
        }
        if self.is_switched_too_often() {
            fail(format!(
                "{} of {} samples have another lobe than in f64, or none, more than {:e} of all: {}",
                self.switched,
                self.samples,
                self.bounds.switched,
                self.switched_place.as_deref().unwrap_or_default()
            ));
        }
        let place = self.between.worst.as_ref().map_or("", |w| &w.place);
        match self.bounds.between {
            Between::SameBits if self.differing > 0 => fail(format!(
                "{} elements have other bits at another level: {place}",
                self.differing
            )),
            Between::Within(bound) if self.between.greatest() > bound => fail(format!(
                "levels differ by {:.2e}, more than {bound:e}: {place}",
                self.between.greatest()
            )),
            _ => {}
        }
        failures
    }
}
