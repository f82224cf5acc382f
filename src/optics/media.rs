//! The media that are known by name, with their published optical constants.
//!
//! Metals, oxides, silicon and water are Chebyshev series fitted to measurements, valid for 380-780 nm; a
//! comment at each states the greatest error of the fit. The others are the dispersion formulas of their
//! sources. docs/media.md compares the metals with other published data.

use super::Complex;
use crate::num::Real;

/// The wavelengths for which the formulas are valid, nm. Outside, the index is constant.
const RANGE_NM: [f64; 2] = [380.0, 780.0];

/// A medium that is known by name.
#[derive(Debug)]
pub struct NamedMedium {
    /// The chemical formula, or the usual name.
    pub name: &'static str,
    /// Other names for it.
    pub aliases: &'static [&'static str],
    /// The source of its data.
    pub source: &'static str,
    formula: Formula,
}

/// A dispersion formula. Wavelengths are in micrometres unless the name says nm.
#[derive(Debug)]
#[allow(clippy::large_enum_variant)] // of one static table
enum Formula {
    /// Fits in u = (lambda_nm - 580) / 200, for the index and for the extinction.
    Fitted { eta: Polynomial, k: Polynomial },
    /// eta = 1.
    Vacuum,
    /// eta = 1 + sum b / (c - 1 / lambda^2): a gas.
    Gas { terms: &'static [[f64; 2]] },
    /// eta^2 = 1 + sum b lambda^2 / (lambda^2 - c).
    Sellmeier { terms: &'static [[f64; 2]] },
    /// eta = sum c_j / lambda_nm^(2 j).
    CauchyNm { coefficients: [f64; 3] },
}

impl NamedMedium {
    const fn new(
        name: &'static str,
        aliases: &'static [&'static str],
        source: &'static str,
        formula: Formula,
    ) -> Self {
        Self {
            name,
            aliases,
            source,
            formula,
        }
    }

    /// A medium by its Chebyshev series; an empty one is 0.
    const fn fitted(
        name: &'static str,
        aliases: &'static [&'static str],
        source: &'static str,
        eta: &'static [f64],
        k: &'static [f64],
    ) -> Self {
        let (eta, k) = (Polynomial::of_chebyshev(eta), Polynomial::of_chebyshev(k));
        Self::new(name, aliases, source, Formula::Fitted { eta, k })
    }

    /// The medium of that name or alias; upper and lower case are alike.
    pub fn find(name: &str) -> Option<&'static Self> {
        MEDIA.iter().find(|medium| {
            let mut names = std::iter::once(&medium.name).chain(medium.aliases);
            names.any(|known| known.eq_ignore_ascii_case(name))
        })
    }

    /// Every medium, in the order of the table.
    pub const fn all() -> &'static [Self] {
        &MEDIA
    }

    /// Whether it absorbs at some wavelength in 380-780 nm.
    pub fn absorbs(&self) -> bool {
        matches!(self.formula, Formula::Fitted { k, .. } if k.terms > 0)
    }

    /// The range of wavelengths of its data, nm; that of vacuum is from 0 to infinity. Outside, the index is constant.
    pub fn range_nm(&self) -> [f64; 2] {
        match self.formula {
            Formula::Vacuum => [0.0, f64::INFINITY],
            _ => RANGE_NM,
        }
    }

    /// The index, if it is the same at every wavelength.
    pub fn constant(&self) -> Option<Complex<f64>> {
        matches!(self.formula, Formula::Vacuum).then_some(Complex::real(1.0))
    }

    /// The complex index at a vacuum wavelength, nm, or at one in each lane; constant outside 380-780 nm.
    #[inline(always)]
    pub fn index<T: Real>(&self, wavelength_nm: T) -> Complex<T> {
        let [least, greatest] = RANGE_NM;
        let nm = wavelength_nm.max(T::new(least)).min(T::new(greatest));
        let one = T::new(1.0);
        let um_squared = (nm * T::new(1e-3)).squared();
        let eta = match self.formula {
            Formula::Fitted { ref eta, ref k } => {
                let u = (nm - T::new(580.0)) * T::new(1.0 / 200.0);
                // The fit of k may be below 0 where the source has 0.
                return Complex::new(eta.at(u), k.at(u).max(T::new(0.0)));
            }
            Formula::Vacuum => one,
            Formula::Gas { terms } => {
                let inverse = one / um_squared;
                one + sum(
                    terms,
                    #[inline(always)]
                    |b, c| [b, c - inverse],
                )
            }
            Formula::Sellmeier { terms } => {
                let sum = sum(
                    terms,
                    #[inline(always)]
                    |b, c| [b * um_squared, um_squared - c],
                );
                (one + sum).sqrt()
            }
            Formula::CauchyNm { coefficients } => {
                let [a, b, c] = coefficients;
                let square = nm.squared();
                T::new(a) + (T::new(b) + T::new(c) / square) / square
            }
        };
        Complex::real(eta)
    }
}

