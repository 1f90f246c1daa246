"""Half-car ride model, each of its springs and dampers written out."""
from mpmath import mpf, sin, cos

n = 4
m, J, mf, mr = map(mpf, (730.0, 1230.0, 40.0, 35.5))
a, b, speed, base, g = map(mpf, (1.011, 1.803, 12.0, 2.814, 9.81))
points = [
    ([-0.08, 0.02, -0.02, -0.01], [0.6, 0.4, 0.9, -0.8], 0.21),   # rear bump stop in, rear damper blows off in rebound
    ([-0.13, -0.03, -0.03, 0.01], [-0.5, 0.2, 0.1, 0.4], 0.64),   # both bump stops in, rear damper blows off in bump
    ([-0.02, 0.01, 0.01, -0.02], [0.1, 0.1, -1.2, -0.1], 1.35),   # no bump stop, rear damper slow
    ([-0.05, 0.015, 0.02, 0.02], [0.2, -0.1, -0.3, 0.6], 0.92),   # both bump stops in, rear damper slow in bump
]


def road(s):
    return mpf(0.03) * sin(mpf(0.9) * s) + mpf(0.01) * cos(mpf(2.3) * s)


def lagrangian(q, qd, t):
    z, th, zf, zr = q
    front, rear = z + a * sin(th) - zf, z - b * sin(th) - zr
    kinetic = (m * qd[0] ** 2 + J * qd[1] ** 2 + mf * qd[2] ** 2 + mr * qd[3] ** 2) / 2
    springs = mpf(18000) * front ** 2 / 2 + mpf(2.0e5) * front ** 4 / 4 + mpf(22000) * rear ** 2 / 2
    stops = mpf(4.0e6) * (max(-front - mpf(0.05), 0) ** 3 + max(-rear - mpf(0.06), 0) ** 3) / 3
    tyres = mpf(1.9e5) * ((zf - road(speed * t)) ** 2 + (zr - road(speed * t - base)) ** 2) / 2
    return kinetic - g * (m * z + mf * zf + mr * zr) - springs - stops - tyres


def blow_off(rate):
    limit, c = mpf(0.4), mpf(1400) if rate > 0 else mpf(0.6) * mpf(1400)
    size = abs(rate)
    return c * (size if size < limit else limit + mpf(0.3) * (size - limit)) * (1 if rate > 0 else -1)


def force(q, qd, t):
    c = cos(q[1])
    front, rear = qd[0] + a * c * qd[1] - qd[2], qd[0] - b * c * qd[1] - qd[3]
    ff, fr = mpf(900) * front + mpf(350) * front ** 3, blow_off(rear)
    return [-ff - fr, -a * c * ff + b * c * fr, ff, fr]
