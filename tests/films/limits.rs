//! The limits of the film methods: no film, no contrast, no transmission, no coherence, no light.

use pellicle::film::{CompiledMethod, MAX_THICKNESS_NM, OneLayer, OneLayerMethod};
use pellicle::num::Rgb;
use pellicle::optics::stack::{Layer, Side, Stack};
use pellicle::optics::{ColorSpace, Complex, Medium, RGB_WAVELENGTHS_NM, Reference, White};

const COSINES: [f64; 9] = [0.0, 1e-6, 1e-3, 0.03, 0.2, 0.5, 0.7, 0.95, 1.0];
const THICKNESSES: [f64; 9] = [0.0, 1e-6, 0.1, 6.0, 100.0, 450.0, 1e3, 1e4, 1e6];

type Index = (f64, f64);

fn medium((eta, k): Index) -> Medium {
    Medium::rgb([eta; 3], [k; 3]).unwrap()
}

fn layer(ambient: f64, film: Index, base: Index) -> OneLayer {
    let media = [(ambient, 0.0), film, base].map(medium);
    let [ambient, film, base] = media;
    OneLayer::new(ambient, film, base, White::E, ColorSpace::Rec709).unwrap()
}

fn truth(ambient: f64, film: &[Index], base: Index, cos_theta: f64, d: f64) -> Rgb<f64> {
    let films: Vec<_> = film.iter().map(|index| medium(*index)).collect();
    let thickness = vec![d; films.len()];
    let (white, space) = (White::E, ColorSpace::Rec709);
    let reference = Reference::new(medium((ambient, 0.0)), films, medium(base), white, space);
    reference
        .unwrap()
        .evaluate(Side::Ambient, cos_theta, &thickness)
        .reflectance
}

fn is_near(a: Rgb<f64>, b: Rgb<f64>, tolerance: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}

fn method(kind: OneLayerMethod, layer: &OneLayer) -> Box<dyn CompiledMethod<f64>> {
    kind.double(layer).unwrap()
}

/// Methods that add up all beams.
fn has_all_beams(kind: OneLayerMethod) -> bool {
    !matches!(
        kind,
        OneLayerMethod::TwoBeam | OneLayerMethod::Harmonics(..)
    )
}

const STACKS: [(f64, Index, Index); 14] = [
    (1.0, (1.33, 0.0), (1.0, 0.0)),
    (1.0, (1.5, 0.0), (1.33, 0.0)),
    (1.0, (2.4, 0.0), (2.9, 3.1)),
    (1.0, (1.5, 0.0), (1.5, 3.0)),
    (1.0, (1.5, 0.2), (1.2, 0.0)),
    (1.0, (1.5, 1e-9), (1.5, 3.0)),
    (1.0, (0.2, 3.0), (1.5, 0.0)),
    (1.0, (1e-3, 1e3), (1e3, 1e3)),
    (1.5, (1.0, 0.0), (1.5, 0.0)),
    (1.5, (1.33, 0.0), (1.0, 0.0)),
    (1.5, (2.0, 0.0), (1.0, 0.0)),
    (2.0, (0.5, 0.01), (0.3, 0.0)),
    (1.0, (1.0, 0.0), (1.5, 0.0)),
    (1.5, (1.5, 0.0), (1.5, 0.0)),
];

#[test]
fn everything_is_finite_for_every_argument() {
    let hostile = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        -1.0,
        1e-40,
        1e300,
        2.0,
    ];
    let cosines = || COSINES.into_iter().chain(hostile);
    let thicknesses = || THICKNESSES.into_iter().chain(hostile);
    for (ambient, film, base) in STACKS {
        let layer = layer(ambient, film, base);
        for kind in OneLayerMethod::ALL {
            let exact = method(kind, &layer);
            let single: Box<dyn CompiledMethod<f32>> = kind.single(&layer).unwrap();
            for (c, d) in cosines().flat_map(|c| thicknesses().map(move |d| (c, d))) {
                let at = || format!("{kind:?} {ambient} {film:?} {base:?} {c} {d}");
                let found = exact.reflectance(c, d);
                let is_finite = found.iter().all(|r| r.is_finite());
                assert!(is_finite, "{} {found:?}", at());
                let found = single.reflectance(c as f32, d as f32);
                let is_near = found.iter().all(|r| (-4.0..4.0).contains(r));
                assert!(is_near, "{} single {found:?}", at());
            }
        }
    }
}

