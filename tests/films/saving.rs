//! Compiled films as blocks of memory: the same bits from every call, every damage refused, and contents of any kind
//! behind a checksum that is right.

use crate::common::films::{Kind, bare, constant, medium, prism, soap, tinted, two_sided};
use crate::common::{hemisphere, rng, uniforms};
use crate::plan_cases::{ONE_LAYER, lens, with};
use pellicle::film::{Film, FilmDescription, resealed};
use pellicle::optics::stack::{Response, Side};
use pellicle::optics::{Amplitudes, ColorSpace, Medium, White};
use pellicle::{BaseOpacity, Bsdf, Call, Description, Error, Status};
use rand::{Rng, RngExt};
use std::sync::{Arc, OnceLock};

/// A film of each kind of evaluator, table and medium.
fn descriptions() -> Vec<(&'static str, FilmDescription)> {
    let glass = || bare(constant(1.5, 0.0));
    let measured = Medium::table(
        &[300.0, 500.0, 550.3, 550.5, 700.0],
        &[1.6, 1.55, 1.52, 1.52, 1.5],
        &[0.0, 0.0, 0.02, 0.0, 0.0],
    )
    .unwrap();
    let dispersing = Medium::rgb([1.5, 1.52, 1.55], [0.01, 0.0, 0.02]).unwrap();
    let mut all = vec![
        ("fresnel", glass()),
        ("schlick", with("schlick", 0.2, &bare(medium("Au")))),
        (
            "curve",
            bare(medium("Si")).layer(medium("SiO2"), [300.0; 2]),
        ),
        ("soap", soap()),
        ("lens, both sides", two_sided(lens())),
        ("prism", prism()),
        ("absorbing, both sides", two_sided(tinted())),
        ("measured", glass().layer(measured.clone(), [0.0, 400.0])),
        (
            "of every option",
            FilmDescription {
                ambient: medium("water"),
                white: White::D65,
                color_space: ColorSpace::AcesCg,
                unclipped: true,
                base_opacity: BaseOpacity::Opaque,
                extrapolate: true,
                tolerance: 5e-3,
                ..two_sided(bare(dispersing)).layer(medium("TiO2"), [20.0, 90.0])
            },
        ),
        (
            "dispersing, both sides",
            two_sided(bare(medium("BK7"))).layer(medium("MgF2"), [0.0, 300.0]),
        ),
        (
            "with a spread",
            FilmDescription {
                thickness_spread_max_nm: 60.0,
                ..bare(constant(1.5, 0.02)).layer(constant(1.38, 0.0), [80.0, 240.0])
            },
        ),
        ("within a prism", Kind::Prism.description()),
        ("sunglasses", Kind::Sunglasses.description()),
        (
            "thick on glass",
            two_sided(bare(medium("BK7"))).layer(medium("H2O"), [0.0, 1e4]),
        ),
        (
            "series",
            with(
                "series",
                1e-2,
                &two_sided(bare(medium("BK7"))).layer(medium("Ag"), [0.0, 60.0]),
            ),
        ),
        (
            "series with lines",
            with(
                "series",
                1e-2,
                &glass()
                    .layer(measured, [0.0, 400.0])
                    .layer(medium("TiO2"), [80.0; 2]),
            ),
        ),
        ("reference", with("reference", 1e-2, &two_sided(tinted()))),
    ];
    all.extend(ONE_LAYER.map(|name| (name, with(name, 0.3, &lens()))));
    // In double precision, because the layer reflects totally.
    all.extend(["airy_rgb", "bands"].map(|name| {
        let fixed = FilmDescription {
            ambient: constant(1.6, 0.0),
            ..glass().layer(constant(1.38, 0.0), [120.0; 2])
        };
        (name, with(name, 0.8, &fixed))
    }));
    all
}

struct Subject {
    name: &'static str,
    film: Arc<Film>,
    block: Vec<u8>,
}

fn subjects() -> &'static [Subject] {
    static SUBJECTS: OnceLock<Vec<Subject>> = OnceLock::new();
    SUBJECTS.get_or_init(|| {
        let made = |(name, description): (&'static str, FilmDescription)| {
            let film = Film::new(&description).unwrap_or_else(|error| panic!("{name}: {error}"));
            let block = film.to_bytes().unwrap();
            println!("{name}: {} bytes, {}", block.len(), film.plan().reason);
            let film = Arc::new(film);
            Subject { name, film, block }
        };
        descriptions().into_iter().map(made).collect()
    })
}

fn refusal(block: &[u8]) -> Error {
    Film::from_bytes(block)
        .err()
        .expect("this block is refused")
}

