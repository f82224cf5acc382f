//! Media given by tables whose entries are closer than any grid: the reference against a million wavelengths.

use pellicle::num::Rgb;
use pellicle::optics::stack::Side;
use pellicle::optics::{
    ChannelWeights, ColorSpace, Complex, Medium, Reference, TOLERANCE, VISIBLE_NM, White,
};
use std::sync::OnceLock;

/// 4e-4 nm apart.
const COUNT: usize = 1_000_000;

/// Columns: wavelength (nm), index.
type Table = Vec<(f64, Complex<f64>)>;

/// An index that is `top` at `centers` and `around` from `half_width` on beside them, all nm.
fn lines(centers: &[f64], half_width: f64, around: [f64; 2], top: [f64; 2]) -> Table {
    let [around, top] = [around, top].map(|[eta, k]| Complex::new(eta, k));
    let mut table = vec![(380.0, around), (780.0, around)];
    for center in centers {
        let [before, after] = [center - half_width, center + half_width];
        table.extend([(before, around), (*center, top), (after, around)]);
    }
    table.sort_by(|a, b| a.0.total_cmp(&b.0));
    table
}

fn one_line(around: [f64; 2], top: [f64; 2]) -> Table {
    lines(&[550.3], 0.3, around, top)
}

/// 39 of them, at no round distance.
fn comb(around: [f64; 2], top: [f64; 2]) -> Table {
    let centers: Vec<f64> = (0..39u8).map(|i| 391.37 + 9.87 * f64::from(i)).collect();
    lines(&centers, 0.1, around, top)
}

fn medium(table: &Table) -> Medium {
    let column = |of: fn(&(f64, Complex<f64>)) -> f64| table.iter().map(of).collect::<Vec<f64>>();
    Medium::table(
        &column(|row| row.0),
        &column(|row| row.1.re),
        &column(|row| row.1.im),
    )
    .unwrap()
}

/// The index at ascending wavelengths, by linear interpolation.
struct Ascending<'a> {
    table: &'a Table,
    row: usize,
}

impl Ascending<'_> {
    fn at(&mut self, nm: f64) -> Complex<f64> {
        while self.table[self.row + 1].0 < nm && self.row + 2 < self.table.len() {
            self.row += 1;
        }
        let [(x0, a), (x1, b)] = [self.table[self.row], self.table[self.row + 1]];
        let t = ((nm - x0) / (x1 - x0)).clamp(0.0, 1.0);
        a.scaled(1.0 - t) + b.scaled(t)
    }
}

fn divided(a: Complex<f64>, b: Complex<f64>) -> Complex<f64> {
    a * Complex::new(b.re, -b.im).scaled(1.0 / b.norm_squared())
}

fn exp(z: Complex<f64>) -> Complex<f64> {
    let (sin, cos) = z.im.sin_cos();
    Complex::new(cos, sin).scaled(z.re.exp())
}

fn root(z: Complex<f64>) -> Complex<f64> {
    let modulus = z.norm_squared().sqrt();
    let (re, im) = ((modulus + z.re) / 2.0, (modulus - z.re) / 2.0);
    Complex::new(re.max(0.0).sqrt(), im.max(0.0).sqrt())
}

/// R and T of one layer by Airy's formula: r = (r01 + r12 E) / (1 + r01 r12 E), Born and Wolf, section 1.6.
fn airy(n: [Complex<f64>; 3], cos_theta: f64, thickness_nm: f64, nm: f64) -> [f64; 2] {
    let one = Complex::real(1.0);
    let tangential = (n[0] * n[0]).scaled(1.0 - cos_theta * cos_theta);
    let q = n.map(|n| root(n * n - tangential));
    let phase = q[1].scaled(2.0 * std::f64::consts::PI * thickness_nm / nm);
    let half = exp(Complex::new(-phase.im, phase.re));
    let mut sums = [0.0; 2];
    for p_polarized in [false, true] {
        let w: [Complex<f64>; 3] = std::array::from_fn(|i| {
            if p_polarized {
                divided(q[i], n[i] * n[i])
            } else {
                q[i]
            }
        });
        let r = [0, 1].map(|i| divided(w[i] - w[i + 1], w[i] + w[i + 1]));
        let t = [0, 1].map(|i| divided(w[i].scaled(2.0), w[i] + w[i + 1]));
        let loop_factor = one + r[0] * r[1] * half * half;
        let reflected = divided(r[0] + r[1] * half * half, loop_factor);
        let passed = divided(t[0] * t[1] * half, loop_factor);
        sums[0] += 0.5 * reflected.norm_squared();
        sums[1] += 0.5 * passed.norm_squared() * w[2].re / w[0].re;
    }
    sums
}

fn weights() -> &'static [(f64, Rgb<f64>)] {
    static WEIGHTS: OnceLock<Vec<(f64, Rgb<f64>)>> = OnceLock::new();
    WEIGHTS.get_or_init(|| {
        let weights = ChannelWeights::new(White::E, ColorSpace::Rec709);
        let [first, last] = VISIBLE_NM;
        let step = (last - first) / COUNT as f64;
        let nm = (0..COUNT).map(|i| first + (i as f64 + 0.5) * step);
        nm.map(|nm| (nm, weights.at(nm))).collect()
    })
}

