#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes values.inc: values of every golden model by another way than the model's own.

The formulas stand here as the documents print them and are worked in exact fractions where they are rational, else in
60 digits (mpmath); integrals by Gauss-Legendre over pieces, or over the outgoing ray's own angles. Nothing is shared
with the C++ side but the documents. Not part of the build:  python3 values.py > values.inc
"""
import math
from fractions import Fraction as Q

from mpmath import acos, atan, cos, exp, mp, mpf, nstr, pi, quad, sin, sqrt, tan

mp.dps = 60
ROUNDOFF = mpf(2) ** -53


def fraction(x):
    return Q(x)  # exact, of a float too


def real(x):
    """A number as the double that the C++ side is given, exactly."""
    if isinstance(x, mpf):
        return x
    x = fraction(x)
    return mpf(x.numerator) / x.denominator


def row(model, inputs, value, roundoffs=32, tolerance=None, why=""):
    if isinstance(value, Q):
        if value.denominator < 10**9:
            why = why or str(value)
        value = mpf(value.numerator) / value.denominator
    tolerance = mpf(roundoffs) * ROUNDOFF if tolerance is None else mpf(tolerance)
    columns = ", ".join(repr(float(x)) for x in inputs)
    comment = f"  // {why}" if why else ""
    print(f'{{"{model}", {{{columns}}}, {nstr(value, 20)}, {nstr(tolerance, 3)}}},{comment}')


# --- lobes of (n, cos)

S = 2 * (1 - exp(mpf(-1) / 2))


def inflection(n):
    t = cos(atan(1 / sqrt(n - 1)))  # [P] (9)
    return (t ** (n - 1) - 1) / (t - 1)


def power(c, n):
    return c ** int(n) if n == int(n) else real(c) ** real(n)


def parabola(a, c):
    return a * (c * c - c) + c


def safe_parabola(a, c):
    """Divided by 8 pi times the integral of what is not negative."""
    f = parabola(a, c)
    root = max(mpf(0), 1 - 1 / a)
    area = a / 3 * (1 - root**3) + (1 - a) / 2 * (1 - root**2)
    return max(mpf(0), f) / (8 * pi * area)


def rational_coefficients(n):
    """Through 1 at the peak and cos^n at the levels 0.425856 and 0.050698: two equations for r and s."""
    v, w = mpf("0.425856"), mpf("0.050698")
    y, z = 1 - v ** (1 / n), 1 - w ** (1 / n)
    # v (1 - r y + s y) = 1 - r y, and so for w, z
    a, b, e = y * (1 - v), y * v, 1 - v
    p, q, g = z * (1 - w), z * w, 1 - w
    return (e * q - b * g) / (a * q - b * p), (a * g - e * p) / (a * q - b * p)


def rational(n, c):
    r, s = rational_coefficients(n)
    u = 1 - c
    return max(mpf(0), 1 - r * u) / (1 - r * u + s * u)


LOBES = {
    "blinn": lambda n, c: power(c, n),
    "blinn-normalised": lambda n, c: (real(n) + 6) / (8 * pi) * real(power(c, n)),
    "schlick": lambda n, c: c / (n - n * c + c),
    "schlick-modified": lambda n, c: c / ((n * (1 - c)) ** 2 / 2 + n - n * c + c),
    "schlick-modified-a": lambda n, c: c / (n * (1 - c * c) / 2 + n - n * c + c),
    "schlick-modified-b": lambda n, c: c / (n * (1 - c) ** 2 / 2 + n - n * c + c),
    "schlick-modified-c": lambda n, c: real(c) / (real(n) * (1 - cos(acos(real(c)) ** 2)) / 2 + real(n - n * c + c)),
    "quadratic-exact": lambda n, c: parabola(inflection(real(n)), real(c)),
    "quadratic-published": lambda n, c: parabola(Q(786, 1000) * n + Q(1, 2), c),
    "quadratic-derived": lambda n, c: parabola(S * real(n) - mpf(1) / 2, real(c)),
    "quadratic-energy-safe": lambda n, c: safe_parabola(S * real(n) - mpf(1) / 2, real(c)),
    "cosine-quadratic": lambda n, c: max(Q(0), (n + 1) / 3 * (c - 1) + 1) ** 2,
    "cosine-quadratic-energy": lambda n, c: (n + 6) / Q(2455, 100) * max(Q(0), (n + 1) / 3 * (c - 1) + 1) ** 2,
    "cosine-quadratic-energy-safe":
        lambda n, c: (real(n) + 1) / (8 * pi) * real(max(Q(0), (n + 1) / 3 * (c - 1) + 1) ** 2),
    "lyon-2": lambda n, c: max(Q(0), 1 - n * (1 - c) / 2) ** 2,
    "lyon-4": lambda n, c: max(Q(0), 1 - n * (1 - c) / 4) ** 4,
    "lyon-8": lambda n, c: max(Q(0), 1 - n * (1 - c) / 8) ** 8,
    "gx": lambda n, c: c * c / (n / 2 + (1 - n / 2) * c * c),
    "rational": lambda n, c: rational(real(n), real(c)),
}
# Beside the peak and half way down, where a digit of any constant shows; beyond most roots; and cosines that are not
# dyadic, where a literal form would round.
POINTS = [(2, 0.75), (2, 0.25), (7, 0.875), (7, 0.5), (100, 0.9921875), (100, 0.96875), (1000, 0.9990234375),
          (1000, 0.99609375), (1000, 0.9993), (1000, 0.99907), (1.25, 0.6), (1, 0.3)]


def roundoffs_of(model, n, c):
    """32, and where a factor of the lobe vanishes as much more as it is smaller than its terms."""
    n, c = real(n), real(c)
    terms = {"quadratic": S * n + 1, "cosine": (n + 1) / 3, "lyon-2": n / 2, "lyon-4": n / 4, "lyon-8": n / 8,
             "rational": 2 * n}
    for name, slope in terms.items():
        if model.startswith(name):
            left = abs(1 - (1 - c) / root_distance(model, n))
            power_of = {"cosine": 2, "lyon-2": 2, "lyon-4": 4, "lyon-8": 8}.get(name, 1)
            return int(32 + 8 * power_of * slope * (1 - c) / left) if left > 0 else 32
    return 32


def root_distance(model, n):
    """1 - c at the root of a lobe."""
    if model.startswith("cosine"):
        return 3 / (n + 1)
    if model.startswith("lyon"):
        return mpf(model[-1]) / n
    if model == "rational":
        return 1 / rational_coefficients(n)[0]
    if model == "quadratic-published":
        return 1 / (mpf("0.786") * n + mpf("0.5"))
    return 1 / (S * n - mpf(1) / 2) if model != "quadratic-exact" or n == 1 else 1 / inflection(n)


def lobes():
    for model, f in LOBES.items():
        for n, c in POINTS:
            if model == "quadratic-exact" and n == 1:
                value = fraction(c)  # a(1) = 0
            else:
                value = f(fraction(n), fraction(c))
            row(model, (n, c), value, roundoffs_of(model, n, c))
        row(model, (1000, 1.0), value_at_peak(model), 16)
    # c^n leaves the normal numbers, its product with (n + 6)/(8 pi) does not.
    for c in (0.4906315, 0.4906585, 0.49063):
        row("blinn-normalised", (1000, c), 1006 / (8 * pi) * real(c) ** 1000, 10)
    # n c rounds by 512 roundoffs at the worst: where the denominators' literal forms are off most.
    for n, c in ((1000, 0.99931), (997, 0.998771), (1000, 0.99713)):
        for model in ("schlick", "schlick-modified", "schlick-modified-a", "schlick-modified-b",
                      "schlick-modified-c", "gx"):
            row(model, (n, c), LOBES[model](fraction(n), fraction(c)), 27)


def value_at_peak(model):
    n = mpf(1000)
    return {"blinn-normalised": (n + 6) / (8 * pi), "cosine-quadratic-energy": (n + 6) / mpf("24.55"),
            "cosine-quadratic-energy-safe": (n + 1) / (8 * pi),
            "quadratic-energy-safe": safe_parabola(S * n - mpf(1) / 2, mpf(1))}.get(model, mpf(1))


def other_lobes():
    for n, a, c in ((2, 1.5, 0.75), (7, 3.0, 0.875), (100, 80.25, 0.9921875), (1000, 700.0, 0.99931)):
        row("schlick-modified-e", (n, a, c), real(c) ** real(a) / (real(n) - real(n) * real(c) + real(c)))
    for n in (1.0 + 2.0**-40, 1.0625, 1.5, 2, 7, 100, 999.5, 1000):
        row("coefficient-exact", (n,), inflection(real(n)), 15)
    row("coefficient-exact", (1,), Q(0))
    for n in (1, 2, 7, 100, 1000):
        row("coefficient-published", (n,), Q(786, 1000) * n + Q(1, 2), 4)
        row("coefficient-derived", (n,), S * n - mpf(1) / 2, 8 if n > 1 else 24)


# --- the angle-based lobe

def scale(n, k, q):
    return acos(q ** (1 / k)) / acos(q ** (1 / n))


def moment(k, a):
    """Integral of cos^k(y) sin(a y) over [0, pi/2]. Lifted by parts to a power that is smooth at pi/2:
    J(k) = (a + ((k + 2)^2 - a^2) J(k + 2)) / ((k + 2)(k + 1)).   Gauss-Legendre there."""
    steps = 0
    while k + 2 * steps < 60:
        steps += 1
    top = k + 2 * steps
    width = 1 / sqrt(top)
    pieces = [mpf(0)] + [min(pi / 2, width * i) for i in range(1, 40)] + [pi / 2]
    pieces = sorted(set(pieces))
    j = quad(lambda y: cos(y) ** top * sin(a * y), pieces, method="gauss-legendre")
    for step in range(steps, 0, -1):
        up = k + 2 * step
        j = (a + (up**2 - a**2) * j) / (up * (up - 1))
    return j


def angle():
    for n, k, q, x in ((2, 1, 0.5, 0.5), (7, 2, 0.25, 0.375), (7, 1.5, 0.5, 0.75), (100, 3, 0.5, 0.125),
                       (1000, 5, 0.125, 0.0625), (1000, 5, 0.125, 0.09375), (2, 1000, 0.5, 0.25),
                       (7, 1.5, 0.5, 0.7731001648120168), (1000, 999, 0.5, 0.0009), (1000, 1000, 0.3, 0.013), (30, 700.5, 0.9, 0.0517), (100, 1, 0.5, 1.5)):
        rn, rk, rq, rx = map(real, (n, k, q, x))
        y = scale(rn, rk, rq) * rx
        value = cos(y) ** rk if y < pi / 2 else mpf(0)
        condition = rk * y * tan(y) if value else 0
        row("angle", (n, k, q, x), value, int(24 * condition) + 6)
    grid = [(1, 1.5, 0.5)] + [(n, k, q) for n in (2, 7, 100, 1000) for k, q in
                              ((1, 0.5), (1.0625, 0.9), (1.5, 0.1), (2.75, 0.25), (5, 0.75), (100.5, 0.5), (999, 0.9))]
    for n, k, q in grid:
        rn, rk, rq = map(real, (n, k, q))
        a = scale(rn, rk, rq)
        integral = moment(rk, 2 / a) / (2 * a)
        row("angle-limit", (n, k, q), pi / 2 / a, 20)
        row("angle-integral", (n, k, q), integral, 64)
        row("angle-coef-exact", (n, k, q), 1 / (2 * pi * integral), 64)
        # Up to 90 degrees, where the lobe does not end before.
        moment_to_end = moment(rk, 1 / a) if a >= 1 else quad(lambda y: cos(y) ** rk * sin(y / a),
                                                              [i * a * pi / 128 for i in range(65)])
        row("angle-coef-safe", (n, k, q), a / (8 * pi * moment_to_end), 64)
    for n, k, q in ((2, 1, 0.125), (7, 2, 0.375), (100, 3, 0.25), (1000, 5, 0.4), (1000, 1.5, 0.1)):
        q0 = fraction(q)
        value = (Q(608, 1000) * n * (q0 - Q(193, 1000)) / (2 * q0 + 2 * fraction(k)) + Q(161, 1000) * n
                 + Q(284, 1000))
        row("angle-coef-fitted", (n, k, q), value)
    for n, k, q in ((2, 1, 0.5), (7, 2, 0.625), (100, 3, 0.75), (1000, 5, 0.875), (1000, 1.5, 0.9)):
        q0, k0 = fraction(q), fraction(k)
        value = (Q(743, 1000) * q0 * (Q(167, 1000) * n - Q(133, 10000) * k0 * n) / k0 + Q(167, 1000) * n
                 + Q(245, 1000))
        row("angle-coef-fitted", (n, k, q), value)
    # [A] fig. 4 as printed, Q = 0.5 and k = 1: three decimals.
    for n, printed in ((1, "0.477"), (50, "11.227"), (200, "44.312"), (1000, "220.765")):
        row("angle-coef-exact", (n, 1, 0.5), mpf(printed), tolerance=mpf("0.0005001") / mpf(printed),
            why="printed in [A] fig. 4")


# --- lighting

def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = sqrt(dot(a, a))
    return [x / length for x in a]


def positive(x):
    return x if x > 0 else mpf(0)


def scenes():
    yield (0, 0, 1), (0.6, 0, 0.8), (-0.6, 0, 0.8)
    yield (0, 0, 2), (1, 2, 2), (-2, 1, 2)
    yield (1, 1, 2), (0, 2, 1), (2, 1, 3)
    yield (0.1, -0.2, 1), (0.3, 0.4, 1.2), (0, 0.5, 3)
    yield (0, 0, 1), (1, 0, 0.25), (1, 0.125, 0.5)   # masked
    yield (0, 0, 1), (1, 0, 0), (-0.6, 0, 0.8)       # grazing light, a viewer near its mirror direction
    yield (0, 0, 1), (0.6, 0, 0.8), (-1, 0, 0)       # a grazing viewer
    yield (0, 0, 1), (0, 1, 3), (0.5, 0, -1)         # a viewer behind the surface
    yield (0, 0, 1), (0, 1, -3), (0.5, 0, 1)         # light behind it


def fresnel(index, c):
    g = sqrt(index**2 + c**2 - 1)
    return ((g - c) / (g + c)) ** 2 * (1 + ((c * (g + c) - 1) / (c * (g - c) + 1)) ** 2) / 2


def facets(kind, m, c):
    a = acos(c)
    if kind == "gaussian":
        return exp(-((a / m) ** 2))
    return exp(-((tan(a) / m) ** 2)) / (m**2 * cos(a) ** 4)


def cosines(normal, light, view):
    h = unit([a + b for a, b in zip(light, view)])
    return dot(normal, h), dot(view, h), dot(normal, light), dot(normal, view)


def cook_torrance(kind, m, index, normal, light, view):
    nh, vh, nl, nv = cosines(normal, light, view)
    if nl <= 0 or nv <= 0:
        return mpf(0)
    return fresnel(index, vh) * facets(kind, m, nh) * min(mpf(1), 2 * nh * nv / vh, 2 * nh * nl / vh) / nv


def lighting():
    for vectors in scenes():
        columns = [x for v in vectors for x in v]
        normal, light, view = (unit([real(x) for x in v]) for v in vectors)
        nh, vh, nl, nv = cosines(normal, light, view)
        mirror = [2 * nl * a - b for a, b in zip(normal, light)]
        rv = positive(dot(mirror, view))
        seen = nl > 0 and nv > 0
        if rv > mpf("1e-20"):
            row("mirror-cosine", columns, rv, int(64 / rv))
        row("half-vector-cosine", columns, positive(nh), 32)
        base = mpf(2) * mpf("0.25") + 3 * mpf("0.5") * positive(nl)
        row("lambert", [2, 3, 0.25, 0.5] + columns[:6], base)
        for n in (2, 7, 100, 1000):
            light_of = [n, 2, 3, 0.25, 0.5, 0.75] + columns
            high = 16 * n + 32
            row("phong", light_of, base + (3 * mpf("0.75") * rv**n if seen else 0), high)
            row("blinn-shading", light_of, base + (3 * mpf("0.75") * nh**n if seen else 0), high)
        for kind in ("gaussian", "beckmann"):
            for m, index in ((0.5, 1.5), (0.25, 3.0)):
                value = cook_torrance(kind, real(m), real(index), normal, light, view)
                row(f"cook-torrance-{kind}", [m, index] + columns, value, 4096)
                row(f"cook-torrance-{kind}-mixed", [0.75, m, index] + columns,
                    mpf("0.75") * value + mpf("0.25") * positive(nl), 4096)
    for index, c in ((1.5, 1.0), (1.5, 0.0), (1.5, 0.5), (3.0, 0.875), (1.0009765625, 0.0625), (1.0009765625, 0.999)):
        row("fresnel", (index, c), fresnel(real(index), real(c)), 64)
    for m, c in ((0.5, 0.875), (0.25, 0.9375), (1.0, 0.5), (0.0625, 0.9918533333333334), (0.0625, 0.9939066666666666), (0.1, 1.0)):
        for kind in ("gaussian", "beckmann"):
            exponent = (acos(real(c)) / real(m)) ** 2
            row(f"facets-{kind}", (m, c), facets(kind, real(m), real(c)), int(16 * exponent) + 24)
    # The exponential leaves the normal numbers, the quotient by m^2 does not.
    for c in (0.9996568920584737, 0.9996570063816551):
        row("facets-beckmann", (2.0**-10, c), facets("beckmann", real(2.0**-10), real(c)), 8 * 720)
    for nh, vh, nl, nv in ((0.5, 0.75, 0.25, 0.875), (0.5, 0.75, 0.875, 0.25), (0.9375, 0.5, 0.75, 0.625),
                           (0.3125, 0.875, 0.5, 2.0**-1060), (0.3, 0.9, 2.0**-1070, 0.7)):
        a, b, c, d = map(real, (nh, vh, nl, nv))
        row("shadowing", (nh, vh, nl, nv), min(mpf(1), 2 * a * d / b, 2 * a * c / b) / d, 8)
        if nv > 1e-9 and nl > 1e-9:
            for kind in ("gaussian", "beckmann"):
                value = fresnel(mpf("1.5"), b) * facets(kind, mpf("0.5"), a) * min(mpf(1), 2 * a * d / b, 2 * a * c / b) / d
                row(f"cook-torrance-{kind}-cosines", (0.5, 1.5, nh, vh, nl, nv), value, 512)


def shifts():
    def reciprocal(k, steps):
        places = 2**steps
        return Q(int(Q(places, k) + Q(1, 2)), places)

    for k, steps in ((7, 6), (7, 8), (3, 8), (1, 8), (2, 5), (16, 8), (1000, 12), (2**31, 31), (6, 2), (65535, 31)):
        row("reciprocal-shifts", (k, steps), reciprocal(k, steps), 1)
    for difference, k, steps in ((255, 7, 6), (-255, 7, 8), (200.5, 13, 8), (17, 1, 4)):
        row("shift-division", (difference, k, steps), Q(difference) * reciprocal(k, steps), 1)


# --- reflectance

QUADRATURE = "1e-9"


def normal_incidence(f, breaks, mirror):
    """2 pi integral f(c) c dc, or with c = cos(theta/2) that of the outgoing ray theta."""
    low = mpf(0) if mirror else sqrt(mpf(1) / 2)
    pieces = sorted({low, mpf(1)} | {b for b in breaks if low < b < 1} | {1 - (1 - low) / 2**i for i in range(1, 12)})
    weight = (lambda c: 2 * pi * c) if mirror else (lambda c: 8 * pi * c * (2 * c * c - 1))
    return quad(lambda c: f(c) * weight(c), pieces, method="gauss-legendre")


def breaks_of(model, n):
    if model.startswith(("cosine", "lyon", "rational", "quadratic")):
        return [1 - root_distance(model, mpf(n))]
    return []


def as_real(model, n):
    f = LOBES[model]
    if model in ("blinn-normalised", "cosine-quadratic-energy-safe"):
        inner = {"blinn-normalised": lambda c: (mpf(n) + 6) / (8 * pi) * c**n,
                 "cosine-quadratic-energy-safe":
                     lambda c: (mpf(n) + 1) / (8 * pi) * positive((mpf(n) + 1) / 3 * (c - 1) + 1) ** 2}[model]
        return inner
    if model == "schlick-modified-c":
        return lambda c: c / (mpf(n) * (1 - cos(acos(c) ** 2)) / 2 + n - n * c + c)
    if model == "quadratic-published":
        return lambda c: positive(parabola(mpf("0.786") * n + mpf("0.5"), c))
    if model == "quadratic-exact":
        return lambda c: positive(parabola(inflection(mpf(n)), c))
    if model == "quadratic-derived":
        return lambda c: positive(parabola(S * n - mpf(1) / 2, c))
    if model == "quadratic-energy-safe":
        return lambda c: safe_parabola(S * n - mpf(1) / 2, c)
    if model == "rational":
        return lambda c: rational(mpf(n), c)
    if model.startswith(("cosine", "lyon")):
        return {"cosine-quadratic": lambda c: positive((mpf(n) + 1) / 3 * (c - 1) + 1) ** 2,
                "cosine-quadratic-energy":
                    lambda c: (mpf(n) + 6) / mpf("24.55") * positive((mpf(n) + 1) / 3 * (c - 1) + 1) ** 2,
                "lyon-2": lambda c: positive(1 - n * (1 - c) / 2) ** 2,
                "lyon-4": lambda c: positive(1 - n * (1 - c) / 4) ** 4,
                "lyon-8": lambda c: positive(1 - n * (1 - c) / 8) ** 8}[model]
    return lambda c: f(mpf(n), c) if model != "blinn" else c**n


def oblique(n, degrees, mirror):
    """R of c^n by midpoints over both angles of the outgoing ray, in double; their error is about (pi/2/steps)^2."""
    steps = 800
    si, ci = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    azimuths = [math.cos((j + 0.5) / steps * math.pi) * si for j in range(steps)]
    total = 0.0
    for i in range(steps):
        theta = (i + 0.5) / steps * math.pi / 2
        s, c = math.sin(theta), math.cos(theta)
        if mirror:
            ring = sum(max(0.0, s * a + c * ci) ** n for a in azimuths)
        else:
            ring = sum(((c + ci) / math.sqrt(2 + 2 * (c * ci - s * a))) ** n for a in azimuths)
        total += ring * c * s
    return total * math.pi / steps * math.pi / 2 / steps * 2


def reflectances():
    mp.dps = 30
    for model in LOBES:
        for n in (2, 7, 100, 1000):
            f = as_real(model, n)
            row(f"{model}-reflectance", (n, 0), normal_incidence(f, breaks_of(model, n), False), tolerance=QUADRATURE)
            row(f"{model}-reflectance-mirror", (n, 0), normal_incidence(f, breaks_of(model, n), True),
                tolerance=QUADRATURE)
    for degrees in (30, 60, 80):
        for n in (2, 7):
            row("blinn-reflectance", (n, degrees), oblique(n, degrees, False), tolerance="1e-5")
            row("blinn-reflectance-mirror", (n, degrees), oblique(n, degrees, True), tolerance="1e-5")
    for n, k, q in ((7, 1.5, 0.5), (100, 3, 0.25), (2, 5, 0.5)):
        rn, rk, rq = map(real, (n, k, q))
        a = scale(rn, rk, rq)
        end = min(pi / 2, pi / 2 / a)
        pieces = [end * (1 - mpf(2) ** -i) for i in range(30)] + [end]
        mirror = quad(lambda x: 2 * pi * cos(a * x) ** rk * cos(x) * sin(x), pieces, method="gauss-legendre")
        row("angle-reflectance-mirror", (n, k, q, 0), mirror, tolerance=QUADRATURE)
        end = min(pi / 4, pi / 2 / a)
        pieces = [end * (1 - mpf(2) ** -i) for i in range(30)] + [end]
        half = quad(lambda x: 8 * pi * cos(a * x) ** rk * cos(x) * sin(x) * cos(2 * x), pieces,
                    method="gauss-legendre")
        row("angle-reflectance", (n, k, q, 0), half, tolerance=QUADRATURE)
    for kind in ("gaussian", "beckmann"):
        for m in (0.25, 0.5):
            # L = N: nl = 1, nv = cos(theta), nh = vh = cos(theta/2); F D G/(N.V) cos(theta), G = 1 up to where
            # 2 nv = 1 and then 2 nv.
            def ring(t, m=m, kind=kind):
                c = cos(t / 2)
                return 2 * pi * sin(t) * fresnel(mpf("1.5"), c) * facets(kind, real(m), c) * min(1, 2 * cos(t))
            pieces = [pi / 3 * mpf(i) / 8 for i in range(9)] + [pi / 3 + pi / 6 * mpf(i) / 4 for i in range(1, 5)]
            row(f"cook-torrance-{kind}-reflectance", (m, 1.5, 0), quad(ring, pieces, method="gauss-legendre"),
                tolerance="1e-6")


print("// Generated by values.py; do not edit.   {model, {inputs}, value, largest relative error}")
lobes()
other_lobes()
angle()
lighting()
shifts()
reflectances()