/// The inputs of calls: cosine and thickness, beyond their ranges too.
fn inputs(film: &Film, rng: &mut impl Rng) -> (f32, f32) {
    let [least, greatest] = film.varying_thickness_nm().unwrap_or([0.0, 100.0]);
    let (u, v) = (rng.random::<f32>(), rng.random_range(-0.1f32..1.1));
    let c = if rng.random() { u } else { u.powi(4) };
    (c, least as f32 + v * (greatest - least) as f32)
}

/// The bits of all that a film says of itself and of calls with random inputs.
fn bits(film: &Film, count: usize, slow: usize) -> Vec<u64> {
    let rng = &mut rng(18);
    let mut bits = Vec::new();
    let mut add = |numbers: &[f64]| bits.extend(numbers.iter().map(|x| x.to_bits()));
    add(&film.base_attenuation_per_mm());
    let is_slow = ["series", "reference"].contains(&film.plan().method);
    for _ in 0..if is_slow { slow } else { count } {
        let (c, d) = inputs(film, rng);
        add(&film.reflectance(c, d).map(f64::from));
        let spread = film.thickness_spread_max_nm() * rng.random::<f32>();
        add(&film
            .reflectance_spread(c, d, spread)
            .unwrap()
            .map(f64::from));
        for side in [Side::Ambient, Side::Base] {
            if let Ok(colors) = film.colors(side, c, d) {
                add(&colors.reflectance.map(f64::from));
                add(&colors.transmittance.map(f64::from));
            }
        }
    }
    for _ in 0..slow {
        let (c, d) = inputs(film, rng);
        let (c, d) = (f64::from(c), f64::from(d));
        add(&film.reference(c, d));
        let nm = [rng.random_range(400.0..700.0), 550.0];
        add(&[film.spectrum(c, d, nm[0]).unwrap()]);
        for side in [Side::Ambient, Side::Base] {
            let mut amplitudes = [Amplitudes::default(); 2];
            film.amplitudes(side, c, d, &nm, &mut amplitudes).unwrap();
            for value in amplitudes {
                let all = value.reflection.into_iter().chain(value.transmission);
                all.for_each(|field| add(&[field.re, field.im]));
            }
            let nothing = Response {
                reflectance: [0.0; 2],
                transmittance: [0.0; 2],
            };
            let mut responses = [nothing; 2];
            film.responses(side, c, d, &nm, &mut responses).unwrap();
            for value in responses {
                add(&value.reflectance);
                add(&value.transmittance);
            }
        }
    }
    bits
}

/// The bits of a BSDF made with a film.
fn bsdf_bits(film: Arc<Film>) -> Vec<u32> {
    let rng = &mut rng(19);
    let varying = film.varying_thickness_nm();
    let mut description = Description::new("film").film(film);
    if let Some([min, max]) = varying {
        description = description.vary("thickness_nm", min as f32, max as f32);
    }
    let bsdf: Bsdf = Bsdf::new(&description).unwrap();
    let mut bits = Vec::new();
    for _ in 0..20 {
        let values = varying.map(|[min, max]| [(min + rng.random::<f64>() * (max - min)) as f32]);
        let wo = hemisphere(rng).as_vec3();
        let values = values.as_ref().map(|values| &values[..]);
        let sample = bsdf.sample(wo, uniforms(rng).into(), values, &Call::default());
        let numbers = sample.weight.into_iter().chain(sample.wi.to_array());
        bits.extend(numbers.chain([sample.pdf]).map(f32::to_bits));
    }
    bits
}

#[test]
fn a_loaded_film_gives_the_bits_of_the_saved_one() {
    for Subject { name, film, block } in subjects() {
        let loaded = Film::from_bytes(block).unwrap_or_else(|error| panic!("{name}: {error}"));
        for (part, of) in [
            (
                "description",
                (|film| format!("{:?}", film.description())) as fn(&Film) -> String,
            ),
            ("plan", |film| format!("{:?}", film.plan())),
        ] {
            assert_eq!(of(film), of(&loaded), "{name}: {part}");
        }
        assert!(bits(film, 2000, 20) == bits(&loaded, 2000, 20), "{name}");
        assert!(*block == loaded.to_bytes().unwrap(), "{name}: saved again");
    }
}

#[test]
fn so_does_a_bsdf_made_with_it() {
    for Subject { name, film, block } in subjects() {
        if ["series", "reference"].contains(&film.plan().method) {
            continue;
        }
        let loaded = Arc::new(Film::from_bytes(block).unwrap());
        assert!(bsdf_bits(Arc::clone(film)) == bsdf_bits(loaded), "{name}");
    }
}

/// The films above have all kinds of evaluators and of tables.
#[test]
fn every_method_is_saved() {
    let found: Vec<_> = subjects().iter().map(|s| s.film.plan().method).collect();
    for method in pellicle::METHODS {
        assert!(found.contains(&method), "{method}");
    }
    let reasons: Vec<_> = subjects().iter().map(|s| &s.film.plan().reason).collect();
    for kind in [
        "values in patches",
        "values over the cosine",
        "and thickness",
    ] {
        assert!(
            reasons.iter().any(|reason| reason.contains(kind)),
            "{kind}: {reasons:#?}"
        );
    }
}

