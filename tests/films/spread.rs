//! Spreads of thickness against quadrature over the reference, and laws of their averages.

use crate::common::films::constant;
use crate::common::rng;
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::stack::Side;
use pellicle::optics::{Medium, Reference};
use rand::{Rng, RngExt};

/// Reflectance and transmittance.
type Found = [[f64; 3]; 2];

/// Gauss's rule of three nodes in panels that resolve the distribution and the fringes, over converged colours.
fn truth(
    description: &FilmDescription,
    reference: &Reference,
    side: Side,
    [c, d, deviation]: [f64; 3],
) -> Found {
    const GAUSS: [(f64, f64); 3] = [
        (-0.774_596_669_241_483_4, 5.0 / 9.0),
        (0.0, 8.0 / 9.0),
        (0.774_596_669_241_483_4, 5.0 / 9.0),
    ];
    let varying = description.varying().unwrap();
    let [least, greatest] = description.layers[varying].thickness_nm;
    let from = least.max(d - 6.0 * deviation);
    let to = greatest.min(d + 6.0 * deviation);
    let index = description.layers[varying].medium.index(550.0);
    let panel = (0.5 * deviation).min(20.0 / index.re.hypot(index.im).max(1.0));
    let panels = ((to - from) / panel).ceil();
    let width = (to - from) / panels;
    let (mut sums, mut total) = ([[0.0; 3]; 2], 0.0);
    for i in 0..panels as usize {
        for (x, weight) in GAUSS {
            let t = from + (i as f64 + 0.5 * (1.0 + x)) * width;
            let weight = weight * (-0.5 * ((t - d) / deviation).powi(2)).exp();
            let mut thicknesses: Vec<f64> = description
                .layers
                .iter()
                .map(|layer| layer.thickness_nm[0])
                .collect();
            thicknesses[varying] = t;
            let found = reference.evaluate(side, c, &thicknesses);
            for (sum, rgb) in sums
                .iter_mut()
                .zip([found.reflectance, found.transmittance])
            {
                for channel in 0..3 {
                    sum[channel] += weight * rgb[channel];
                }
            }
            total += weight;
        }
    }
    sums.map(|sum| sum.map(|x| x / total))
}

fn reference(description: &FilmDescription) -> Reference {
    let layers = description.layers.iter().map(|layer| layer.medium.clone());
    Reference::new(
        description.ambient.clone(),
        layers.collect(),
        description.base.clone(),
        description.white,
        description.color_space,
    )
    .unwrap()
}

fn named(name: &str) -> Medium {
    Medium::named(name).unwrap()
}

/// One layer of many kinds, stacks, dispersing glass, a base that absorbs; drawn ranges of thickness.
fn films(rng: &mut impl Rng) -> Vec<(&'static str, FilmDescription)> {
    let soap = FilmDescription::new(named("vacuum")).layer(named("water"), [0.0, 1000.0]);
    let on_glass = FilmDescription::new(named("BK7")).layer(constant(1.38, 0.0), [50.0, 600.0]);
    let titania = FilmDescription::new(named("Ti")).layer(named("TiO2"), [0.0, 300.0]);
    let stack = FilmDescription::new(constant(1.52, 0.0))
        .layer(constant(2.3, 0.0), [57.0; 2])
        .layer(constant(1.45, 0.0), [20.0, 500.0])
        .layer(constant(2.3, 0.0), [57.0; 2]);
    let gold = FilmDescription::new(constant(1.5, 0.0)).layer(named("Au"), [0.0, 60.0]);
    let narrow = FilmDescription::new(constant(1.5, 3.0)).layer(constant(1.5, 0.0), [300.0, 340.0]);
    let thick = FilmDescription::new(constant(1.5, 0.0)).layer(constant(1.33, 0.0), [0.0, 2e4]);
    let both = |description: FilmDescription| FilmDescription {
        transmittance: true,
        ..description
    };
    let mut films = vec![
        ("soap", both(soap.clone())),
        ("soap, R only", soap),
        ("on BK7", both(on_glass.clone())),
        ("on BK7, R only", on_glass),
        ("titania on titanium", titania),
        ("cavity", both(stack)),
        ("gold on glass", both(gold)),
        ("narrow range", narrow),
        ("thick", thick),
    ];
    for _ in 0..4 {
        let eta = rng.random_range(1.3..2.5);
        let base = constant(
            rng.random_range(1.0..3.0),
            [0.0, 2.0][rng.random_range(0..2)],
        );
        let least = rng.random_range(0.0..300.0);
        let greatest = least + rng.random_range(50.0..900.0);
        let film = FilmDescription::new(base).layer(constant(eta, 0.0), [least, greatest]);
        films.push(("random", film));
    }
    for (_, film) in &mut films {
        let [least, greatest] = film.layers[film.varying().unwrap()].thickness_nm;
        film.thickness_spread_max_nm = greatest - least;
    }
    films
}

