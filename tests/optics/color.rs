//! Colours: the table and its interpolation against the published 1 nm table (tests/data, which the
//! library does not contain), whites, primaries, names.

use pellicle::Status;
use pellicle::optics::stack::{Layer, Side, Stack};
use pellicle::optics::{
    ChannelWeights, ColorSpace, Medium, Reference, VISIBLE_NM, White, matching_functions,
};

const SPACES: [ColorSpace; 4] = [
    ColorSpace::Rec709,
    ColorSpace::Rec2020,
    ColorSpace::AcesCg,
    ColorSpace::Xyz,
];

/// x, y, z, D65 every nanometre from 360 nm.
fn table() -> Vec<[f64; 4]> {
    let text = include_str!("../data/cie1931_2deg_d65_1nm.csv");
    let lines = text
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    lines
        .map(|line| {
            let numbers: Vec<f64> = line
                .split(',')
                .map(|field| field.parse().unwrap())
                .collect();
            numbers[1..].try_into().unwrap()
        })
        .collect()
}

/// The 1 nm table, interpolated linearly.
fn linear(table: &[[f64; 4]], nm: f64) -> [f64; 4] {
    let row = (nm - 360.0).floor();
    let (below, above) = (table[row as usize], table[row as usize + 1]);
    std::array::from_fn(|i| below[i] + (above[i] - below[i]) * (nm - 360.0 - row))
}

#[test]
fn matching_functions_agree_with_the_1_nm_table() {
    let table = table();
    let mut worst = [0.0_f64; 3];
    for nm in 380..=780 {
        let expected = table[nm - 360];
        let found = matching_functions(nm as f64);
        for i in 0..3 {
            let error = (found[i] - expected[i]).abs();
            worst[i] = worst[i].max(error);
            if nm % 5 == 0 {
                assert!(
                    error < 1e-16,
                    "{nm} nm, an entry of the 5 nm table: {error:e}"
                );
            }
        }
        let d65 = White::D65.power(nm as f64);
        assert!((d65 - expected[3]).abs() < 1e-4, "D65 at {nm} nm: {d65}");
        assert_eq!(White::E.power(nm as f64), 1.0);
    }
    println!("greatest errors of x, y, z: {worst:?}");
    assert!(
        worst[0] < 1.1e-4 && worst[1] < 5e-5 && worst[2] < 4.9e-4,
        "{worst:?}"
    );
}

#[test]
fn colors_of_films_agree_with_the_1_nm_table() {
    // The same trapezoid rule at 1/8 nm with both tables: soap, metals, oxides, 0 to 3 um.
    let table = table();
    let steps = 3200;
    let wavelengths: Vec<f64> = (0..=steps).map(|i| 380.0 + f64::from(i) * 0.125).collect();
    let linear: Vec<_> = wavelengths.iter().map(|&nm| linear(&table, nm)).collect();
    let named = |name| Medium::named(name).unwrap();
    let pairs = [
        (Medium::rgb([1.33; 3], [0.0; 3]).unwrap(), Medium::vacuum()),
        (named("SiO2"), named("Si")),
        (named("TiO2"), named("Ti")),
        (named("acrylic"), named("Al")),
        (named("MgF2"), named("BK7")),
        (named("Fe2O3"), named("Au")),
    ];
    let (mut worst, mut squares, mut count): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for (film, base) in &pairs {
        for d in [0.0, 40.0, 110.0, 250.0, 420.0, 700.0, 1000.0, 3000.0] {
            for cos_theta in [0.05, 0.4, 1.0] {
                let spectrum: Vec<f64> = wavelengths
                    .iter()
                    .map(|&nm| {
                        let layers = [Layer {
                            index: film.index(nm),
                            thickness_nm: d,
                        }];
                        let stack = Stack {
                            ambient: 1.0,
                            layers: &layers,
                            base: base.index(nm),
                        };
                        stack
                            .respond(Side::Ambient, cos_theta, nm)
                            .unpolarized_reflectance()
                    })
                    .collect();
                for white in [White::E, White::D65] {
                    for space in SPACES {
                        let rows = space.rows();
                        let expected: [f64; 3] = std::array::from_fn(|c| {
                            let (mut sum, mut total) = (0.0, 0.0);
                            for (i, [x, y, z, d65]) in linear.iter().enumerate() {
                                let power = if white == White::E { 1.0 } else { *d65 };
                                let end = if i == 0 || i == steps as usize {
                                    0.5
                                } else {
                                    1.0
                                };
                                let weight = end
                                    * power
                                    * (rows[c][0] * x + rows[c][1] * y + rows[c][2] * z);
                                total += weight;
                                sum += weight * spectrum[i];
                            }
                            sum / total
                        });
                        let found = weighted(&wavelengths, &spectrum, white, space);
                        for c in 0..3 {
                            let error = (found[c] - expected[c]).abs();
                            worst = worst.max(error);
                            squares += error * error;
                            count += 1.0;
                        }
                    }
                }
            }
        }
    }
    let rms = (squares / count).sqrt();
    println!("difference of {count} channels: greatest {worst:.1e}, RMS {rms:.1e}");
    assert!(worst < 6e-5 && rms < 1e-5, "{worst} {rms}");
}