#[test]
fn arguments_are_held_in_their_ranges() {
    let layer = layer(1.0, (1.33, 0.0), (1.5, 0.0));
    for kind in OneLayerMethod::ALL {
        let method = method(kind, &layer);
        let same = |a: (f64, f64), b: (f64, f64)| {
            let [a, b] = [a, b].map(|(c, d)| method.reflectance(c, d));
            assert_eq!(a, b, "{kind:?}");
        };
        same((1.5, 300.0), (1.0, 300.0));
        same((-0.5, 300.0), (0.0, 300.0));
        same((f64::NAN, 300.0), (0.0, 300.0));
        same((0.5, -3.0), (0.5, 0.0));
        same((0.5, f64::NAN), (0.5, 0.0));
        same((0.5, f64::INFINITY), (0.5, MAX_THICKNESS_NM));
    }
}

#[test]
fn without_a_film_the_base_is_bare() {
    for (ambient, film, base) in STACKS {
        let layer = layer(ambient, film, base);
        for kind in OneLayerMethod::ALL
            .into_iter()
            .filter(|kind| has_all_beams(*kind))
        {
            let method = method(kind, &layer);
            for c in COSINES {
                let bare = truth(ambient, &[], base, c, 0.0);
                let found = method.reflectance(c, 0.0);
                let at = format!("{kind:?} {ambient} {film:?} {base:?} {c}");
                assert!(is_near(found, bare, 1e-9), "{at}: {found:?} {bare:?}");
            }
        }
    }
}

/// The series cut off after N terms misses the bare base by 2 |C(1)| |g|^N / (1 - |g|).
#[test]
fn harmonics_without_a_film_are_off_by_their_missing_terms() {
    let stack = layer(1.0, (1.5, 0.0), (1.33, 0.0));
    let (above, below) = (0.5f64 / 2.5, (0.17f64 / 2.83));
    let g = above * below;
    let first = above * (1.0 - above * above) * below;
    let bare = truth(1.0, &[], (1.33, 0.0), 1.0, 0.0);
    for order in 1..4 {
        let method = method(OneLayerMethod::Harmonics(order), &stack);
        let missing = 2.0 * first * g.powi(order as i32) / (1.0 - g);
        let found = method.reflectance(1.0, 0.0);
        for c in 0..3 {
            let off = (found[c] - bare[c]).abs();
            assert!(
                (off - missing).abs() < 0.01 * missing + 1e-9,
                "{order}: off by {off}, not {missing}"
            );
        }
    }
}

/// Three wavelengths, all beams: the multilayer reference at those wavelengths, which is another
/// implementation and agrees with Python's tmm.
#[test]
fn airy_rgb_is_the_stack_at_three_wavelengths() {
    for (ambient, film, base) in STACKS {
        let method = method(OneLayerMethod::AiryRgb, &layer(ambient, film, base));
        let index = |(eta, k): Index| Complex::new(eta, k);
        for (c, d) in [0.03, 0.2, 0.7, 1.0]
            .into_iter()
            .flat_map(|c| [0.1, 6.0, 450.0, 1e4].map(|d| (c, d)))
        {
            let layers = [Layer {
                index: index(film),
                thickness_nm: d,
            }];
            let stack = Stack {
                ambient,
                layers: &layers,
                base: index(base),
            };
            let expected = RGB_WAVELENGTHS_NM.map(|nm| {
                let response = stack.respond(Side::Ambient, c, nm);
                response.unpolarized_reflectance()
            });
            let found = method.reflectance(c, d);
            let at = format!("{ambient} {film:?} {base:?} {c} {d}");
            assert!(
                is_near(found, expected, 1e-9),
                "{at}: {found:?} {expected:?}"
            );
        }
    }
}

