/* A rigid body hung at a point off its centre of mass, attitude as a quaternion (w, x, y, z) from body to world.
 * Small value types and functions that return them: the way of a C++ programmer who was told to use C. */
#include <math.h>

typedef struct Vec3 { double x, y, z; } Vec3;
typedef struct Quat { double w; Vec3 v; } Quat;

typedef struct RigidBody {
  double mass;
  Vec3 inertia; /* principal, about the fixed point */
  Vec3 centre;  /* of mass, in the body */
} RigidBody;

static const RigidBody body = { .mass = 1.3, .inertia = { 0.21, 0.34, 0.12 }, .centre = { 0.05, -0.02, 0.3 } };
static const Vec3 gravity = { 0.0, 0.0, -9.81 };

static inline Vec3 vec3(double x, double y, double z) { Vec3 v = { x, y, z }; return v; }
static inline Vec3 vec3_add(Vec3 a, Vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline Vec3 vec3_scale(Vec3 a, double s) { return vec3(a.x * s, a.y * s, a.z * s); }
static inline double vec3_dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline Vec3 vec3_cross(Vec3 a, Vec3 b) { return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }

static inline Quat quat_from(const double *c) { Quat q = { c[0], { c[1], c[2], c[3] } }; return q; }
static inline Quat quat_conj(Quat q) { q.v = vec3_scale(q.v, -1.0); return q; }

static Quat quat_mul(Quat a, Quat b)
{
  Quat r;
  r.w = a.w * b.w - vec3_dot(a.v, b.v);
  r.v = vec3_add(vec3_cross(a.v, b.v), vec3_add(vec3_scale(b.v, a.w), vec3_scale(a.v, b.w)));
  return r;
}

/* q p q* */
static Vec3 quat_rotate(Quat q, Vec3 p)
{
  Quat pure = { 0.0, p };
  return quat_mul(quat_mul(q, pure), quat_conj(q)).v;
}

/* omega = 2 q* dq/dt, in the body */
static Vec3 body_rate(Quat q, Quat qdot) { return vec3_scale(quat_mul(quat_conj(q), qdot).v, 2.0); }

double quaternion_body(const double q[4], const double qd[4])
{
  Quat attitude = quat_from(q);
  Vec3 w = body_rate(attitude, quat_from(qd));
  Vec3 h = vec3(body.inertia.x * w.x, body.inertia.y * w.y, body.inertia.z * w.z);

  return 0.5 * vec3_dot(w, h) + body.mass * vec3_dot(gravity, quat_rotate(attitude, body.centre));
}

double quaternion_norm(const double q[4])
{
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
    sum += q[i] * q[i];
  return sum - 1.0;
}
