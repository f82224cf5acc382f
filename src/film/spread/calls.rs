//! Colours of a film averaged over a spread of thickness.

use super::average::Fringes;
use crate::error::Error;
use crate::film::Film;
use crate::film::colors::{Colors, has_nan};
use crate::film::evaluator::Evaluator;
use crate::film::film::one_by_one;
use crate::film::table::levels::Spread;
use crate::num::{Lane, Rgb};
use crate::optics::stack::Side;

impl Film {
    /// The greatest standard deviation of the thickness that calls may give, nm; greater ones are clamped to it. 0 if
    /// calls may give none.
    pub fn thickness_spread_max_nm(&self) -> f32 {
        self.description().thickness_spread_max_nm as f32
    }

    /// Refuses a standard deviation of the thickness, nm, that averages are not made for. 0 is always accepted.
    ///
    /// # Errors
    /// `OutOfRange` if it is negative, NaN or infinite; `InvalidArgument` if it is positive but no layer varies, or the
    /// description allows no spread.
    #[inline(always)]
    pub fn check_spread(&self, deviation_nm: f32) -> Result<(), Error> {
        if deviation_nm == 0.0 {
            return Ok(());
        }
        self.check_positive_spread(deviation_nm)
    }

    #[inline(never)]
    fn check_positive_spread(&self, deviation_nm: f32) -> Result<(), Error> {
        if !(deviation_nm > 0.0 && deviation_nm < f32::INFINITY) {
            return Err(Error::out_of_range(format!(
                "thickness_spread_nm = {deviation_nm} is not finite and at least 0"
            )));
        }
        if self.thickness_spread_max_nm() > 0.0 {
            return Ok(());
        }
        let why = if self.varying_thickness_nm().is_some() {
            "set thickness_spread_max_nm in the film's description"
        } else {
            "no layer of the film varies in thickness"
        };
        Err(Error::invalid(format!(
            "thickness_spread_nm = {deviation_nm} must be 0 here: {why}"
        )))
    }

    /// [`Film::reflectance`], averaged over thicknesses normally distributed with this standard deviation, nm. The
    /// distribution is cut to the range of the thickness and renormalised. 0 gives the bits of
    /// [`Film::reflectance`].
    ///
    /// # Errors
    /// As for [`Film::check_spread`].
    pub fn reflectance_spread(
        &self,
        cos_theta: f32,
        thickness_nm: f32,
        deviation_nm: f32,
    ) -> Result<Rgb<f32>, Error> {
        self.check_spread(deviation_nm)?;
        Ok(self.spread_or_plain(cos_theta, thickness_nm, deviation_nm))
    }

    /// [`Film::colors`], averaged like [`Film::reflectance_spread`].
    ///
    /// # Errors
    /// As for [`Film::check_spread`] and [`Film::colors`].
    pub fn colors_spread(
        &self,
        side: Side,
        cos_theta: f32,
        thickness_nm: f32,
        deviation_nm: f32,
    ) -> Result<Colors, Error> {
        self.check_spread(deviation_nm)?;
        if deviation_nm == 0.0
            || !self.description().transmittance
            || side == Side::Base && self.is_base_opaque()
        {
            return self.colors(side, cos_theta, thickness_nm);
        }
        let inputs = [cos_theta, thickness_nm];
        if has_nan(inputs) {
            return Ok(Colors::default());
        }
        let [cos_theta, thickness_nm] = self.clamp_inputs(inputs);
        let colors = self.averaged(side, cos_theta, self.spread(thickness_nm, deviation_nm));
        let clipped = |rgb: Rgb<f32>| f32::channels(self.clip::<f32>(f32::rgb(rgb)));
        Ok(Colors {
            reflectance: clipped(colors.reflectance),
            transmittance: clipped(colors.transmittance),
        })
    }

    /// [`Film::reflectance_spread`] for a deviation that is checked. Never inlined, so that batches and single calls
    /// share its bits.
    #[inline(never)]
    pub(crate) fn spread_or_plain(
        &self,
        cos_theta: f32,
        thickness_nm: f32,
        deviation_nm: f32,
    ) -> Rgb<f32> {
        let inputs = [cos_theta, thickness_nm];
        if deviation_nm == 0.0 || has_nan(inputs) {
            return self.reflectance(cos_theta, thickness_nm);
        }
        let [cos_theta, thickness_nm] = self.clamp_inputs(inputs);
        let spread = self.spread(thickness_nm, deviation_nm);
        let rgb = match &self.evaluator {
            Evaluator::Tables(tables) => tables.reflectance(cos_theta, spread),
            _ => self.averaged(Side::Ambient, cos_theta, spread).reflectance,
        };
        f32::channels(self.clip::<f32>(f32::rgb(rgb)))
    }

    /// [`Film::spread_or_plain`] in each lane, one after another.
    #[inline(always)]
    pub(crate) fn spread_lanes<L: Lane<Scalar = f32>>(
        &self,
        cos_theta: L,
        thickness_nm: L,
        deviation_nm: L,
    ) -> Rgb<L> {
        const MOST: usize = 16;
        let mut deviations = [0.0; MOST];
        deviation_nm.store(&mut deviations[..L::COUNT]);
        let lane = std::cell::Cell::new(0);
        one_by_one([cos_theta, thickness_nm], |c, d| {
            let deviation = deviations[lane.get()];
            lane.set(lane.get() + 1);
            self.spread_or_plain(c, d, deviation)
        })
    }

    fn spread(&self, thickness_nm: f32, deviation_nm: f32) -> Spread {
        Spread {
            thickness_nm,
            deviation_nm: deviation_nm.min(self.thickness_spread_max_nm()),
        }
    }

    /// The unclipped average for inputs in their ranges, by any evaluator.
    fn averaged(&self, side: Side, cos_theta: f32, spread: Spread) -> Colors {
        let c = f64::from(cos_theta);
        match &self.evaluator {
            Evaluator::Tables(tables) => tables.colors(side, cos_theta, spread),
            Evaluator::Method(method) => {
                let found = self.by_nodes(spread, |d| {
                    let reflectance = method.compiled.reflectance(cos_theta, d as f32);
                    Colors {
                        reflectance: reflectance.map(f64::from),
                        transmittance: [0.0; 3],
                    }
                });
                found.to_f32()
            }
            Evaluator::Series(series) => {
                let at_angle = series.at_angle(side, c);
                self.by_nodes(spread, |d| at_angle.at(d)).to_f32()
            }
            Evaluator::Reference => {
                let found = self.by_nodes(spread, |d| self.converged(side, c, d));
                found.to_f32()
            }
        }
    }

    /// The average by many nodes.
    fn by_nodes(&self, spread: Spread, mut colors: impl FnMut(f64) -> Colors<f64>) -> Colors<f64> {
        let fringes = Fringes::new(self.description());
        let (d, deviation) = (
            f64::from(spread.thickness_nm),
            f64::from(spread.deviation_nm),
        );
        fringes.average(d, deviation, &mut colors)
    }
}