/// Two beams at normal incidence by hand: |r01 + (1 - r01^2) r12 exp(4 pi i n d / lambda)|^2.
#[test]
fn two_beam_is_the_sum_of_two_beams() {
    for (film, base) in [(1.33, 1.0), (1.5, 1.33), (2.4, 1.5)] {
        let method = method(
            OneLayerMethod::TwoBeam,
            &layer(1.0, (film, 0.0), (base, 0.0)),
        );
        let (above, below) = ((1.0 - film) / (1.0 + film), (film - base) / (film + base));
        let second = (1.0 - above * above) * below;
        for d in [0.0, 70.0, 300.0, 1000.0] {
            let expected = RGB_WAVELENGTHS_NM.map(|nm| {
                let phase: f64 = 4.0 * std::f64::consts::PI * film * d / nm;
                above * above + second * second + 2.0 * above * second * phase.cos()
            });
            let found = method.reflectance(1.0, d);
            assert!(
                is_near(found, expected, 1e-12),
                "{film} {d}: {found:?} {expected:?}"
            );
        }
    }
}

#[test]
fn a_film_like_its_neighbour_does_nothing() {
    for base in [(1.5, 0.0), (1.5, 3.0), (1.0, 0.0)] {
        for film in [(1.0, 0.0), base] {
            let layer = layer(1.0, film, base);
            for kind in OneLayerMethod::ALL {
                let method = method(kind, &layer);
                for (c, d) in COSINES
                    .into_iter()
                    .flat_map(|c| THICKNESSES.map(|d| (c, d)))
                {
                    let (found, bare) = (method.reflectance(c, d), truth(1.0, &[], base, c, 0.0));
                    let at = format!("{kind:?} {film:?} {base:?} {c} {d}");
                    assert!(is_near(found, bare, 1e-9), "{at}: {found:?} {bare:?}");
                }
            }
        }
    }
}

#[test]
fn total_reflection_is_total() {
    // 1.5 to 1.0 beyond 41.8 degrees: at the base, through a denser film, and, thick, at the film.
    for (film, thickness) in [(2.0, 100.0), (1.4, 1000.0), (1.0, 1e5)] {
        let layer = layer(1.5, (film, 0.0), (1.0, 0.0));
        for kind in OneLayerMethod::ALL
            .into_iter()
            .filter(|kind| has_all_beams(*kind))
        {
            let method = method(kind, &layer);
            for c in [0.05, 0.3, 0.6] {
                let found = method.reflectance(c, thickness);
                assert!(
                    is_near(found, [1.0; 3], 1e-9),
                    "{kind:?} {film} {c} {found:?}"
                );
            }
        }
    }
    // Frustrated: an air gap in glass, thin enough to let light through.
    let layer = layer(1.5, (1.0, 0.0), (1.5, 0.0));
    for kind in [
        OneLayerMethod::Quadrature(16),
        OneLayerMethod::Quadrature(64),
        OneLayerMethod::Bands(16),
        OneLayerMethod::Bands(64),
    ] {
        let method = method(kind, &layer);
        for (c, d) in [(0.6, 100.0), (0.5, 50.0), (0.2, 300.0), (0.74, 200.0)] {
            let (found, truth) = (
                method.reflectance(c, d),
                truth(1.5, &[(1.0, 0.0)], (1.5, 0.0), c, d),
            );
            assert!(
                is_near(found, truth, 2e-3),
                "{kind:?} {c} {d} {found:?} {truth:?}"
            );
        }
    }
}

/// Interfaces added up without phases: R = r1 + (1 - r1)^2 r2 / (1 - r1 r2), per polarisation.
fn incoherent(film: f64, (eta, k): Index, cos_theta: f64) -> f64 {
    let inside = (1.0 - (1.0 - cos_theta * cos_theta) / (film * film)).sqrt();
    let power = |near: f64, cos: f64, eta: f64, k: f64, pol: usize| {
        // Conductor (Born & Wolf 14.4): q = u + i v in the second medium, tangential to the first.
        let sine = near * (1.0 - cos * cos).sqrt();
        let (re, im) = (eta * eta - k * k - sine * sine, 2.0 * eta * k);
        let size = re.hypot(im);
        let (u, v) = (
            ((size + re) / 2.0).sqrt(),
            ((size - re).max(0.0) / 2.0).sqrt(),
        );
        let s = ((near * cos - u).powi(2) + v * v) / ((near * cos + u).powi(2) + v * v);
        if pol == 0 {
            return s;
        }
        let tangent = sine * (1.0 - cos * cos).sqrt() / cos;
        s * ((u - tangent).powi(2) + v * v) / ((u + tangent).powi(2) + v * v)
    };
    let both = [0, 1].map(|pol| {
        let above = power(1.0, cos_theta, film, 0.0, pol);
        let below = power(film, inside, eta, k, pol);
        above + (1.0 - above).powi(2) * below / (1.0 - above * below)
    });
    (both[0] + both[1]) / 2.0
}

