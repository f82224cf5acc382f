//! The methods that a plan chooses from, and what they cost.

use super::{FilmDescription, Kind, Sensitivity};
use crate::error::Error;
use crate::optics::Medium;

/// A method, in a size.
#[derive(Clone, Copy, Debug)]
pub(super) enum Candidate {
    /// Three numbers, for a base without coating.
    Schlick,
    /// Exact, for a dielectric base without coating.
    Fresnel,
    /// Splines over cosine and thickness.
    Table,
    /// A method for one layer.
    OneLayer(Kind),
    /// [`Series`](super::series::Series) at every call.
    Series,
    /// [`Reference`](crate::optics::Reference) at every call.
    Reference,
}

/// The names that a method is forced by ([`FilmDescription::method`]) and reported with
/// ([`Plan::method`](super::Plan::method)).
pub const METHODS: [&str; 10] = [
    "schlick",
    "fresnel",
    "table",
    "two_beam",
    "airy_rgb",
    "quadrature",
    "harmonics",
    "bands",
    "series",
    "reference",
];

/// Sizes that are tried.
const WAVELENGTHS: [usize; 5] = [4, 8, 16, 32, 64];
const BANDS: [usize; 6] = [8, 16, 32, 64, 128, 256];
const ORDERS: [usize; 8] = [1, 2, 3, 4, 6, 8, 12, 16];

impl Candidate {
    pub(super) fn name(self) -> &'static str {
        METHODS[match self {
            Self::Schlick => 0,
            Self::Fresnel => 1,
            Self::Table => 2,
            Self::OneLayer(Kind::TwoBeam) => 3,
            Self::OneLayer(Kind::AiryRgb) => 4,
            Self::OneLayer(Kind::Quadrature(_)) => 5,
            Self::OneLayer(Kind::Harmonics(..)) => 6,
            Self::OneLayer(Kind::Bands(_)) => 7,
            Self::Series => 8,
            Self::Reference => 9,
        }]
    }

    /// What a call costs, ns: about the medians of `./x chart` on one core of a 2024 server
    /// (docs/chart.csv). They only have to put the methods in order, and being constants they do so
    /// everywhere.
    fn cost_ns(self) -> f64 {
        match self {
            Self::Schlick => 6.0,
            Self::Fresnel => 9.0,
            Self::Table => 13.0,
            Self::OneLayer(Kind::TwoBeam) => 41.0,
            Self::OneLayer(Kind::AiryRgb) => 49.0,
            Self::OneLayer(Kind::Quadrature(count)) => 40.0 + 13.0 * count as f64,
            Self::OneLayer(Kind::Harmonics(_, order)) => 55.0 + 28.0 * order as f64,
            Self::OneLayer(Kind::Bands(count)) => 200.0 + 16.0 * count as f64,
            Self::Series => 1e4,
            Self::Reference => 1e5,
        }
    }

    /// Whether a plan may choose it unasked. The errors of fixed wavelengths and of truncated series
    /// jump about, as what they take for something else does; those of bands do not.
    fn is_steady(self) -> bool {
        !matches!(
            self,
            Self::OneLayer(
                Kind::Quadrature(_) | Kind::Harmonics(..) | Kind::TwoBeam | Kind::AiryRgb
            )
        )
    }

    /// Those that suit a film, or only those of a name, the cheapest first.
    pub(super) fn by_cost(description: &FilmDescription, forced: Option<&str>) -> Vec<Self> {
        let mut candidates = vec![Self::Table, Self::Series, Self::Reference];
        if !description.transmittance {
            if is_bare(description) {
                candidates.push(Self::Schlick);
                if is_plain(description) {
                    candidates.push(Self::Fresnel);
                }
            }
            if description.layers.len() == 1 {
                let one_layer = [Kind::TwoBeam, Kind::AiryRgb]
                    .into_iter()
                    .chain(WAVELENGTHS.map(Kind::Quadrature))
                    .chain(BANDS.map(Kind::Bands))
                    .chain(ORDERS.map(|order| Kind::Harmonics(Sensitivity::Tabulated, order)));
                candidates.extend(one_layer.map(Self::OneLayer));
            }
        }
        candidates.retain(|candidate| {
            forced.map_or(candidate.is_steady(), |name| candidate.name() == name)
        });
        candidates.sort_by(|a, b| a.cost_ns().total_cmp(&b.cost_ns()));
        candidates
    }

    /// That a name exists, and that the method takes such a film.
    pub(super) fn check(name: &str, description: &FilmDescription) -> Result<(), Error> {
        if !METHODS.contains(&name) {
            return Err(Error::unknown("method", name, METHODS.into_iter()));
        }
        if !Self::by_cost(description, Some(name)).is_empty() {
            return Ok(());
        }
        let takes = match name {
            "schlick" => "a base without coating, and no transmittance",
            "fresnel" => "a dielectric base of one index without coating, and no transmittance",
            _ => "one layer, and no transmittance",
        };
        Err(Error::unsupported(format!("method '{name}' takes {takes}")))
    }
}

/// Whether no layer differs from the half-space beside it.
fn is_bare(description: &FilmDescription) -> bool {
    let same = |a: &Medium, b: &Medium| a.constant().is_some() && a.constant() == b.constant();
    let layers = description.layers.iter();
    let mut layers = layers
        .filter(|layer| layer.thickness_nm[1] > 0.0)
        .peekable();
    while layers
        .peek()
        .is_some_and(|layer| same(&layer.medium, &description.ambient))
    {
        layers.next();
    }
    layers.all(|layer| same(&layer.medium, &description.base))
}

/// Whether both half-spaces are transparent, of one index each.
fn is_plain(description: &FilmDescription) -> bool {
    [&description.ambient, &description.base]
        .into_iter()
        .all(|medium| medium.constant().is_some_and(|index| index.im == 0.0))
}