fn spreads(film: &FilmDescription) -> Vec<f64> {
    let most = film.thickness_spread_max_nm;
    let all = [0.1, 1.0, 4.0, 10.0, 18.0, 30.0, 45.0, 70.0, 110.0, 200.0];
    let mut spreads: Vec<f64> = all.into_iter().filter(|nm| *nm < most).collect();
    spreads.push(most);
    spreads
}

#[test]
fn averages_are_within_the_tolerance() {
    let mut rng = rng(7);
    for (name, description) in films(&mut rng) {
        let started = std::time::Instant::now();
        let film = Film::new(&description).unwrap();
        let created = started.elapsed().as_secs_f64();
        let plain = FilmDescription {
            thickness_spread_max_nm: 0.0,
            ..description.clone()
        };
        let started = std::time::Instant::now();
        let plain = Film::new(&plain).unwrap();
        let created_plain = started.elapsed().as_secs_f64();
        let reference = reference(&description);
        let [least, greatest] = film.varying_thickness_nm().unwrap();
        let (mut worst, mut place) = (0.0, String::new());
        for deviation in spreads(&description) {
            for part in [0.0, 0.02, 0.3, 0.71, 0.97, 1.0] {
                let d = f64::from((least + part * (greatest - least)) as f32);
                let c = f64::from(rng.random_range(0.02..1.0f32));
                let deviation = f64::from(deviation as f32);
                let sides: &[Side] = match description.transmittance {
                    true => &[Side::Ambient, Side::Base],
                    false => &[Side::Ambient],
                };
                for side in sides {
                    let truth = truth(&description, &reference, *side, [c, d, deviation]);
                    let [c, d, deviation] = [c, d, deviation].map(|x| x as f32);
                    let found = if description.transmittance {
                        let found = film.colors_spread(*side, c, d, deviation).unwrap();
                        [found.reflectance, found.transmittance].to_vec()
                    } else {
                        vec![film.reflectance_spread(c, d, deviation).unwrap()]
                    };
                    for (which, (found, truth)) in found.iter().zip(truth).enumerate() {
                        for channel in 0..3 {
                            let truth = truth[channel].clamp(0.0, 1.0);
                            let error = (f64::from(found[channel]) - truth).abs();
                            if error > worst {
                                worst = error;
                                place = format!(
                                    "{} {side:?} at {c}, {d} +- {deviation} nm",
                                    ["R", "T"][which]
                                );
                            }
                        }
                    }
                }
            }
        }
        println!(
            "{name}: {worst:.2e} ({place}), {} bytes for {}, create {:.0} ms for {:.0}: {}",
            film.plan().bytes,
            plain.plan().bytes,
            1e3 * created,
            1e3 * created_plain,
            film.plan().reason
        );
        assert!(
            worst <= description.tolerance,
            "{name}: {worst:.2e}, {place}"
        );
    }
}
