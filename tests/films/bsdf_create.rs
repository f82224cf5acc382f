//! The smooth `film` model: what it can be made of, and how its thickness is given.

use crate::common::calls::Calls;
use crate::common::films::{Kind, compiled, constant};
use crate::common::{degrees, rng, uniforms, visible};
use crate::film_lobes::{REFLECTION, assert_colors, on};
use glam::Vec3;
use pellicle::bsdf::Flags;
use pellicle::film::FilmDescription;
use pellicle::optics::Medium;
use pellicle::optics::stack::Side;
use pellicle::{Bsdf, Description};

/// A film on a base that absorbs, or without its transmittance, is a mirror with one side.
#[test]
fn opaque_films_have_one_side() {
    let plain = FilmDescription::new(constant(1.5, 0.0)).layer(constant(1.38, 0.0), [100.0; 2]);
    let plain = compiled(&plain);
    for film in [Kind::Metal.film(), plain] {
        let bsdf: Bsdf = Bsdf::new(&on(&film)).unwrap();
        assert_eq!(bsdf.flags(), Flags::REFLECTION.with(Flags::DELTA));
        let mut rng = rng(11);
        for _ in 0..50 {
            let wo = visible(&bsdf, &mut rng).as_vec3();
            assert!(wo.z > 0.0);
            let below = bsdf.sampled(-wo, Vec3::splat(0.5), None);
            assert_eq!(
                (below.flags, below.weight, below.eta),
                (Flags(0), [0.0; 3], 0.0)
            );
            assert_eq!(bsdf.directional_albedo(-wo, None), [0.0; 3]);
            let found = bsdf.sampled(wo, Vec3::from(uniforms(&mut rng)), None);
            let expected = film.reflectance(wo.z, 0.0);
            assert_eq!((found.lobe, found.weight), (REFLECTION, expected));
            assert_eq!(bsdf.directional_albedo(wo, None), expected);
        }
    }
}

#[test]
fn thickness_varies_within_its_range() {
    let film = Kind::Lens.film();
    let wo = degrees(30.0, 0.0).as_vec3();
    let at = |nm: f32| -> [f32; 3] {
        let colors = film.colors(Side::Ambient, wo.z, nm).unwrap();
        std::array::from_fn(|c| colors.reflectance[c].min(1.0 - colors.transmittance[c]))
    };
    let varying = on(&film).vary("thickness_nm", 100.0, 500.0);
    let own = varying.clone().set("thickness_nm", &[120.0]);
    let [varying, own]: [Bsdf; 2] = [varying, own].map(|d| Bsdf::new(&d).unwrap());
    let reflected = |bsdf: &Bsdf, varying: Option<&[f32]>| {
        let probability = bsdf.lobe_densities(wo, wo, varying).0[REFLECTION];
        let sample = bsdf.sampled(wo, Vec3::ZERO, varying);
        assert_eq!(sample.lobe, REFLECTION);
        sample.weight.map(|weight| weight * probability)
    };
    let expect = |found, nm| assert_colors(found, at(nm), 1e-6, &format!("{nm} nm"));
    assert!(
        (at(100.0)[1] - at(250.0)[1]).abs() > 1e-3,
        "the thickness must matter"
    );
    for (given, used) in [(250.0, 250.0), (99.0, 100.0), (700.0, 500.0), (-1.0, 100.0)] {
        expect(reflected(&varying, Some(&[given])), used);
        assert_eq!(
            varying.directional_albedo(wo, Some(&[given])),
            varying.directional_albedo(wo, Some(&[used]))
        );
    }
    expect(reflected(&varying, None), 100.0);
    expect(reflected(&own, None), 120.0);
    let defaults = |bsdf: &Bsdf| {
        bsdf.varying()
            .map(|v| v.defaults.to_vec())
            .collect::<Vec<_>>()
    };
    assert_eq!([defaults(&varying), defaults(&own)], [[[100.0]], [[120.0]]]);
    for unusable in [&[f32::NAN][..], &[f32::INFINITY], &[], &[200.0, 200.0]] {
        let sample = varying.sampled(wo, Vec3::splat(0.5), Some(unusable));
        assert_eq!(
            (sample.flags, sample.weight),
            (Flags(0), [0.0; 3]),
            "{unusable:?}"
        );
        assert_eq!(varying.directional_albedo(wo, Some(unusable)), [0.0; 3]);
    }
}

#[test]
fn errors_say_what_is_wrong() {
    use pellicle::Status::{InvalidArgument, OutOfRange};
    let varies = Kind::Lens.film();
    let fixed = Kind::Metal.film();
    let plain = Description::new("film");
    let cases = [
        (
            plain.clone(),
            InvalidArgument,
            "model 'film' needs a film, but none is given",
        ),
        (
            Description::new("lambert").film(varies.clone()),
            InvalidArgument,
            "model 'lambert' uses no film, but one is given",
        ),
        (
            Description::new("layered")
                .set("thickness_nm", &[100.0])
                .film(varies.clone()),
            InvalidArgument,
            "model 'layered' uses no film, but one is given",
        ),
        (
            on(&varies),
            InvalidArgument,
            "model 'film' needs 'thickness_nm', fixed or varying within [0, 600], as a layer of its \
             film varies",
        ),
        (
            on(&fixed).set("thickness_nm", &[300.0]),
            InvalidArgument,
            "model 'film' takes no 'thickness_nm' here: no layer of its film varies",
        ),
        (
            on(&fixed).vary("thickness_nm", 300.0, 300.0),
            InvalidArgument,
            "model 'film' takes no 'thickness_nm' here: no layer of its film varies",
        ),
        (
            on(&varies).set("thickness_nm", &[700.0]),
            OutOfRange,
            "parameter 'thickness_nm' = 700 of model 'film' is outside [0, 600], the range of the \
             film's layer",
        ),
        (
            on(&varies).vary("thickness_nm", 0.0, 700.0),
            OutOfRange,
            "parameter 'thickness_nm (greatest varying value)' = 700 of model 'film' is outside \
             [0, 600], the range of the film's layer",
        ),
        (
            on(&Kind::Bubble.film()).vary("thickness_nm", 10.0, 700.0),
            OutOfRange,
            "parameter 'thickness_nm (least varying value)' = 10 of model 'film' is outside \
             [50, 900], the range of the film's layer",
        ),
        (
            on(&varies)
                .set("thickness_nm", &[700.0])
                .vary("thickness_nm", 0.0, 600.0),
            OutOfRange,
            "parameter 'thickness_nm' = 700 of model 'film' is outside [0, 600], the range of the \
             film's layer",
        ),
    ];
    for (description, status, message) in cases {
        let Err(error) = Bsdf::<f32>::new(&description) else {
            panic!("{description:?} is accepted");
        };
        assert_eq!((error.status, &*error.message), (status, message));
    }
}

/// The ends of a layer's range are numbers in double precision; thicknesses are not.
#[test]
fn the_ends_of_the_range_are_inside() {
    let [min, max] = [0.1, 333.3];
    let film = FilmDescription::new(Medium::vacuum()).layer(constant(1.33, 0.0), [min, max]);
    let film = compiled(&film);
    for thickness in [min as f32, max as f32] {
        Bsdf::<f32>::new(&on(&film).set("thickness_nm", &[thickness])).unwrap();
    }
    Bsdf::<f32>::new(&on(&film).vary("thickness_nm", min as f32, max as f32)).unwrap();
}
