/* Scenes of things that roll and glide: constraints on velocities that no constraint on coordinates replaces. */
#include "chaplygin_sleigh.h"
#include "chaplygin_sleigh_tl.h"
#include "knife_edge.h"
#include "knife_edge_tl.h"
#include "rolling_disk.h"
#include "rolling_disk_tl.h"
#include "scene.h"
#include "snakeboard.h"
#include "snakeboard_tl.h"

#include <math.h>

/* ---- rolling disk: with a lean of l, a yaw rate of W and the rate about the axle w = spin rate + W sin l, the torque of gravity and
 * of the contact's force keep up the turning of the angular momentum, m r^2/4 W cos l across the axle and m r^2/2 w along it, where 3/2
 * r W w = tan l (r W^2/4 cos l - g);  the contact then runs in a circle of radius r spin/W. */

static const rolling_disk disk = {.mass = 1.5, .radius = 0.35, .gravity = 9.81};
static const double lean = 0.4, yaw_rate = 1.5;

static double disk_spin(void) {
  const double along = tan(lean) * (0.25 * disk.radius * yaw_rate * yaw_rate * cos(lean) - disk.gravity);
  return along / (1.5 * disk.radius * yaw_rate) - yaw_rate * sin(lean);
}

static void disk_begin(scene_start *s) {
  s->params = &disk;
  s->q[3] = lean;
  s->qd[2] = yaw_rate;
  s->qd[4] = disk_spin();
  s->qd[0] = disk.radius * s->qd[4];
}

static void disk_measure(const double *y, double *value) { value[0] = y[0], value[1] = y[1], value[2] = y[3]; }

static void disk_truth(double t, double *value) {
  const double radius = disk.radius * disk_spin() / yaw_rate;
  value[0] = radius * sin(yaw_rate * t);
  value[1] = radius * (1.0 - cos(yaw_rate * t));
  value[2] = lean;
}

const scene scene_disk = {.name = "disk",
                          .about = "disk that rolls in a circle, leaning",
                          .model = &rolling_disk_model,
                          .begin = disk_begin,
                          .duration = 20.0,
                          .quick = 2.0,
                          .outputs = 200,
                          .method = "dop853",
                          .tolerance = 1e-12,
                          .measured = "place of the contact, lean",
                          .values = 3,
                          .measure = disk_measure,
                          .truth = disk_truth,
                          .floor = 1.0,
                          .required = 1e-9,
                          .energy = 1e-9};

/* ---- knife edge on a slope, set spinning at w from rest: it does not slide down but across, on a cycloid, with c = g sin(slope)/(2
 * w^2) x = -c sin^2 wt,  y = -c (wt - sin wt cos wt). */

static const struct knife_edge knife = {.mass = 2.0, .inertia = 0.3, .gravity = 9.81, .slope = 0.6};
static const double knife_rate = 1.7;

static void knife_begin(scene_start *s) {
  s->params = &knife;
  s->qd[2] = knife_rate;
}

static void knife_measure(const double *y, double *value) { value[0] = y[0], value[1] = y[1]; }

static void knife_truth(double t, double *value) {
  const double c = knife.gravity * sin(knife.slope) / (2.0 * knife_rate * knife_rate), angle = knife_rate * t;
  value[0] = -c * sin(angle) * sin(angle);
  value[1] = -c * (angle - sin(angle) * cos(angle));
}

const scene scene_knife = {.name = "knife",
                           .about = "knife edge on a slope: it drifts across, on a cycloid",
                           .model = &knife_edge_model,
                           .begin = knife_begin,
                           .duration = 100.0,
                           .quick = 10.0,
                           .outputs = 1000,
                           .method = "dop853",
                           .tolerance = 1e-12,
                           .measured = "place of the blade",
                           .values = 2,
                           .measure = knife_measure,
                           .truth = knife_truth,
                           .floor = 1.0,
                           .required = 1e-9,
                           .energy = 1e-9};

/* ---- Chaplygin's sleigh, pushed off backwards: u' = a w^2 and (I + m a^2) w' = -m a u w give, with E = m U^2/2 = (I + m a^2) w_m^2/2,
 *   u = U tanh(x), w = w_m sech(x), x = x_0 + k t, k = a w_m^2/U;  heading = w_m/k (gd(x) - gd(x_0)), gd(x) = 2 atan(tanh(x/2)). */

