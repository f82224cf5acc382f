//! The smooth `film` model: how much light it sends where, against its own film.

use crate::common;
use crate::common::calls::Calls;
use crate::common::films::{Kind, compiled};
use crate::common::{degrees, is_dirac, rng, uniforms, visible};
use crate::film_lobes::{
    assert_colors, assert_near, bsdf, drawn, for_every_film, lobes, on, side, split,
};
use glam::Vec3;
use pellicle::bsdf::Flags;
use pellicle::film::FilmDescription;
use pellicle::optics::stack::Side;
use pellicle::{Bsdf, Sample};
use rand::RngExt;

#[test]
fn lobes_are_dirac_and_those_that_there_are() {
    for kind in Kind::ALL {
        let bsdf = bsdf(kind, 1);
        let both = Flags::REFLECTION
            .with(Flags::DELTA)
            .with(Flags::TRANSMISSION);
        let expected = match kind {
            Kind::Metal => (1, Flags::REFLECTION.with(Flags::DELTA)),
            _ => (2, both),
        };
        assert_eq!(
            (bsdf.lobe_infos().len(), bsdf.flags()),
            expected,
            "{kind:?}"
        );
        assert_eq!((bsdf.info().lobes.len(), bsdf.info().flags()), (2, both));
        assert!(is_dirac(&bsdf));
    }
}

#[test]
fn value_and_density_are_zero_even_where_samples_go() {
    for_every_film(2, |_, bsdf, _, _, rng| {
        for _ in 0..20 {
            let wo = visible(bsdf, rng).as_vec3();
            let mut wis = vec![wo, -wo, visible(bsdf, rng).as_vec3()];
            wis.extend(lobes(bsdf, wo).into_iter().map(|(_, sample)| sample.wi));
            for wi in wis {
                assert_eq!(bsdf.value_pdf(wo, wi, None), ([0.0; 3], 0.0));
                assert_eq!(bsdf.value(wo, wi, None), [0.0; 3]);
            }
        }
    });
}

#[test]
fn weight_times_probability_is_the_films() {
    for_every_film(3, |kind, bsdf, film, thickness, rng| {
        for _ in 0..20 {
            let wo = visible(bsdf, rng).as_vec3();
            let expected = split(film, bsdf, wo, thickness);
            let found = lobes(bsdf, wo);
            assert!(!found.is_empty());
            for (probability, sample) in found {
                assert_eq!(sample.pdf, 0.0);
                let factor = probability * sample.eta * sample.eta;
                let power = sample.weight.map(|weight| weight * factor);
                let what = format!("{kind:?} {wo} {sample:?}");
                assert_colors(power, expected[sample.lobe], 2e-6, &what);
            }
        }
    });
}

#[test]
fn lobes_are_chosen_in_proportion_to_their_power() {
    const COUNT: usize = 2000;
    for_every_film(4, |kind, bsdf, _, _, rng| {
        let wo = visible(bsdf, rng).as_vec3();
        let found = lobes(bsdf, wo);
        let power = |(probability, sample): &(f32, Sample)| {
            probability * sample.eta * sample.eta * sample.weight.iter().sum::<f32>()
        };
        let total: f32 = found.iter().map(power).sum();
        let mut counts = [0; 2];
        for _ in 0..COUNT {
            let sample = bsdf.sampled(wo, Vec3::from(uniforms(rng)), None);
            counts[sample.lobe] += 1;
        }
        for lobe in &found {
            let (probability, sample) = lobe;
            let what = format!("{kind:?} {wo} {sample:?}");
            assert_near(*probability, power(lobe) / total, 1e-5, &what);
            let frequency = counts[sample.lobe] as f32 / COUNT as f32;
            // 90 comparisons: 4.5 standard errors are exceeded by chance once in 1,600 runs.
            let error = (probability * (1.0 - probability) / COUNT as f32).sqrt();
            assert_near(frequency, *probability, 4.5 * error, &what);
        }
    });
}

#[test]
fn weights_add_up_to_the_albedo() {
    for_every_film(5, |kind, bsdf, _, _, rng| {
        for _ in 0..20 {
            let wo = visible(bsdf, rng).as_vec3();
            let albedo = bsdf.directional_albedo(wo, None);
            let sum = std::array::from_fn(|c| {
                let terms = lobes(bsdf, wo).into_iter();
                terms.map(|(p, sample)| p * sample.weight[c]).sum()
            });
            assert_colors(sum, albedo, 3e-6, &format!("{kind:?} {wo}"));
        }
    });
}

/// R + T <= 1 for any error of the film, even where its colours add up to more.
#[test]
fn power_is_conserved() {
    let mut greatest_unclipped: f32 = 0.0;
    for kind in Kind::ALL {
        let mut rng = rng(6);
        for _ in 0..10 {
            let (description, film, thickness) = drawn(kind, &mut rng);
            let bsdf: Bsdf = Bsdf::new(&description).unwrap();
            for _ in 0..20 {
                let wo = visible(&bsdf, &mut rng).as_vec3();
                for c in 0..3 {
                    let power = |(p, s): (f32, Sample)| p * s.eta * s.eta * s.weight[c];
                    let power: f32 = lobes(&bsdf, wo).into_iter().map(power).sum();
                    assert!(power <= 1.0 + 2e-6, "{kind:?} {wo}: {power}");
                    let colors = film.colors(side(wo), wo.z.abs(), thickness).unwrap();
                    let sum = colors.reflectance[c] + colors.transmittance[c];
                    greatest_unclipped = greatest_unclipped.max(sum);
                }
            }
        }
    }
    println!("the film's own R + T reach {greatest_unclipped}");
    assert!(greatest_unclipped > 1.005, "the clip has lost its reason");
}

/// T as the film has it from the base's side is what the model gives there, where nothing disperses.
#[test]
fn transmission_from_the_base_is_the_films() {
    let film = Kind::Lens.film();
    let mut rng = rng(12);
    for _ in 0..200 {
        let wo = -common::hemisphere(&mut rng).as_vec3();
        let thickness = rng.random_range(0.0..600.0);
        let own = film.colors(Side::Base, wo.z.abs(), thickness).unwrap();
        let bsdf: Bsdf = Bsdf::new(&on(&film).set("thickness_nm", &[thickness])).unwrap();
        let [_, transmittance] = split(&film, &bsdf, wo, thickness);
        // Twice the tolerance, for two errors of the film.
        assert_colors(own.transmittance, transmittance, 4e-3, &format!("{wo}"));
    }
}

/// An unclipped film has channels outside [0, 1], but the model gives none.
#[test]
fn an_unclipped_film_gives_no_negative_light() {
    let film = FilmDescription {
        unclipped: true,
        ..Kind::Bubble.description()
    };
    let film = compiled(&film);
    let mut is_clipped = false;
    for thickness in (50..900).step_by(10).map(|nm| nm as f32) {
        let bsdf: Bsdf = Bsdf::new(&on(&film).set("thickness_nm", &[thickness])).unwrap();
        let wo = degrees(40.0, 0.0).as_vec3();
        let colors = film.colors(Side::Ambient, wo.z, thickness).unwrap();
        let outside = |x: &f32| !(0.0..=1.0).contains(x);
        is_clipped |= colors.reflectance.iter().any(outside);
        for (_, sample) in lobes(&bsdf, wo) {
            assert!(sample.weight.iter().all(|w| *w >= 0.0), "{sample:?}");
        }
        assert!(
            bsdf.directional_albedo(wo, None)
                .iter()
                .all(|a| (0.0..=1.0 + 1e-6).contains(a))
        );
    }
    assert!(is_clipped, "these films show nothing");
}