/// The sum of a formula's terms, each a numerator and a denominator: as one fraction, since a division takes as long
/// as four products.
#[inline(always)]
fn sum<T: Real>(terms: &[[f64; 2]], term: impl Fn(T, T) -> [T; 2]) -> T {
    let (mut sum, mut divisor) = (T::new(0.0), T::new(1.0));
    for [b, c] in terms {
        let [numerator, denominator] = term(T::new(*b), T::new(*c));
        sum = sum * denominator + numerator * divisor;
        divisor = divisor * denominator;
    }
    sum / divisor
}

/// The greatest number of terms of a fit, even.
const MOST_TERMS: usize = 14;

/// sum a_j u^j for u within [-1, 1].
#[derive(Clone, Copy, Debug)]
struct Polynomial {
    coefficients: [f64; MOST_TERMS],
    terms: usize,
}

impl Polynomial {
    /// sum c_j T_j(u) in powers of u, by T_(j+1) = 2 u T_j - T_(j-1). It takes half the time of Clenshaw's
    /// recurrence, and loses three of sixteen digits.
    const fn of_chebyshev(series: &[f64]) -> Self {
        let mut coefficients = [0.0; MOST_TERMS];
        let (mut current, mut next) = ([0.0; MOST_TERMS], [0.0; MOST_TERMS]);
        current[0] = 1.0;
        next[1] = 1.0;
        let mut j = 0;
        while j < series.len() {
            let mut after = [0.0; MOST_TERMS];
            let mut power = 0;
            while power < MOST_TERMS {
                coefficients[power] += series[j] * current[power];
                let shifted = if power > 0 { next[power - 1] } else { 0.0 };
                after[power] = 2.0 * shifted - current[power];
                power += 1;
            }
            (current, next) = (next, after);
            j += 1;
        }
        Self {
            coefficients,
            terms: series.len(),
        }
    }

    /// Even and odd powers are summed side by side. All coefficients take part, also those that are 0: a loop of a
    /// length that the compiler does not know mixes lanes, and takes longer.
    #[inline(always)]
    fn at<T: Real>(&self, u: T) -> T {
        if self.terms == 0 {
            return T::new(0.0);
        }
        let square = u.squared();
        let (mut even, mut odd) = (T::new(0.0), T::new(0.0));
        for pair in (0..MOST_TERMS / 2).rev() {
            even = even * square + T::new(self.coefficients[2 * pair]);
            odd = odd * square + T::new(self.coefficients[2 * pair + 1]);
        }
        even + odd * u
    }
}

