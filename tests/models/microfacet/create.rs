//! The `microfacet` model: which descriptions it refuses, and what it says.

use crate::common::films::{Kind, compiled, constant};
use pellicle::bsdf::Flags;
use pellicle::film::FilmDescription;
use pellicle::{Bsdf, Description, Status};

fn microfacet() -> Description {
    Description::new("microfacet")
}

/// The status, and every one of the words.
fn assert_refused(description: &Description, status: Status, words: &[&str]) {
    let Err(error) = Bsdf::<f32>::new(description) else {
        panic!("{description:?} is accepted");
    };
    assert_eq!(error.status, status, "{error}");
    for word in words {
        assert!(error.message.contains(word), "'{word}' is not in: {error}");
    }
}

fn assert_accepted(description: &Description) -> Bsdf {
    Bsdf::new(description).unwrap_or_else(|error| panic!("{description:?}: {error}"))
}

#[test]
fn every_default_is_complete() {
    let bsdf = assert_accepted(&microfacet());
    assert_eq!(bsdf.flags(), Flags::REFLECTION.with(Flags::GLOSSY));
    for distribution in ["ggx", "beckmann", "blinn_phong", "abc", "sgd"] {
        assert_accepted(&microfacet().choose("distribution", distribution));
    }
    for masking in ["smith", "schlick", "kelemen", "cook_torrance", "implicit"] {
        assert_accepted(&microfacet().choose("masking", masking));
    }
    for fresnel in ["schlick", "dielectric", "conductor"] {
        assert_accepted(&microfacet().choose("fresnel", fresnel));
    }
}

#[test]
fn unknown_choices_are_answered_with_the_known_ones() {
    let known: [(&str, &[&str]); 4] = [
        (
            "distribution",
            &["ggx", "beckmann", "blinn_phong", "abc", "sgd"],
        ),
        (
            "masking",
            &["smith", "schlick", "kelemen", "cook_torrance", "implicit"],
        ),
        ("fresnel", &["schlick", "dielectric", "conductor", "film"]),
        (
            "metal",
            &[
                "custom", "Ag", "Al", "Au", "Cr", "Cu", "Fe", "Ni", "Pt", "Ti",
            ],
        ),
    ];
    for (param, choices) in known {
        let unknown = microfacet().choose(param, "velvet");
        let words: Vec<&str> = ["velvet", param]
            .into_iter()
            .chain(choices.iter().copied())
            .collect();
        assert_refused(&unknown, Status::UnknownName, &words);
    }
}

#[test]
fn alpha_is_that_of_a_mirror_or_of_a_rough_surface() {
    let of = |alpha: f32| microfacet().set("alpha", &[alpha]);
    let mirror = assert_accepted(&of(0.0));
    assert_eq!(mirror.flags(), Flags::REFLECTION.with(Flags::DELTA));
    assert_eq!(mirror.lobe_infos().len(), 1);
    for alpha in [1e-4, 0.5, 1.0] {
        let rough = assert_accepted(&of(alpha));
        assert_eq!(rough.flags(), Flags::REFLECTION.with(Flags::GLOSSY));
    }
    for alpha in [1e-9f32, 9.9e-5] {
        assert_refused(
            &of(alpha),
            Status::OutOfRange,
            &["alpha", "0.0001", "mirror"],
        );
    }
    for alpha in [-0.1, 1.01, f32::NAN, f32::INFINITY] {
        assert_refused(&of(alpha), Status::OutOfRange, &["alpha", "[0, 1]"]);
    }
}

#[test]
fn alpha_varies_within_rough_surfaces() {
    let varying = |min, max| microfacet().vary("alpha", min, max);
    assert_accepted(&varying(1e-4, 1.0));
    for (min, max) in [(0.0, 1.0), (1e-5, 0.5), (0.0, 0.0)] {
        assert_refused(&varying(min, max), Status::OutOfRange, &["alpha", "0.0001"]);
    }
    // Where nothing is given per call the own value counts, and it is another kind of surface.
    let mirror = varying(0.1, 0.2).set("alpha", &[0.0]);
    assert_refused(&mirror, Status::OutOfRange, &["alpha", "mirror"]);
}

