#!/usr/bin/python3
"""Write golden values by 80-digit arithmetic: microfacet.csv, D, G, V, F and the complete lobe from vectors; terms.csv, every D, G and F
from scalars.

usage: make_golden.py microfacet > microfacet.csv
       make_golden.py terms > terms.csv
Needs python3-mpmath. Inputs are exact doubles printed with 17 digits, so every reader starts from the same numbers.
"""
import random
import sys
from mpmath import mp, mpf, mpc, sqrt, pi, exp, erf, acos

mp.dps = 80
rng = random.Random(20240601)


def show(x):
    if isinstance(x, float):
        return repr(float(x))
    if 0 < x < mpf(2) ** -1075:
        return "0"
    return "inf" if x > mpf(2) ** 1024 else mp.nstr(x, 20)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit():
    while True:
        v = [rng.uniform(-1, 1) for _ in range(3)]
        s = dot(v, v)
        if 0.05 < s < 1:
            return [x / s**0.5 for x in v]


def rounded_unit(v):
    v = [mpf(x) for x in v]
    s = sqrt(dot(v, v))
    return [float(x / s) for x in v]


def ggx(n, l, v, alpha, f0):
    n, l, v = [[mpf(x) for x in w] for w in (n, l, v)]
    alpha, f0 = mpf(alpha), mpf(f0)
    nl, nv = dot(n, l), dot(n, v)
    if nl <= 0 or nv <= 0:
        return [mpf(0)] * 5
    s = [a + b for a, b in zip(l, v)]
    x, ns = cross(n, s), dot(n, s)
    t2 = dot(x, x) / ns**2
    d = (1 + t2) ** 2 * alpha**2 / (pi * (alpha**2 + t2) ** 2)
    tan2 = lambda w: dot(cross(n, w), cross(n, w)) / dot(n, w) ** 2
    g1 = lambda w: 2 / (1 + sqrt(1 + alpha**2 * tan2(w)))
    g = g1(l) * g1(v)
    f = f0 + (1 - f0) * (1 - min(mpf(1), sqrt(dot(s, s)) / 2)) ** 5
    return [d, g, g / (4 * nl * nv), f, nl * d * g * f / (4 * nl * nv)]


def microfacet():
    print("# GGX, Smith, Schlick from unit vectors away from the surface; lobe = n.l D G F / (4 n.l n.v); zeros below the surface.")
    print("class,nx,ny,nz,lx,ly,lz,vx,vy,vz,alpha,f0,D,G,V,F,lobe")
    for kind in ["random", "lobe", "grazing", "below"]:
        for _ in range(40):
            n, v = unit(), unit()
            if dot(n, v) < 0:
                n = [-x for x in n]
            alpha = rng.choice([1.5, 1.0, 0.5, 0.3, 0.1, 0.01, 1e-3, 1e-5])
            l = unit()
            if kind == "grazing":
                side = cross(n, unit())
                v = rounded_unit([a + 10.0 ** rng.uniform(-6, -2) * b for a, b in zip(side, n)])
            if kind in ("lobe", "grazing"):
                mirror = [2 * dot(n, v) * a - b for a, b in zip(n, v)]
                l = rounded_unit([a + alpha * rng.uniform(-1, 1) * b for a, b in zip(mirror, unit())])
            if (dot(n, l) < 0) != (kind == "below"):
                l = rounded_unit([a - 2 * dot(n, l) * b for a, b in zip(l, n)])
            f0 = rng.choice([0.0, 0.04, 0.2, 0.9, 1.0])
            print(",".join([kind] + [repr(x) for x in [*n, *l, *v, alpha, f0]] + [show(x) for x in ggx(n, l, v, alpha, f0)]))



def distribution(name, alpha, c):
    t2 = (1 - c * c) / (c * c)
    if name == "blinn":
        return c ** (2 / alpha**2 - 2) / (pi * alpha**2)
    if name == "blinn-inverse-roughness":
        return c ** (1 / sqrt(alpha)) / (pi * alpha**2)
    if name == "beckmann":
        return exp(-t2 / alpha**2) / (pi * alpha**2 * c**4)
    if name == "ggx":
        return alpha**2 / (pi * (c * c * (alpha**2 + t2)) ** 2)
    return exp(-((acos(c) / alpha) ** 2))


def masking(name, alpha, nl, nv, nh, vh):
    if name == "none":
        return mpf(1)
    if name == "cook-torrance":
        return min(mpf(1), 2 * nh * nv / vh, 2 * nh * nl / vh)

    def one_plus_lambda(c):
        tan = sqrt(1 - c * c) / c
        if tan == 0:
            return mpf(1)
        if name.startswith("ggx"):
            return (1 + sqrt(1 + (alpha * tan) ** 2)) / 2
        a = 1 / (alpha * tan)
        if name == "beckmann-rational":
            return (1 + mpf("2.276") * a + mpf("2.577") * a * a) / (mpf("3.535") * a + mpf("2.181") * a * a) if a < mpf("1.6") else mpf(1)
        return (1 + erf(a) + exp(-a * a) / (a * sqrt(pi))) / 2

    if name.endswith("-hc"):
        return 1 / (one_plus_lambda(nl) + one_plus_lambda(nv) - 1)
    return 1 / (one_plus_lambda(nl) * one_plus_lambda(nv))


