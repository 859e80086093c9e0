#!/usr/bin/python3
"""Write microfacet.csv: D, G, V, F and the complete lobe from vectors and from scalars, by 60-digit arithmetic.

usage: make_golden.py > microfacet.csv
Needs python3-mpmath. Inputs are exact doubles printed with 17 digits, so every reader starts from the same numbers.
"""
import random
from mpmath import mp, mpf, sqrt, pi

mp.dps = 60
rng = random.Random(20240601)


def show(x):
    return repr(float(x)) if isinstance(x, float) else mp.nstr(x, 20)


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


def main():
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


main()
