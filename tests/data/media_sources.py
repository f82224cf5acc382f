"""Prints the fits of src/optics/media.rs to tabulated optical constants, and the table of docs/media.md that tells how
much published data sets differ: both from the refractiveindex.info data base (CC0), which the package pyElli ships.

    python3 -m venv venv && venv/bin/pip install pyelli==0.23.1 numpy pyyaml
    venv/bin/python tests/data/media_sources.py

Nothing here shares code or tables with the library. Colours are linear Rec.709 under white E, from the CIE 1931 1 nm
table, unclipped.
"""

import importlib.util
import pathlib

import numpy as np
import yaml
from numpy.polynomial import chebyshev

HERE = pathlib.Path(__file__).parent
DATA = pathlib.Path(importlib.util.find_spec("elli").origin).parent / "database/refractiveindexinfo-database/database/data"
NM = np.arange(380.0, 780.5, 0.5)
ITO = "other/mixed crystals/In2O3-SnO2"
# name, page, number of terms of eta and of k
FITS = [("a-TiO2", "main/TiO2/nk/Jolivet-amorphous", 12, 0), ("Ta2O5", "main/Ta2O5/nk/Gao", 9, 5),
        ("Nb2O5", "main/Nb2O5/nk/Lemarchand", 11, 11), ("ZnS", "main/ZnS/nk/Amotchkina", 13, 9),
        ("ITO", f"{ITO}/nk/Konig", 8, 8)]
# name, book, page and what is printed for it; the first is the library's
SETS = [
    ("titanium", "main/Ti", {"Johnson": "Johnson and Christy 1974", "Mash": "Mash and Motulevich 1973",
                             "Rakic-BB": "Rakic 1998 (Brendel-Bormann)", "Palm": "Palm 2018",
                             "Werner": "Werner 2009 (electron energy loss)"}),
    ("gold", "main/Au", {"Johnson": "Johnson and Christy 1972", "Babar": "Babar and Weaver 2015", "McPeak": "McPeak 2015",
                         "Olmon-ev": "Olmon 2012 (evaporated)", "Olmon-sc": "Olmon 2012 (single crystal)",
                         "Rakic-BB": "Rakic 1998 (Brendel-Bormann)", "Yakubovsky-117nm": "Yakubovsky 2017 (117 nm)"}),
    ("silver", "main/Ag", {"Johnson": "Johnson and Christy 1972", "Babar": "Babar and Weaver 2015",
                           "McPeak": "McPeak 2015", "Jiang": "Jiang 2016", "Rakic-BB": "Rakic 1998 (Brendel-Bormann)"}),
    ("copper", "main/Cu", {"Johnson": "Johnson and Christy 1972", "Babar": "Babar and Weaver 2015",
                           "McPeak": "McPeak 2015", "Rakic-BB": "Rakic 1998 (Brendel-Bormann)", "Hagemann": "Hagemann 1975"}),
    ("aluminium", "main/Al", {"Rakic": "Rakic 1995", "McPeak": "McPeak 2015", "Rakic-BB": "Rakic 1998 (Brendel-Bormann)",
                              "Cheng": "Cheng 2016", "Hagemann": "Hagemann 1975"}),
    ("iron", "main/Fe", {"Johnson": "Johnson and Christy 1974", "Querry": "Querry 1985",
                         "Werner": "Werner 2009 (electron energy loss)"}),
    ("TiO2", "main/TiO2", {"Devore-o": "DeVore 1951 (rutile, ordinary ray)",
                           "Jolivet-amorphous": "Jolivet 2023 (amorphous, a-TiO2)", "Siefke": "Siefke 2016 (atomic layers)",
                           "Franta": "Franta 2015 (evaporated, amorphous)", "Sarkar": "Sarkar 2019 (film)"}),
    ("Ta2O5", "main/Ta2O5", {"Gao": "Gao 2012", "Rodriguez-de Marcos": "Rodriguez-de Marcos 2016", "Franta": "Franta 2015"}),
    ("Nb2O5", "main/Nb2O5", {"Lemarchand": "Lemarchand 2013", "Horcholle-400": "Horcholle 2022", "Franta": "Franta 2015"}),
    ("Si3N4", "main/Si3N4", {"Luke": "Luke 2015", "Philipp": "Philipp 1973", "Beliaev": "Beliaev 2022",
                             "Vogt-1": "Vogt 2015 (solar cells, SiNx)"}),
    ("ZnS", "main/ZnS", {"Amotchkina": "Amotchkina 2020 (film)", "Debenham": "Debenham 1984 (crystal)", "Querry": "Querry 1987"}),
    ("ITO", ITO, {"Konig": "König 2014", "Minenkov-glass": "Minenkov 2024", "Moerland": "Moerland 2016"}),
]


def formula(kind, c):
    """refractiveindex.info's dispersion formulas 1, 2 and 4, of the wavelength in micrometres."""
    if kind == "formula 4":
        return lambda x: np.sqrt(c[0] + sum(c[i] * x ** c[i + 1] / (x**2 - c[i + 2] ** c[i + 3]) for i in (1, 5)))
    power = {"formula 1": 2, "formula 2": 1}[kind]
    return lambda x: np.sqrt(1 + c[0] + sum(c[i] * x**2 / (x**2 - c[i + 1] ** power) for i in range(1, len(c), 2)))


def load(page):
    """n and k at NM; a table is constant outside its range, as the library's tables are."""
    n = k = 0 * NM
    for part in yaml.safe_load((DATA / f"{page}.yml").read_text())["DATA"]:
        if part["type"].startswith("tabulated"):
            rows = np.array([[float(x) for x in line.split()] for line in part["data"].strip().split("\n")])
            assert part["type"] == "tabulated k" or rows[0, 0] < 0.41 and rows[-1, 0] > 0.74, page
            columns = [np.interp(NM / 1000, rows[:, 0], column) for column in rows.T[1:]]
            for quantity, column in zip(part["type"].split()[1], columns):
                n, k = (column, k) if quantity == "n" else (n, column)
        else:
            n = formula(part["type"], [float(x) for x in str(part["coefficients"]).split()])(NM / 1000)
    return n, k


def print_fits():
    for name, page, *terms in FITS:
        for quantity, values, count in zip(("eta", "k"), load(page), terms):
            if count:
                series = chebyshev.chebfit((NM - 580) / 200, values, count - 1)
                error = np.abs(chebyshev.chebval((NM - 580) / 200, series) - values).max()
                print(f"{name} {quantity}, greatest error {error:.3g}: [{', '.join(f'{x:.7g}' for x in series)}]")


def color(n, k):
    table = np.loadtxt(HERE / "cie1931_2deg_d65_1nm.csv", delimiter=",", skiprows=2)
    xyz = [np.interp(NM, table[:, 0], table[:, i]) for i in (1, 2, 3)]
    # B. Lindbloom's matrix, for D65
    weights = np.array([[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560],
                        [0.0556434, -0.2040259, 1.0572252]]) @ xyz
    return weights @ (((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2)) / weights.sum(axis=1)


def print_differences():
    print("| medium | data set | F0, white E | difference |\n|---|---|---|---|")
    for name, book, pages in SETS:
        found = [color(*load(f"{book}/nk/{page}")) for page in pages]
        for label, rgb in zip(pages.values(), found):
            difference = np.abs(rgb - found[0]).max()
            difference = f"{difference:.3f}" if rgb is not found[0] else "ours"
            print(f"| {name} | {label} | {' '.join(f'{c:.3f}' for c in rgb)} | {difference} |")


print_fits()
print_differences()