#[test]
fn tables_fix_alpha_and_are_round() {
    for distribution in ["blinn_phong", "abc", "sgd"] {
        let description = microfacet().choose("distribution", distribution);
        let varying = description.clone().vary("alpha", 0.1, 0.5);
        assert_refused(
            &varying,
            Status::Unsupported,
            &["alpha", distribution, "table", "ggx", "beckmann"],
        );
        let stretched = description.clone().set("anisotropy", &[0.3]);
        let words = ["anisotropy", distribution, "ggx", "beckmann"];
        assert_refused(&stretched, Status::Unsupported, &words);
        let varying = description.clone().vary("anisotropy", 0.0, 0.5);
        assert_refused(&varying, Status::Unsupported, &words);
        assert_accepted(&description.vary("f0", 0.0, 1.0));
    }
    for distribution in ["ggx", "beckmann"] {
        let description = microfacet().choose("distribution", distribution);
        let all = description
            .vary("alpha", 0.01, 1.0)
            .vary("anisotropy", 0.0, 1.0);
        let bsdf = assert_accepted(&all.vary("rotation_turns", 0.0, 1.0));
        assert_eq!(bsdf.varying_floats(), 3);
    }
}

#[test]
fn choices_and_constants_do_not_vary() {
    for param in [
        "distribution",
        "f90",
        "eta",
        "k",
        "abc_exponent",
        "sgd_p",
        "metal",
    ] {
        let varying = microfacet().vary(param, 0.5, 0.6);
        assert_refused(
            &varying,
            Status::Unsupported,
            &[param, "alpha", "rotation_turns", "thickness_nm"],
        );
    }
}

#[test]
fn dielectrics_are_denser_than_vacuum() {
    let of = |fresnel: &str| {
        microfacet()
            .choose("fresnel", fresnel)
            .set("eta", &[1.2, 0.9, 1.5])
    };
    assert_refused(
        &of("dielectric"),
        Status::OutOfRange,
        &["eta[1]", "0.9", "[1, 10]"],
    );
    assert_accepted(&of("conductor"));
    assert_refused(&of("schlick"), Status::InvalidArgument, &["eta", "schlick"]);
    let thin = microfacet().set("eta", &[0.001]);
    assert_refused(&thin, Status::OutOfRange, &["eta", "0.01"]);
    let opaque = microfacet().set("k", &[21.0]);
    assert_refused(&opaque, Status::OutOfRange, &["k", "20"]);
}

#[test]
fn films_belong_to_their_choice() {
    let choices = ["schlick", "dielectric", "conductor", "film"];
    let lacking = microfacet().choose("fresnel", "film");
    let words: Vec<&str> = ["needs a film", "'fresnel' = film"]
        .into_iter()
        .chain(choices)
        .collect();
    assert_refused(&lacking, Status::InvalidArgument, &words);
    for fresnel in ["schlick", "dielectric", "conductor"] {
        let unused = microfacet()
            .choose("fresnel", fresnel)
            .film(Kind::Lens.film());
        let made = format!("'fresnel' = {fresnel}");
        let words: Vec<&str> = ["uses no film", &made].into_iter().chain(choices).collect();
        assert_refused(&unused, Status::InvalidArgument, &words);
        let thickness = microfacet()
            .choose("fresnel", fresnel)
            .set("thickness_nm", &[300.0]);
        assert_refused(
            &thickness,
            Status::InvalidArgument,
            &["thickness_nm", "no film"],
        );
    }
}

#[test]
fn thickness_is_that_of_the_layer() {
    let with = |film| microfacet().choose("fresnel", "film").film(film);
    let lens = || with(Kind::Lens.film());
    assert_accepted(&lens().set("thickness_nm", &[600.0]));
    assert_accepted(&lens().vary("thickness_nm", 0.0, 600.0));
    assert_refused(
        &lens(),
        Status::InvalidArgument,
        &["thickness_nm", "[0, 600]"],
    );
    let thick = lens().set("thickness_nm", &[601.0]);
    assert_refused(
        &thick,
        Status::OutOfRange,
        &["thickness_nm", "601", "[0, 600]"],
    );
    let far = lens().vary("thickness_nm", 0.0, 700.0);
    assert_refused(&far, Status::OutOfRange, &["thickness_nm", "700"]);
    let fixed =
        compiled(&FilmDescription::new(constant(1.5, 1.0)).layer(constant(1.4, 0.0), [99.0; 2]));
    assert_accepted(&with(fixed.clone()));
    let given = with(fixed).set("thickness_nm", &[99.0]);
    assert_refused(
        &given,
        Status::InvalidArgument,
        &["thickness_nm", "no layer"],
    );
}
