#!/usr/bin/env python3
"""Coefficients of src/mechanics/elliptic_integrals-inl.hpp and contact_ellipse-inl.hpp, and their largest errors.

Needs mpmath only. Least squares in the relative error, weights sharpened towards the largest errors (Lawson), 50 digits.
The singular part of a complete elliptic integral at m1 = 1 - m -> 0 is a power series times ln m1 [AS64 17.3.26], so
  f(m1) = P(m1) - ln(m1) Q(m1)
with the constant terms fixed to the exact limits, so that the fit holds down to the smallest m1.
"""
from mpmath import cos, ellipe, ellipk, exp, findroot, log, matrix, mp, mpf, nstr, pi

mp.dps = 50


def integrals(m1):
    m = 1 - m1
    if m < mpf(10) ** -12:
        return pi / 4 + pi / 32 * m, pi / 4 + 3 * pi / 32 * m, pi / 16 + 9 * pi / 128 * m
    k, e = ellipk(m), ellipe(m)
    b, d = (e - m1 * k) / m, (k - e) / m
    return b, d, (d - b) / m


def least_squares(rows, values, rounds):
    weights = [mpf(1)] * len(rows)
    best = None
    for _ in range(rounds):
        n = len(rows[0])
        normal, right = matrix(n, n), matrix(n, 1)
        for row, value, weight in zip(rows, values, weights):
            for i in range(n):
                for j in range(n):
                    normal[i, j] += weight * row[i] * row[j]
                right[i] += weight * row[i] * value
        solution = mp.lu_solve(normal, right)
        errors = [abs(sum(row[i] * solution[i] for i in range(n)) - value) for row, value in zip(rows, values)]
        worst = max(errors)
        if best is None or worst < best[0]:
            best = worst, [solution[i] for i in range(n)]
        weights = [w * (e / worst + mpf("0.05")) for w, e in zip(weights, errors)]
        total = sum(weights)
        weights = [w / total for w in weights]
    return best


def fit_integral(which, p0, q0, degree, rounds=6):
    nodes = [(1 - cos(pi * (j + mpf(1) / 2) / 90)) / 2 for j in range(90)] + [mpf(1)]
    rows, values = [], []
    for m1 in nodes:
        target, minus_log = integrals(m1)[which], -log(m1)
        powers = [m1**i for i in range(1, degree + 1)]
        rows.append([x / target for x in powers + [minus_log * p for p in powers]])
        values.append((target - p0 - q0 * minus_log) / target)
    worst, c = least_squares(rows, values, rounds)
    return worst, [p0] + c[:degree], [q0] + c[degree:]


def quotient_by_complement(c):
    """(f(x) - f(1)) / (1 - x) of the polynomial with coefficients c in x: what is lost where x -> 1 is split off."""
    return [-sum(c[j + 1:]) for j in range(len(c) - 1)]


def axis_ratio(t):
    """ln(b/a) where R_i/R_j = exp(t)."""
    def residual(x):
        b, d, _ = integrals(exp(2 * x))
        return 2 * x + log(d / b) + t
    return findroot(residual, -t * mpf("0.6"))


def fit_start(t_max, pole, degree, rounds=8):
    count = 120
    u_max = t_max / (t_max + pole)
    rows, values, nodes = [], [], []
    for j in range(count):
        u = u_max * (1 - cos(pi * (j + mpf(1) / 2) / count)) / 2
        t = pole * u / (1 - u)
        scale = t
        rows.append([scale * u**i for i in range(degree + 1)])
        values.append(axis_ratio(t))
        nodes.append(t)
    return least_squares(rows, values, rounds)


def show(name, coefficients):
    print(name + " = {" + ", ".join(repr(float(c)) for c in coefficients) + "};")


if __name__ == "__main__":
    worst, p, q = fit_integral(0, mpf(1), mpf(0), 10)
    print("// B: largest relative error", nstr(worst, 3))
    show("B, powers of m1", p)
    show("B, powers of m1 times -ln m1", q)
    worst, p, q = fit_integral(2, log(4) - 2, mpf(1) / 2, 11)
    print("// C: largest relative error", nstr(worst, 3))
    show("(C - pi/16) / m, powers of m1", quotient_by_complement(p))
    show("C, powers of m1 times -ln m1", q)
    worst, c = fit_start(log(mpf(10) ** 12), mpf(8), 12)
    print("// ln(b/a) / ln(R_i/R_j), powers of u = t / (t + 8), t = ln(R_i/R_j): largest error of ln(b/a)", nstr(worst, 3))
    show("start", c)