fn smallest() -> &'static [u8] {
    let blocks = subjects().iter().map(|subject| &subject.block);
    blocks.min_by_key(|block| block.len()).unwrap()
}

#[test]
fn every_changed_bit_is_refused() {
    let block = smallest();
    for at in 0..block.len() {
        for bit in 0..8 {
            let mut changed = block.to_vec();
            changed[at] ^= 1 << bit;
            let error = refusal(&changed);
            assert!(
                [Status::InvalidArgument, Status::Unsupported].contains(&error.status),
                "{at} {bit}: {error}"
            );
        }
        let mut inverted = block.to_vec();
        inverted[at] = !inverted[at];
        refusal(&inverted);
    }
}

#[test]
fn every_truncation_and_every_trailing_byte_is_refused() {
    let block = smallest();
    for length in 0..block.len() {
        let error = refusal(&block[..length]);
        assert_eq!(error.status, Status::InvalidArgument, "{length}: {error}");
        assert!(error.message.contains("truncated"), "{length}: {error}");
    }
    for more in 1..20 {
        let longer = [block, &vec![0; more]].concat();
        let error = refusal(&longer);
        assert_eq!(error.status, Status::InvalidArgument);
        assert!(error.message.contains("too long"), "{error}");
    }
    // Sizes that the header agrees with, but not the contents.
    for length in 48..block.len() {
        refusal(&resealed(block[..length].to_vec()));
    }
    let error = refusal(&resealed([block, &[0]].concat()));
    assert!(error.message.contains("end early"), "{error}");
}

#[test]
fn a_refusal_says_which() {
    let changed = |at: usize| {
        let mut block = smallest().to_vec();
        block[at] ^= 1;
        refusal(&block)
    };
    for (at, status, words) in [
        (0, Status::InvalidArgument, "no saved film"),
        (8, Status::Unsupported, "format"),
        (12, Status::Unsupported, "another build"),
        (24, Status::Unsupported, "another build"),
        (40, Status::InvalidArgument, "damaged"),
        (48, Status::InvalidArgument, "damaged"),
    ] {
        let error = changed(at);
        assert_eq!(error.status, status, "{at}: {error}");
        assert!(error.message.contains(words), "{at}: {error}");
    }
}

/// Two equal changes far apart, which sums and exclusive ors would overlook.
#[test]
fn changes_that_cancel_in_a_sum_are_refused() {
    let block = &subjects()[2].block;
    let rng = &mut rng(20);
    for _ in 0..2000 {
        let mut changed = block.clone();
        let (place, bit) = (rng.random_range(48..64), 1u8 << rng.random_range(0..8));
        let words = (block.len() - place) / 8;
        changed[place] ^= bit;
        changed[place + 8 * rng.random_range(1..words)] ^= bit;
        let error = refusal(&changed);
        assert!(error.message.contains("damaged"), "{error}");
    }
}

/// Bytes of contents are changed at random and sealed again: the block is refused or a film whose calls return.
#[test]
fn contents_of_any_kind_are_refused_or_a_film() {
    let rng = &mut rng(21);
    let (mut refused, mut loaded) = (0, 0);
    for Subject { name, block, .. } in subjects() {
        // Bits of what stands before the colours matter most.
        let early = block.len().min(48 + 700);
        for trial in 0..60 {
            let mut changed = block.clone();
            for _ in 0..rng.random_range(1..4) {
                let end = if trial % 4 == 0 { block.len() } else { early };
                let at = rng.random_range(48..end);
                changed[at] = match rng.random_range(0..4) {
                    0 => 0,
                    1 => 0xff,
                    2 => changed[at] ^ (1 << rng.random_range(0..8)),
                    _ => rng.random(),
                };
            }
            match Film::from_bytes(&resealed(changed)) {
                Ok(film) => {
                    loaded += 1;
                    let is_slow = ["series", "reference"].contains(&film.plan().method);
                    for _ in 0..if is_slow { 0 } else { 50 } {
                        let (c, d) = inputs(&film, rng);
                        let all = [Ok(film.reflectance(c, d))].into_iter().chain(
                            [Side::Ambient, Side::Base]
                                .map(|side| film.colors(side, c, d).map(|x| x.reflectance)),
                        );
                        for rgb in all.flatten() {
                            assert!(rgb.iter().all(|x| x.is_finite()), "{name}: {rgb:?}");
                        }
                    }
                }
                Err(error) => {
                    refused += 1;
                    assert!(!error.message.is_empty() && error.status != Status::Internal);
                }
            }
        }
    }
    println!("{refused} refused, {loaded} films");
    assert!(refused > 100 && loaded > 100, "{refused} {loaded}");
}
