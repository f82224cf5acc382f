//! The models, one file or folder each, and the lobe that some of them share.

pub(crate) mod disney_diffuse;
pub(crate) mod film;
pub(crate) mod lambert;
pub(crate) mod layered;
pub(crate) mod metallic_roughness;
pub(crate) mod microfacet;
pub(crate) mod oren_nayar;
pub(crate) mod phong;
pub(crate) mod power_lobe;
