"""Prints tests/data/tmm_vectors.csv, for tests/optics/vectors.rs and tests/films/amplitudes.rs: R, T and complex
amplitudes of layer stacks by the package tmm 0.2.0 (S. Byrnes), and colours from those with the CIE 1931 1 nm table.

    python3 -m venv tmmenv && tmmenv/bin/pip install tmm==0.2.0 numpy
    tmmenv/bin/python tests/data/tmm_vectors.py > tests/data/tmm_vectors.csv

Nothing here shares code or tables with the library, but for the two named media, whose Chebyshev
coefficients are read from src/optics/media.rs.
"""

import contextlib
import pathlib
import re
import sys

import numpy as np
from tmm import coh_tmm

HERE = pathlib.Path(__file__).parent


def quarter_wave(pairs):
    return [(2.35, 525 / 4 / 2.35), (1.46, 525 / 4 / 1.46)] * pairs


# name, ambient, layers (index, nm), base
STACKS = [
    ("glass", 1.0, [], 1.5),
    ("soap", 1.0, [(1.33, 300.0)], 1.0),
    ("coating", 1.0, [(1.38, 99.6)], 1.52),
    ("titania on titanium", 1.0, [(2.4, 60.0)], 2.9 + 3.1j),
    ("absorbing film", 1.0, [(2.5 + 0.8j, 80.0)], 1.5),
    ("thin gold", 1.0, [(0.3 + 2.5j, 20.0)], 1.5),
    ("thick gold", 1.0, [(0.3 + 2.5j, 5000.0)], 1.5),
    ("perfect metal", 1.0, [(1.5, 200.0)], 1.0 + 1000.0j),
    ("dense ambient", 1.5, [(1.0, 250.0)], 1.5),
    ("dense ambient on metal", 1.5, [(1.33, 150.0)], 0.05 + 3.7j),
    ("surface plasmon", 1.515, [(0.06 + 3.6j, 48.0)], 1.0),
    ("mirror", 1.0, quarter_wave(8), 1.52),
    ("cavity", 1.0, quarter_wave(4) + [(1.46, 525 / 2 / 1.46)] + quarter_wave(4)[::-1], 1.52),
    ("lossy mix", 1.0, [(1.45, 100.0), (0.2 + 3.3j, 15.0), (2.1 + 0.01j, 200.0)], 4.1 + 0.05j),
    ("64 layers", 1.0, [(1.4 + 0.01 * (i % 7) + (0.002j if i % 5 == 0 else 0), 40.0 + 3 * (i % 11)) for i in range(64)], 1.7),
    ("thick soap", 1.0, [(1.33, 100000.0)], 1.0),
]
COSINES = [1.0, 0.7, 0.3, 0.05, 0.002]
WAVELENGTHS = [400.0, 645.0]


def solved(stack, cosine, nm, from_base=False):
    """tmm's results for s and p."""
    _, ambient, layers, base = stack
    n = [ambient] + [index for index, _ in layers] + [base]
    d = [np.inf] + [thickness for _, thickness in layers] + [np.inf]
    if from_base:
        n, d = n[::-1], d[::-1]
    with contextlib.redirect_stdout(sys.stderr):  # tmm prints a warning about opaque layers
        return [coh_tmm(pol, n, d, np.arccos(cosine), nm) for pol in "sp"]


def response(*arguments):
    found = solved(*arguments)
    return [result[key] for key in "RT" for result in found]


def print_vectors():
    print("# by tests/data/tmm_vectors.py")
    print("# stack, side, wavelength (nm), cosine, R of s, R of p, T of s, T of p")
    for stack in STACKS:
        for nm in WAVELENGTHS:
            for cosine in COSINES:
                numbers = ",".join(f"{x:.15e}" for x in response(stack, cosine, nm))
                print(f"{stack[0]},ambient,{nm},{cosine},{numbers}")
    for stack in STACKS:
        if np.imag(stack[3]) == 0:
            for cosine in COSINES[1:4]:
                numbers = ",".join(f"{x:.15e}" for x in response(stack, cosine, 500.0, True))
                print(f"{stack[0]},base,500.0,{cosine},{numbers}")


def print_amplitudes():
    print("# amplitudes: stack, side, wavelength (nm), cosine, real and imaginary part of r_s, r_p, t_s, t_p")
    for stack in STACKS:
        for from_base in [False] + [True] * (np.imag(stack[3]) == 0):
            for cosine in COSINES[:4]:
                found = solved(stack, cosine, 500.0, from_base)
                numbers = [part for key in "rt" for result in found for part in (result[key].real, result[key].imag)]
                numbers = ",".join(f"{x:.15e}" for x in numbers)
                print(f"{stack[0]},{'base' if from_base else 'ambient'},500.0,{cosine},{numbers}")


def chebyshev(name, quantity, nm):
    """A series of the table of media; numpy evaluates it."""
    text = (HERE / "../../src/optics/media.rs").read_text()
    part = text[text.index(f'fitted("{name}"'):].split("),\n    ")[0]
    lists = re.findall(r"&\[([^\]]*)\]", part)[1:]  # the first has other names
    numbers = [float(x) for x in lists["eta k".split().index(quantity)].split(",") if x.strip()]
    return np.polynomial.chebyshev.chebval((nm - 580) / 200, numbers) if numbers else 0.0


def named(name):
    return lambda nm: chebyshev(name, "eta", nm) + 1j * chebyshev(name, "k", nm)


# name, layers (index of nm, thickness), base, cosine
COLORS = [
    ("bare gold", [], named("Au"), 1.0),
    ("soap", [(lambda nm: 1.33, 400.0)], lambda nm: 1.0, 0.8),
    ("soap at a grazing angle", [(lambda nm: 1.33, 400.0)], lambda nm: 1.0, 0.02),
    ("silica on silicon", [(named("SiO2"), 250.0)], named("Si"), 0.9),
    ("titania on titanium", [(named("TiO2"), 80.0)], named("Ti"), 0.5),
    ("thick lacquer on aluminium", [(lambda nm: 1.5, 3000.0)], named("Al"), 0.7),
]
REC709 = np.array([[3.2404542, -1.5371385, -0.4985314],
                   [-0.9692660, 1.8760108, 0.0415560],
                   [0.0556434, -0.2040259, 1.0572252]])  # B. Lindbloom's matrix, for D65


def print_colors():
    print("# stack, white, cosine, red, green, blue of R (linear Rec.709)")
    table = np.loadtxt(HERE / "cie1931_2deg_d65_1nm.csv", delimiter=",", skiprows=2)
    step = 0.0625
    nm = np.arange(380, 780 + step / 2, step)
    x, y, z, d65 = [np.interp(nm, table[:, 0], table[:, i]) for i in range(1, 5)]
    ends = np.where((nm == 380) | (nm == 780), 0.5, 1.0)
    for name, layers, base, cosine in COLORS:
        spectrum = []
        for wavelength in nm:
            stack = (name, 1.0, [(n(wavelength), d) for n, d in layers], base(wavelength))
            spectrum.append(np.mean(response(stack, cosine, wavelength)[:2]))
        spectrum = np.array(spectrum)
        for white, power in [("E", np.ones_like(nm)), ("D65", d65)]:
            weights = REC709 @ np.array([x, y, z]) * power * ends
            rgb = weights @ spectrum / weights.sum(axis=1)
            print(f"{name},{white},{cosine},{','.join(f'{c:.9f}' for c in rgb)}")


print_vectors()
print_amplitudes()
print_colors()