fn weighted(wavelengths: &[f64], spectrum: &[f64], white: White, space: ColorSpace) -> [f64; 3] {
    let weights = ChannelWeights::new(white, space);
    let (mut sum, mut total) = ([0.0; 3], [0.0; 3]);
    for (i, (&nm, reflectance)) in wavelengths.iter().zip(spectrum).enumerate() {
        let end = if i == 0 || i + 1 == wavelengths.len() {
            0.5
        } else {
            1.0
        };
        for (c, weight) in weights.at(nm).into_iter().enumerate() {
            total[c] += end * weight;
            sum[c] += end * weight * reflectance;
        }
    }
    std::array::from_fn(|c| sum[c] / total[c])
}

#[test]
fn primaries_give_the_published_matrices() {
    // XYZ to RGB, up to the length of a row: BT.709 (Lindbloom), BT.2020 and AP1 (Academy TB-2014-004).
    let published = [
        (
            ColorSpace::Rec709,
            [
                [3.2404542, -1.5371385, -0.4985314],
                [-0.9692660, 1.8760108, 0.0415560],
                [0.0556434, -0.2040259, 1.0572252],
            ],
        ),
        (
            ColorSpace::Rec2020,
            [
                [1.7166511880, -0.3556707838, -0.2533662814],
                [-0.6666843518, 1.6164812366, 0.0157685458],
                [0.0176398574, -0.0427706133, 0.9421031212],
            ],
        ),
        (
            ColorSpace::AcesCg,
            [
                [1.6410233797, -0.3248032942, -0.2364246952],
                [-0.6636628587, 1.6153315917, 0.0167563477],
                [0.0117218943, -0.0082844420, 0.9883948585],
            ],
        ),
        (
            ColorSpace::Xyz,
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        ),
    ];
    for (space, matrix) in published {
        for (found, expected) in space.rows().iter().zip(matrix) {
            let sum: f64 = expected.iter().sum();
            for i in 0..3 {
                let error = (found[i] - expected[i] / sum).abs();
                assert!(
                    error < 1e-6,
                    "{space:?}: {found:?}, not {expected:?} / {sum}"
                );
            }
        }
    }
}

#[test]
fn whites_have_their_chromaticities() {
    for (white, x, y) in [
        (White::E, 1.0 / 3.0, 1.0 / 3.0),
        (White::D65, 0.3127, 0.3290),
    ] {
        let mut xyz = [0.0; 3];
        for nm in 380..=780 {
            let nm = f64::from(nm);
            for (sum, value) in xyz.iter_mut().zip(matching_functions(nm)) {
                *sum += value * white.power(nm);
            }
        }
        let sum: f64 = xyz.iter().sum();
        assert!(
            (xyz[0] / sum - x).abs() < 1e-4,
            "{white:?}: x = {}",
            xyz[0] / sum
        );
        assert!(
            (xyz[1] / sum - y).abs() < 1e-4,
            "{white:?}: y = {}",
            xyz[1] / sum
        );
    }
}

#[test]
fn white_and_space_change_the_color() {
    // Gold, so that an exchange of whites or spaces cannot pass unnoticed.
    let mut found = Vec::new();
    for white in [White::E, White::D65] {
        for space in SPACES {
            let gold = Medium::named("gold").unwrap();
            let stack = Reference::new(Medium::vacuum(), vec![], gold, white, space).unwrap();
            found.push(stack.evaluate(Side::Ambient, 1.0, &[]).reflectance);
        }
    }
    for (i, a) in found.iter().enumerate() {
        for b in &found[i + 1..] {
            assert!((0..3).any(|c| (a[c] - b[c]).abs() > 5e-3), "{found:?}");
        }
    }
}

#[test]
fn names() {
    assert_eq!(White::named("E").unwrap(), White::E);
    assert_eq!(White::named("D65").unwrap(), White::D65);
    let spaces =
        ["rec709", "rec2020", "acescg", "xyz"].map(|name| ColorSpace::named(name).unwrap());
    assert_eq!(spaces, SPACES);
    let error = White::named("D50").unwrap_err();
    assert_eq!(error.status, Status::UnknownName);
    assert_eq!(error.message, "unknown white 'D50'; known: E, D65");
    let error = ColorSpace::named("srgb").unwrap_err();
    assert!(
        error
            .message
            .ends_with("known: rec709, rec2020, acescg, xyz"),
        "{error}"
    );
    assert_eq!(VISIBLE_NM, [380.0, 780.0]);
}