def exact_fresnel(index, c):
    if index == 1:
        return mpf(0)
    root = sqrt(index**2 - (1 - c * c))
    if isinstance(index, mpf) and index**2 < 1 - c * c:
        return mpf(1)
    r_s, r_p = (c - root) / (c + root), (index**2 * c - root) / (index**2 * c + root)
    return (abs(r_s) ** 2 + abs(r_p) ** 2) / 2


def fresnel(name, eta, k, c):
    exact = lambda c: exact_fresnel(mpc(eta, k) if k else eta, c)
    f0 = ((eta - 1) ** 2 + k**2) / ((eta + 1) ** 2 + k**2)
    schlick = lambda c: f0 + (1 - f0) * (1 - c) ** 5
    if name == "one":
        return mpf(1)
    if name == "constant":
        return f0
    if name == "schlick":
        return schlick(c)
    if name == "schlick-linear":
        return f0 + (1 - f0) * (1 - c)
    if name == "schlick-f82":
        s = mpf(1) / 7
        b = (schlick(s) - exact(s)) / (s * (1 - s) ** 6)
        return min(mpf(1), max(mpf(0), schlick(c) - b * c * (1 - c) ** 6))
    return exact_fresnel(eta, c) if name == "dielectric" else exact(c)


def terms():
    print("# Every D of n.h, G and V = G / (4 n.l n.v) of four cosines, F of c = v.h and the index eta + i k. Values beyond a double are 0 or inf.")
    print("term,name,alpha,nl,nv,nh,vh,eta,k,value,V")
    pick = lambda *choices: [float(rng.choice(c)) for c in choices]
    row = lambda term, name, inputs, values: print(",".join([term, name] + [repr(x) for x in inputs] + [show(x) for x in values]))
    alphas = [1e-100, 1e-8, 1e-6, 1e-4, 0.01, 0.1, 0.3, 0.5, 0.9, 1, 1.5, 3, 1e3, 1e100]
    one_less = 1 - 2.0**-53
    for name in ["blinn", "blinn-inverse-roughness", "beckmann", "ggx", "gaussian"]:
        for i in range(60):
            alpha, nh = pick(alphas, [1, one_less, 1 - 1e-12, 0.999999, 0.99, 0.8, 0.5, 0.1, 1e-3, 1e-8, 1e-16, 1e-100])
            if i % 2:  # on the flank of the lobe
                alpha = 10.0 ** rng.uniform(-7, 0.3 if i % 4 == 1 else 20)
                nh = float(1 / sqrt(1 + (mpf(alpha) * rng.uniform(0, 5)) ** 2))
            row("D", name, [alpha, 0.0, 0.0, nh, 0.0, 0.0, 0.0], [distribution(name, mpf(alpha), mpf(nh)), mpf(0)])
    cosines = [1, one_less, 0.999, 0.7, 0.3, 0.01, 1e-6, 1e-12, 1e-100]
    for name in ["cook-torrance", "ggx", "ggx-hc", "beckmann", "beckmann-hc", "beckmann-rational", "none"]:
        for i in range(60):
            alpha, nl, nv, nh, vh = pick(alphas, cosines, cosines, cosines[:-1], cosines[:-1])
            if i % 2:
                alpha, nl, nv, nh, vh = [rng.uniform(0.01, 1) for _ in range(5)]
            g = masking(name, *[mpf(x) for x in (alpha, nl, nv, nh, vh)])
            row("G", name, [alpha, nl, nv, nh, vh, 0.0, 0.0], [g, g / (4 * mpf(nl) * mpf(nv))])
    etas = [1e-9, 0.3, 0.5, 0.75, 1 - 1e-6, 1, 1 + 1e-9, 1.0001, 1.5, 4, 1e6, 1e150]
    for name in ["one", "constant", "schlick", "schlick-linear", "schlick-f82", "dielectric", "conductor"]:
        for i in range(60):
            c, eta, k = pick([1, one_less, 0.9, 0.5, 1 / 7, 0.1, 1e-4, 1e-12, 1e-100, 0], etas, [0, 1e-12, 1e-3, 1, 4, 1e6])
            if i % 2:
                c, eta, k = rng.random(), 10.0 ** rng.uniform(-1, 1), rng.choice([0.0, 10.0 ** rng.uniform(-3, 1)])
            if name == "dielectric":
                k = 0.0
            row("F", name, [0.0, 0.0, 0.0, 0.0, c, eta, k], [fresnel(name, mpf(eta), mpf(k), mpf(c)), mpf(0)])


if sys.argv[1:] not in (["microfacet"], ["terms"]):
    sys.exit(__doc__)
microfacet() if sys.argv[1] == "microfacet" else terms()