#[test]
fn thick_films_become_incoherent_in_bands() {
    for (film, base) in [
        (1.33, (1.0, 0.0)),
        (1.5, (1.33, 0.0)),
        (1.5, (1.5, 3.0)),
        (2.4, (2.9, 3.1)),
    ] {
        let layer = layer(1.0, (film, 0.0), base);
        let method = method(OneLayerMethod::Bands(16), &layer);
        let single: Box<dyn CompiledMethod<f32>> =
            OneLayerMethod::Bands(16).single(&layer).unwrap();
        for c in [0.1, 0.5, 0.8, 1.0] {
            let limit = incoherent(film, base, c);
            let mut far = Vec::new();
            // The more fringes a band has, the less is left of them.
            for (thickness, tolerance) in [(3e3, 0.2), (3e4, 0.05), (1e5, 0.015), (1e6, 2e-3)] {
                let found = method.reflectance(c, thickness);
                assert!(
                    is_near(found, [limit; 3], tolerance),
                    "{film} {base:?} {c} {thickness}: {found:?} {limit}"
                );
                let found = single
                    .reflectance(c as f32, thickness as f32)
                    .map(f64::from);
                assert!(is_near(found, [limit; 3], tolerance));
                far.push(found);
            }
        }
    }
}

/// From 3 to 10 micrometres the reference still sees fringes; bands must be near it.
#[test]
fn thick_films_are_those_of_the_reference_in_bands() {
    for (film, base) in [(1.33, (1.0, 0.0)), (1.5, (1.5, 3.0)), (1.5, (1.33, 0.0))] {
        let method = method(OneLayerMethod::Bands(32), &layer(1.0, (film, 0.0), base));
        for c in [0.1, 0.4, 0.7, 1.0] {
            for d in [3000.0, 4100.0, 6000.0, 1e4, 1e5] {
                let truth = truth(1.0, &[(film, 0.0)], base, c, d);
                let found = method.reflectance(c, d);
                assert!(
                    is_near(found, truth, 0.01),
                    "{film} {c} {d} {found:?} {truth:?}"
                );
            }
        }
    }
}

#[test]
fn vanishing_absorption_changes_nothing() {
    for (ambient, film, base) in STACKS.into_iter().filter(|(_, film, _)| film.1 == 0.0) {
        let lossless = layer(ambient, film, base);
        let lossy = layer(ambient, (film.0, 1e-10), base);
        for kind in OneLayerMethod::ALL {
            let methods = [&lossless, &lossy].map(|layer| method(kind, layer));
            for (c, d) in [0.03, 0.2, 0.5, 0.95, 1.0]
                .into_iter()
                .flat_map(|c| [0.0, 6.0, 100.0, 450.0, 1e3, 1e4].map(|d| (c, d)))
            {
                let [a, b] = methods.each_ref().map(|method| method.reflectance(c, d));
                let at = format!("{kind:?} {ambient} {film:?} {base:?} {c} {d}");
                assert!(is_near(a, b, 1e-5), "{at}: {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn sizes_out_of_range_are_refused() {
    let layer = layer(1.0, (1.5, 0.0), (1.5, 0.0));
    for (kind, size) in [
        (OneLayerMethod::Quadrature(0), "wavelengths = 0"),
        (OneLayerMethod::Quadrature(65), "wavelengths = 65"),
        (OneLayerMethod::Bands(257), "bands = 257"),
        (OneLayerMethod::Harmonics(0), "order = 0"),
    ] {
        let error = kind.single(&layer).err().unwrap().to_string();
        assert!(error.contains(size), "{error}");
    }
}