static const chaplygin_sleigh sleigh = {.mass = 2.0, .inertia = 0.15, .ahead = 0.25};
static const double sleigh_speed = -1.5, sleigh_rate = 0.01;

static void sleigh_begin(scene_start *s) {
  s->params = &sleigh;
  s->qd[0] = sleigh_speed;
  s->qd[2] = sleigh_rate;
}

static void sleigh_measure(const double *y, double *value) {
  value[0] = y[3] * cos(y[2]) + y[4] * sin(y[2]);
  value[1] = y[5];
  value[2] = y[2];
}

static double gudermann(double x) { return 2.0 * atan(tanh(0.5 * x)); }

static void sleigh_truth(double t, double *value) {
  const double ratio = sleigh.inertia / sleigh.mass + sleigh.ahead * sleigh.ahead;
  const double U = sqrt(sleigh_speed * sleigh_speed + ratio * sleigh_rate * sleigh_rate), most = U / sqrt(ratio);
  const double k = sleigh.ahead * most * most / U, x0 = -asinh(-sleigh_speed / (sleigh_rate * sqrt(ratio))), x = x0 + k * t;
  value[0] = U * tanh(x);
  value[1] = most / cosh(x);
  value[2] = most / k * (gudermann(x) - gudermann(x0));
}

const scene scene_sleigh = {.name = "sleigh",
                            .about = "Chaplygin's sleigh pushed off backwards: it turns round by itself",
                            .model = &chaplygin_sleigh_model,
                            .begin = sleigh_begin,
                            .duration = 10.0,
                            .quick = 4.0,
                            .outputs = 200,
                            .method = "dop853",
                            .tolerance = 1e-12,
                            .measured = "speed, rate, heading",
                            .values = 3,
                            .measure = sleigh_measure,
                            .truth = sleigh_truth,
                            .floor = 1.0,
                            .required = 1e-9,
                            .energy = 1e-9};

/* ---- snakeboard: with the front steered by f and the back by -f it moves ahead at v and turns at v tan(f)/l; along that motion
 *   d(P v)/dt = -(J_rotor/l) tan(f) rotor'' / P,  P^2 = m + (J_board + J_rotor + 2 J_axle) (tan(f)/l)^2.
 * Over each period f returns to zero and v grows by the same amount; the integral of a periodic function is the mean of its values. */

static const snakeboard snake = {.mass = 6.0,
                                 .board = 0.016,
                                 .rotor = 0.072,
                                 .axle = 0.0013,
                                 .half_length = 0.2,
                                 .rotor_swing = 0.7,
                                 .steering = 0.5,
                                 .rate = 6.283185307179586476925}; /* one period per second */
static const double snake_speed = 0.1;

static void snake_begin(scene_start *s) {
  s->params = &snake;
  s->qd[0] = snake_speed;
  s->qd[3] = snake.rotor_swing * snake.rate;
  s->qd[4] = -snake.steering * snake.rate;
  s->qd[5] = snake.steering * snake.rate;
}

static void snake_measure(const double *y, double *value) { value[0] = y[6] * cos(y[2]) + y[7] * sin(y[2]); }

/* After t periods. */
static void snake_truth(double t, double *value) {
  const int points = 256; /* a periodic function: more do not change a digit */
  const double turning = snake.board + snake.rotor + 2.0 * snake.axle;
  double mean = 0.0;
  for (int i = 0; i < points; i++) {
    const double s = sin(snake.rate * i / points), bend = tan(snake.steering * s) / snake.half_length;
    mean += snake.rotor * bend * snake.rotor_swing * snake.rate * snake.rate * s / sqrt(snake.mass + turning * bend * bend) / points;
  }
  value[0] = snake_speed + t * mean / sqrt(snake.mass);
}

const scene scene_snakeboard = {.name = "snakeboard",
                                .about = "snakeboard driven by its rotor: constraints on coordinates, on velocities and on time",
                                .model = &snakeboard_model,
                                .begin = snake_begin,
                                .duration = 20.0,
                                .quick = 2.0,
                                .outputs = 20,
                                .method = "dop853",
                                .tolerance = 1e-12,
                                .measured = "speed after whole periods",
                                .values = 1,
                                .measure = snake_measure,
                                .truth = snake_truth,
                                .floor = 1.0,
                                .required = 1e-9};