#[rustfmt::skip] // one series per line
static MEDIA: [NamedMedium; 31] = [
    NamedMedium::new("vacuum", &[], "by definition",
        Formula::Vacuum),
    NamedMedium::new("air", &[], "Ciddor 1996, eq. 1: dry, 15 C, 101325 Pa, 450 ppm CO2",
        Formula::Gas { terms: &[[0.05792105, 238.0185], [0.00167917, 57.362]] }),
    // Greatest error of the fit: 0.00544 (eta), 0.00877 (k).
    NamedMedium::fitted("Ag", &["silver"], "Johnson and Christy 1972",
        &[0.04480748, -0.00804158, -0.007688154, -0.002961201, 0.004618073, 0.001237058, -7.925399e-05, 0.0005952705, -0.00177756],
        &[3.746779, 1.754423, -0.1026199, 0.03125805, -0.009216683, 0.005793273, -0.007239824, 0.0013961, 0.0006750838]),
    // Greatest error of the fit: 0.0456 (eta), 0.0357 (k).
    NamedMedium::fitted("Au", &["gold"], "Johnson and Christy 1972",
        &[0.6656274, -0.7732196, 0.2299025, 0.1164108, -0.1242299, 0.02372207, 0.04250628, -0.03842943, 0.002031921, 0.02651436, -0.01320987, -0.006961663, 0.01841895],
        &[3.064514, 1.545331, 0.2936866, -0.2047149, 0.0003979773, 0.08697263, -0.04666656, -0.01213841, 0.0286293, -0.009972484, -0.01043148, 0.01654051, -0.006845173]),
    // Greatest error of the fit: 0.0357 (eta), 0.0278 (k).
    NamedMedium::fitted("Cu", &["copper"], "Johnson and Christy 1972",
        &[0.7431535, -0.6611251, 0.04692236, 0.1815876, 0.004012228, -0.09115298, 0.001731252, 0.04956156, -0.004986043, -0.0181757, -0.002610939, 0.01684922, 0.006983063],
        &[3.251297, 1.425466, 0.2769371, -0.01795775, -0.1282715, 0.008367487, 0.06812048, -0.01256685, -0.037972, 0.004007342, 0.0213176, -0.006299551, -0.01590911]),
    // Greatest error of the fit: 0.00496 (eta), 0.0089 (k).
    NamedMedium::fitted("Al", &["aluminium", "aluminum"], "Rakic 1995",
        &[1.350651, 1.090169, 0.2001123, 0.03064957, 0.002829857, -0.002110486, -0.0004339885, -0.001802501, -0.003834592],
        &[6.781266, 2.032816, -0.2154777, -0.07630372, -0.02871388, -0.006807793, -0.0001615045, -0.001675433, 0.001473319]),
    // Greatest error of the fit: 0.037 (eta), 0.00652 (k).
    NamedMedium::fitted("Cr", &["chromium", "chrome"], "Johnson and Christy 1974",
        &[2.752751, 0.576521, -0.3224293, 0.04963729, 0.1110782, -0.03476728, -0.02969545, 0.02182133, 0.007229789],
        &[3.221573, 0.2875841, -0.1259594, 0.08560957, -0.02257762, -0.02089637, 0.01702016, 0.004707269, -0.002960909]),
    // Greatest error of the fit: 0.0197 (eta), 0.00906 (k).
    NamedMedium::fitted("Ni", &["nickel"], "Johnson and Christy 1974",
        &[1.924813, 0.2345449, 0.003896532, -0.006336424, 0.02792121, -0.01134361, -0.005662555, -0.0001107191, 0.005150037],
        &[3.721538, 1.195681, -0.07639774, -0.01579359, -0.001956653, -0.001478047, 0.002265607, 0.0006340654, 0.001883591]),
    // Greatest error of the fit: 0.017 (eta), 0.00612 (k).
    NamedMedium::fitted("Ti", &["titanium"], "Johnson and Christy 1974",
        &[2.564625, 0.5126597, -0.02468647, 0.02835593, 0.000377963, 0.009018291, -0.005965703, 0.002889985, 0.005703246],
        &[3.508361, 0.6102358, -0.0433339, -0.07676042, 0.008933705, 0.006618012, -0.008448641, 0.002932391, 0.003807837]),
    // Greatest error of the fit: 0.0373 (eta), 0.0131 (k).
    NamedMedium::fitted("Fe", &["iron"], "Johnson and Christy 1974",
        &[2.701785, 0.3210887, -0.2126353, 0.07925398, 0.01484357, -0.002174751, -0.003926302, 0.01305884, 0.004183602],
        &[2.962422, 0.3758214, -0.04086767, 0.03490787, -0.01622174, -0.001144994, 0.001079975, -0.002949007, -0.001332938]),
    // Greatest error of the fit: 5.83e-05 (eta), 6.21e-05 (k).
    NamedMedium::fitted("Pt", &["platinum"], "Rakic 1998 (Brendel-Bormann)",
        &[2.206824, 0.5570253, 0.03490633, 0.0002284814, -0.005446339, 0.001074746, 0.0001167599, -0.0001171246, 3.199579e-05],
        &[3.844235, 1.084058, -0.04082769, -0.01109622, 0.0003257421, 0.001622997, -0.0005517376, 0.0001003113, -8.463376e-06]),
    // Greatest error of the fit: 0.000282 (eta), 0.000199 (k).
    NamedMedium::fitted("W", &["tungsten"], "Rakic 1998 (Brendel-Bormann)",
        &[3.473198, 0.2120232, -0.08603744, -0.03998443, 0.00334432, 0.005123972, -0.00172312, -5.480266e-05, 0.0002146446],
        &[2.70628, 0.142012, -0.05702831, 0.002071502, 0.01792626, -0.00344989, -0.0009885215, 0.0006848259, -5.871982e-05]),
    // Greatest error of the fit: 0.0454 (eta), 0.0833 (k).
    NamedMedium::fitted("Si", &["silicon"], "Aspnes and Studna 1983",
        &[4.407766, -1.0438, 0.5183414, -0.2583032, 0.1379362, -0.07341855, 0.04138698, -0.02098955, 0.01243336],
        &[0.1555326, -0.2534126, 0.1800497, -0.1181883, 0.08108508, -0.05275485, 0.03827946, -0.02259333, 0.01671708]),
    // Greatest error of the fit: 0.0151.
    NamedMedium::fitted("TiO2", &["titania", "rutile"], "Devore 1951 (rutile ordinary ray; extrapolated below 430 nm)",
        &[2.706727, -0.2517091, 0.09786458, -0.03395233, 0.01252121],
        &[]),
    // Greatest error of the fit: 7.7e-05.
    NamedMedium::fitted("SiO2", &["silica", "fused silica"], "Malitson 1965",
        &[1.460773, -0.008805167, 0.00216192, -0.000539636, 0.0001279755],
        &[]),
    // Greatest error of the fit: 3.81e-05.
    NamedMedium::fitted("MgF2", &["magnesium fluoride"], "Dodge 1984 (ordinary)",
        &[1.378961, -0.004621244, 0.001136922, -0.0002789647, 6.505329e-05],
        &[]),
    // Greatest error of the fit: 0.000121.
    NamedMedium::fitted("Al2O3", &["alumina", "sapphire"], "Malitson and Dodge 1972 (ordinary)",
        &[1.771823, -0.01383877, 0.003419671, -0.000850144, 0.0002012746],
        &[]),
    // Greatest error of the fit: 0.000426.
    NamedMedium::fitted("H2O", &["water"], "Hale and Querry 1973",
        &[1.333843, -0.005093882, 0.001194522, -0.0001469069, -5.388921e-05],
        &[]),
    // Greatest error of the fit: 0.0384 (eta), 0.0492 (k).
    NamedMedium::fitted("Fe2O3", &["hematite"], "Querry 1985 (ordinary)",
        &[3.001525, 0.03221953, -0.2793706, 0.1395952, -0.006641254, 0.003689269, -0.009340087, -0.01174988, 0.02941596],
        &[0.5117094, -0.6971802, 0.1934004, 0.06671685, -0.05247597, 0.01330017, -0.01872775, 0.03234064, 0.00301233]),
    // Greatest error of the fit: 0.00828 (eta), 0.00804 (k).
    NamedMedium::fitted("Fe3O4", &["magnetite"], "Querry 1985",
        &[2.369531, -0.06692886, 0.01724263, -0.02620072, -0.008112429, 0.008901204, -0.003161011, 0.004502562, -0.004502758],
        &[0.09851449, 0.03589261, -0.008340161, -0.02381151, 0.02149971, -0.003360614, 0.001007578, -0.002752486, -0.002670504]),
    NamedMedium::new("BK7", &["N-BK7", "glass", "crown glass"], "Schott 2014, optical glass data sheet N-BK7",
        Formula::Sellmeier { terms: &[[1.03961212, 0.00600069867], [0.231792344, 0.0200179144], [1.01046945, 103.560653]] }),
    NamedMedium::new("PMMA", &["acrylic", "plexiglass"], "Sultanova, Kasarova and Nikolov 2009, 20 C (one Sellmeier term fitted by Polyanskiy; extrapolated below 437 nm)",
        Formula::Sellmeier { terms: &[[1.1819, 0.011313]] }),
    NamedMedium::new("oil", &["immersion oil"], "Cargille Laboratories, data sheet of Immersion Oil Type B, 23 C (within ISO 8036)",
        Formula::CauchyNm { coefficients: [1.498304, 5.456721e3, 1.203987e8] }),
    // Greatest error of the fit: 7.29e-05. The source's k is 0 here.
    NamedMedium::fitted("a-TiO2", &["amorphous TiO2", "amorphous titania"], "Jolivet 2023 (amorphous film by atomic layer deposition, 200 C)",
        &[2.483931, -0.1529955, 0.05895452, -0.02227594, 0.008577043, -0.003407847, 0.001396208, -0.0005932205, 0.0002550851, -0.0001143085, 4.760429e-05, -2.263543e-05],
        &[]),
    // Greatest error of the fit: 9.18e-06 (eta), 7e-06 (k).
    NamedMedium::fitted("Ta2O5", &["tantalum pentoxide", "tantala"], "Gao, Lemarchand and Lequime 2012 (evaporated film, ion-assisted)",
        &[2.168603, -0.07132742, 0.02193388, -0.006218427, 0.001705242, -0.0004618735, 0.0001243321, -3.149241e-05, 8.575464e-06],
        &[0.0001025146, -0.0001729909, 0.0001022729, -3.845379e-05, 7.766114e-06]),
    // Greatest error of the fit: 0.000126 (eta), 3.02e-05 (k).
    NamedMedium::fitted("Nb2O5", &["niobium pentoxide", "niobia"], "Lemarchand 2013 (sputtered film; method of Gao, Lemarchand and Lequime 2012)",
        &[2.387987, -0.1403504, 0.04919133, -0.01677852, 0.005855595, -0.002129293, 0.0008147612, -0.0003233645, 0.0001356033, -5.36476e-05, 2.388797e-05],
        &[0.0004026562, -0.0007646892, 0.000661236, -0.0005203821, 0.0003798521, -0.0002556217, 0.0001630283, -9.549209e-05, 5.48027e-05, -2.639213e-05, 1.383686e-05]),
    NamedMedium::new("Si3N4", &["silicon nitride"], "Luke 2015 (stoichiometric film by chemical vapour deposition)",
        Formula::Sellmeier { terms: &[[3.0249, 0.1353406 * 0.1353406], [40314.0, 1239.842 * 1239.842]] }),
    // Greatest error of the fit: 2.87e-05 (eta), 3.6e-05 (k).
    NamedMedium::fitted("ZnS", &["zinc sulfide"], "Amotchkina 2020 (evaporated film; extrapolated below 400 nm)",
        &[2.417175, -0.1356281, 0.05320378, -0.02104363, 0.008640393, -0.003673246, 0.001601551, -0.0007075935, 0.0003162098, -0.0001401153, 6.313648e-05, -2.590326e-05, 1.17111e-05],
        &[0.0008353062, -0.0009081424, 0.0002518509, -2.196806e-05, -2.776983e-05, 2.836954e-05, -2.405448e-05, 1.485708e-05, -1.055309e-05]),
    // Greatest error of the fit: 7.12e-05 (eta), 1.5e-05 (k).
    NamedMedium::fitted("ITO", &["indium tin oxide"], "König 2014 (72 nm film on glass, 15-25 ohm per square)",
        &[1.838435, -0.2143319, 0.005883582, -0.007485897, 0.001996266, -0.0006308424, 0.0001818391, -5.827569e-05],
        &[0.005968719, -0.00318817, 0.003320968, -0.001242321, 0.0005103469, -0.0001789759, 5.597808e-05, -1.686151e-05]),
    NamedMedium::new("polystyrene", &["PS"], "Sultanova, Kasarova and Nikolov 2009, 20 C (one Sellmeier term fitted by Polyanskiy; extrapolated below 437 nm)",
        Formula::Sellmeier { terms: &[[1.4435, 0.020216]] }),
    NamedMedium::new("SF11", &["dense flint"], "Schott 2017, catalogue, SF11 (extrapolated below 390 nm; its k, at most 6e-6, is left out)",
        Formula::Sellmeier { terms: &[[1.73848403, 0.0136068604], [0.311168974, 0.0615960463], [1.17490871, 121.922711]] }),
];