/// Ambient, layer and base; the colours R and T by the midpoint rule.
fn quadrature(media: &[Table; 3], side: Side, cos_theta: f64, thickness_nm: f64) -> [Rgb<f64>; 2] {
    let mut media = media.each_ref().map(|table| Ascending { table, row: 0 });
    let (mut white, mut sums) = ([0.0; 3], [[0.0; 3]; 2]);
    for (nm, weight) in weights() {
        let [a, b, c] = media.each_mut().map(|medium| medium.at(*nm));
        let indices = match side {
            Side::Ambient => [a, b, c],
            Side::Base => [c, b, a],
        };
        let found = airy(indices, cos_theta, thickness_nm, *nm);
        for channel in 0..3 {
            white[channel] += weight[channel];
            for i in 0..2 {
                sums[i][channel] += weight[channel] * found[i];
            }
        }
    }
    sums.map(|sum| std::array::from_fn(|channel| sum[channel] / white[channel]))
}

/// Compares the reference with the quadrature and returns the number of samples.
fn compare(name: &str, media: [Table; 3], side: Side, cos_theta: f64, thickness_nm: f64) -> usize {
    let [a, b, c] = media.each_ref().map(medium);
    let reference = Reference::new(a, vec![b], c, White::E, ColorSpace::Rec709).unwrap();
    let found = reference.evaluate(side, cos_theta, &[thickness_nm]);
    let expected = quadrature(&media, side, cos_theta, thickness_nm);
    let pairs = [found.reflectance, found.transmittance];
    let pairs = pairs.as_flattened().iter().zip(expected.as_flattened());
    let error = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let samples = found.samples;
    println!("{name} {side:?} {cos_theta} {thickness_nm}: {error:.1e}, {samples} samples");
    assert!(found.change <= TOLERANCE, "{name} {found:?}");
    assert!(
        error < 2.0 * TOLERANCE,
        "{name} {cos_theta} {thickness_nm}: {error:e}"
    );
    samples
}

fn flat(eta: f64) -> Table {
    lines(&[], 0.0, [eta, 0.0], [eta, 0.0])
}

/// Lines of the base, without a layer and below one.
#[test]
fn lines_of_a_base_are_seen() {
    for base in [
        one_line([1.5, 0.0], [1.5, 20.0]),
        comb([1.5, 0.0], [1.5, 20.0]),
        comb([1.5, 0.0], [3.0, 0.0]),
    ] {
        for (cos_theta, thickness_nm) in [(1.0, 0.0), (0.3, 0.0), (0.9, 300.0), (0.05, 120.0)] {
            let media = [flat(1.0), flat(1.38), base.clone()];
            compare("base", media, Side::Ambient, cos_theta, thickness_nm);
        }
    }
}

/// Lines of the layer: of its extinction, and of its index, within which there are fringes.
#[test]
fn lines_of_a_layer_are_seen_from_both_sides() {
    for (name, layer, thickness_nm) in [
        ("metal", one_line([1.7, 0.0], [1.7, 20.0]), 150.0),
        ("metal comb", comb([1.7, 0.0], [1.7, 20.0]), 150.0),
        ("gas", comb([1.0, 0.0], [1.0, 1e-4]), 1e5),
        ("fringes", one_line([1.5, 0.0], [1.9, 0.0]), 2e4),
        ("fringe comb", comb([1.5, 0.0], [1.9, 0.0]), 2e4),
    ] {
        for (side, cos_theta) in [
            (Side::Ambient, 1.0),
            (Side::Ambient, 0.3),
            (Side::Base, 0.9),
        ] {
            let media = [flat(1.0), layer.clone(), flat(1.52)];
            compare(name, media, side, cos_theta, thickness_nm);
        }
    }
}

/// A table that ascends by steps, and one with the greatest number of entries that a film may have.
#[test]
fn steps_and_dense_tables_are_seen() {
    let steps: Table = (0..40u8)
        .flat_map(|i| {
            let nm = 380.0 + 10.0 * f64::from(i);
            let index = Complex::new(1.5 + 0.02 * f64::from(i % 7), 0.0);
            [(nm + 1e-3, index), (nm + 10.0, index)]
        })
        .collect();
    let dense: Table = (0..=4090u16)
        .map(|i| {
            let nm = 379.99 + f64::from(i) * 0.0978;
            let noise = (f64::from(i) * 0.618_034).fract() - 0.5;
            (nm, Complex::new(1.6 + 0.4 * noise, 0.1 + 0.1 * noise))
        })
        .collect();
    for (name, layer) in [("steps", steps), ("dense", dense)] {
        for thickness_nm in [80.0, 1000.0] {
            let media = [flat(1.0), layer.clone(), flat(1.52)];
            let samples = compare(name, media, Side::Ambient, 0.8, thickness_nm);
            assert!(samples < 100_000, "{name} {samples}");
        }
    }
}

/// Measurements of a smooth curve, as most tables are, cost no more than some times what its formula costs.
#[test]
fn tables_of_smooth_curves_stay_cheap() {
    let smooth = |step: f64| -> Table {
        let count = (410.0 / step) as usize;
        let rows = (0..=count).map(|i| {
            let nm = 375.3 + i as f64 * step;
            (
                nm,
                Complex::new(1.5 + 1e4 / (nm * nm), 1e-3 * (nm / 100.0).sin().abs()),
            )
        });
        rows.collect()
    };
    for (step, thickness_nm, allowed) in [
        (20.0, 300.0, 2000),
        (5.0, 300.0, 2000),
        (1.0, 300.0, 4000),
        (20.0, 3000.0, 4000),
    ] {
        let media = [flat(1.0), smooth(step), flat(1.52)];
        let samples = compare("smooth", media, Side::Ambient, 0.7, thickness_nm);
        assert!(samples <= allowed, "{step} {samples}");
    }
}
