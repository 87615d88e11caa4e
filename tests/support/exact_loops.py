#!/usr/bin/env python3
"""An exact-integer model of the firmware's PI, Clarke, Park, trigonometry and circle limitation.

It knows nothing of the C++ it checks: it is written from the published rules (shifts round
towards minus infinity, which is what Python's >> does; every cut is stated below) and prints vectors, one a line:

  T angle | cosine sine                       C a b | alpha beta
  P alpha beta cosine sine | q d              R q d cosine sine | alpha beta
  L q d max | q d
  N kp ki kpShift kiShift                     a new controller, integral 0, limits as the shift gives them
  I lower upper      limits of the integral   O lower upper      limits of the output
  V integral         written                  H shift            written to KI_DIV: limits of the integral anew
  E error | out integral                      one step

Seeded, so every run prints the same.
"""

import math
import random
import sys
from fractions import Fraction

PI = Fraction(314159265358979323846264338327950288419716939937510, 10**50)
EDGES = [-32768, -32767, -32766, -16385, -16384, -1, 0, 1, 2, 16383, 16384, 18918, 32766, 32767]
GENERATOR = random.Random(20261121)
LINES = []


def say(*values):
    LINES.append(" ".join(map(str, values)))


def bits(count):
    """A signed number of that many bits."""
    return GENERATOR.getrandbits(count) - (1 << (count - 1))


def cut(value, lower, upper):
    return lower if value < lower else upper if value > upper else value


def digits(value):
    """What a transform gives: never -32768."""
    return cut(value, -32767, 32767)


def word(value):
    return cut(value, -(2**31), 2**31 - 1)


# ---- angles --------------------------------------------------------------------------------------------------------


def exact_sine(x):
    term = total = x
    for n in range(1, 20):
        term = -term * x * x / (2 * n * (2 * n + 1))
        total += term
    return total


def rounded(value):
    """To nearest, halves up."""
    return math.floor(value + Fraction(1, 2))


QUARTER = [min(32767, rounded(32768 * exact_sine(PI / 2 * i / 256))) for i in range(257)]


def quarter_sine(angle):
    """Of 0..16384: a straight line between table values, to nearest, halves up."""
    index, rest = divmod(angle, 64)
    if rest == 0:
        return QUARTER[index]
    return rounded(QUARTER[index] + Fraction((QUARTER[index + 1] - QUARTER[index]) * rest, 64))


def sine(angle):
    angle %= 65536
    if angle >= 32768:
        return -sine(angle - 32768)
    return quarter_sine(angle if angle <= 16384 else 32768 - angle)


def cosine(angle):
    return sine(angle + 16384)


# ---- transforms ----------------------------------------------------------------------------------------------------

INVERSE_ROOT_3 = math.isqrt(32768 * 32768 // 3)  # 32768 / sqrt(3), cut: 18918


def clarke(a, b):
    return a, digits((-INVERSE_ROOT_3 * a - INVERSE_ROOT_3 * b - INVERSE_ROOT_3 * b) >> 15)


def park(alpha, beta, c, s):
    return digits((alpha * c - beta * s) >> 15), digits((alpha * s + beta * c) >> 15)


def reverse_park(q, d, c, s):
    return digits((q * c + d * s) >> 15), digits((d * c - q * s) >> 15)


def circle(q, d, most):
    """d first, up to 95 % of the modulus; q gets what is left, and both keep their signs."""
    if q * q + d * d <= most * most:
        return q, d
    most_d = most * 950 // 1000
    new_d = cut(d, -most_d, most_d)
    new_q = math.isqrt(most * most - new_d * new_d)
    return (-new_q if q < 0 else new_q), new_d


def transforms():
    for angle in range(-32768, 32768):
        say("T", angle, cosine(angle), sine(angle))
    for a in EDGES:
        for b in EDGES:
            say("C", a, b, *clarke(a, b))
            for c in EDGES[1:]:
                for s in EDGES[1:]:
                    say("P", a, b, c, s, *park(a, b, c, s))
            say("R", a, b, 32767, 32767, *reverse_park(a, b, 32767, 32767))
            for most in (0, 1, 20000, 32767):
                say("L", a, b, most, *circle(a, b, most))
    for _ in range(100000):
        a, b = bits(16), bits(16)
        say("C", a, b, *clarke(a, b))
        angle = bits(16)
        c, s = cosine(angle), sine(angle)
        say("P", a, b, c, s, *park(a, b, c, s))
    for _ in range(30000):
        a, b, angle = bits(16), bits(16), bits(16)
        c, s = cosine(angle), sine(angle)
        say("R", a, b, c, s, *reverse_park(a, b, c, s))
        most = GENERATOR.getrandbits(15)
        say("L", a, b, most, *circle(a, b, most))


# ---- the controller ------------------------------------------------------------------------------------------------


class Controller:
    def __init__(self, kp, ki, kp_shift, ki_shift):
        say("N", kp, ki, kp_shift, ki_shift)
        self.kp, self.ki, self.kp_shift = kp, ki, kp_shift
        self.integral = 0
        self.output = (-32767, 32767)
        self.shift_for(ki_shift)

    def shift_for(self, ki_shift):
        self.ki_shift = ki_shift
        most = word(32767 << ki_shift)
        self.integral_limits = (-most, most)

    def write_shift(self, ki_shift):
        say("H", ki_shift)
        self.shift_for(ki_shift)

    def write_integral(self, integral):
        say("V", integral)
        self.integral = integral

    def limit_integral(self, lower, upper):
        say("I", lower, upper)
        self.integral_limits = (lower, upper)

    def limit_output(self, lower, upper):
        say("O", lower, upper)
        self.output = (lower, upper)

    def step(self, error):
        proportional = word(self.kp * error)
        if self.ki == 0:
            self.integral = 0
        else:
            total = word(self.integral + word(self.ki * error))
            self.integral = cut(total, *self.integral_limits)
        wanted = (proportional >> self.kp_shift) + (self.integral >> self.ki_shift)
        out = cut(wanted, *self.output)
        self.integral = word(self.integral + out - wanted)
        say("E", error, out, self.integral)
        return out


def controllers():
    errors = [*EDGES, 65535, -65535, -65536, 2**31 - 1, -(2**31)]
    for kp in (-32768, -1, 0, 1, 4621, 32767):
        for ki in (-32768, 0, 1, 2696, 32767):
            for shifts in ((0, 0), (10, 14), (15, 16), (31, 31)):
                controller = Controller(kp, ki, *shifts)
                for error in errors:
                    controller.step(error)
    for _ in range(400):
        controller = Controller(bits(16), bits(16), GENERATOR.getrandbits(4), GENERATOR.getrandbits(4))
        size = GENERATOR.getrandbits(4) + 2
        for step in range(250):
            change = GENERATOR.getrandbits(7)
            if change == 0:
                controller.write_shift(GENERATOR.getrandbits(5))
            elif change == 1:
                controller.write_integral(bits(32))
            elif change == 2:
                most = GENERATOR.getrandbits(15)
                controller.limit_output(-most, GENERATOR.getrandbits(15))
            elif change == 3:
                most = GENERATOR.getrandbits(31)
                controller.limit_integral(-most, GENERATOR.getrandbits(31))
            controller.step(bits(size) + (1 << (size - 2)) * (step // 64 % 3 - 1))


transforms()
controllers()
sys.stdout.write("\n".join(LINES) + "\n")
