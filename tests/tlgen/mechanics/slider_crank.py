"""Slider-crank engine by joints: the wrist pin on its line, the rod's mass centre on the chord between the pins."""
from mpmath import mpf, sin, cos, sqrt

n = 1
r, l, off, share = mpf(0.045), mpf(0.14), mpf(0.004), mpf(0.3)
m1, m2, m3 = mpf(0.9), mpf(0.55), mpf(0.48)
J, g = mpf(0.0011), mpf(9.81)
points = [
    ([0.9], [120.0], 0.0),
    ([2.6], [-35.0], 0.0),
    ([4.9], [5.0], 0.0),
]


def piston(th):
    return r * cos(th) + sqrt((l - r * sin(th) + off) * (l + r * sin(th) - off))


def piston_slope(th):
    # The rod is rigid: (pin - wrist) . (v_pin - v_wrist) = 0 at unit rate.
    dx, dy = r * cos(th) - piston(th), r * sin(th) - off
    return (dx * -r * sin(th) + dy * r * cos(th)) / dx


def lagrangian(q, qd, t):
    th, w = q[0], qd[0]
    pin, pin_v = (r * cos(th), r * sin(th)), (-r * sin(th) * w, r * cos(th) * w)
    wrist, wrist_v = (piston(th), off), (piston_slope(th) * w, mpf(0))
    com_y = pin[1] + share * (wrist[1] - pin[1])
    com_v = [a + share * (b - a) for a, b in zip(pin_v, wrist_v)]
    rod_rate2 = sum((b - a) ** 2 for a, b in zip(pin_v, wrist_v)) / l ** 2
    kinetic = m1 * mpf(4e-4) * w ** 2 + (m2 * (com_v[0] ** 2 + com_v[1] ** 2) + J * rod_rate2 + m3 * wrist_v[0] ** 2) / 2
    return kinetic - g * (m2 * com_y + m3 * off)


def force(q, qd, t):
    s = (piston(q[0]) - mpf(0.14)) * 10
    gas = mpf(3200) + mpf(1100) * s - mpf(450) * s ** 2 + mpf(90) * s ** 3
    return [-gas * piston_slope(q[0]) - mpf(0.02) * qd[0]]
