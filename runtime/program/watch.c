/* eom watch: the motion as a moving picture, an SVG file that moves by itself or a GIF. */
#include "command.h"
#include "drawing.h"
#include "files.h"
#include "host/gnuplot.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OWN_OPTIONS = 8, BAR = 4 /* pixels */, FINER = 4 /* points of a trail from frame to frame */ };

static const double most_frames = 20000.0, margin = 24.0 /* pixels */;

static const char *const colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#555555"};
enum { COLOURS = sizeof colours / sizeof colours[0] };

typedef struct command {
  setup s;
  method how;
  double t_end, speed, rate;
  int size;
  bool still;
  option_texts lines;
  const char *svg, *gif;
  char own_name[128];
} command;

static void read_command(command *c, int argc, char **argv) {
  char whole[8192];
  option table[SETUP_OPTIONS + METHOD_OPTIONS + OWN_OPTIONS];
  const option own[] = {
      setup_t_end(&c->t_end, "time at the end, s; default 10"),
      {.name = "--line",
       .kind = OPTION_TEXTS,
       .value = &c->lines,
       .operand = "POINTS",
       .help = "one more line, as below; may be repeated"},
      {.name = "--speed",
       .kind = OPTION_ABOVE,
       .value = &c->speed,
       .most = HUGE_VAL,
       .operand = "V",
       .help = "seconds of the motion in a second of the picture; default 1"},
      {.name = "--rate",
       .kind = OPTION_ABOVE,
       .value = &c->rate,
       .most = 100.0,
       .operand = "F",
       .help = "frames in a second of the picture; default 25"},
      {.name = "--size",
       .kind = OPTION_COUNT,
       .value = &c->size,
       .least = 100,
       .most = 4000,
       .operand = "PIXELS",
       .help = "the longer side of the picture; default 600"},
      {.name = "--no-trail", .kind = OPTION_FLAG, .value = &c->still, .help = "do not draw the way of each line's last point"},
      {.name = "--svg", .kind = OPTION_TEXT, .value = &c->svg, .operand = "FILE", .help = "default MODEL.svg, unless there is a --gif"},
      {.name = "--gif", .kind = OPTION_TEXT, .value = &c->gif, .operand = "FILE", .help = "the same as a GIF (needs gnuplot)"},
  };
  setup_options(&c->s, table);
  method_options(&c->how, table + SETUP_OPTIONS);
  memcpy(table + SETUP_OPTIONS + METHOD_OPTIONS, own, sizeof own);
  snprintf(whole, sizeof whole,
           "Draws the motion: an SVG file that moves by itself in any browser, with no script in it, or a GIF.\n\n%s\n%s\nMethods\n%s\n"
           "Exit status: 0 done, 1 the motion or the picture failed, 2 wrong options, 130 Ctrl-C.\n",
           drawing_help, setup_help, method_list());
  const manual text = {
      .command = "watch",
      .operands = "MODEL.so ",
      .summary = whole,
      .examples = "  eom watch pendulum.so --start double.txt --t-end 20\n"
                  "  eom watch kepler.so --q 1,0 --qd 0,1.2 --t-end 30 --speed 5 --line '0,0' --line 'q[0],q[1]' --gif orbit.gif\n",
  };
  setup_read(&c->s, argc, argv, table, (int)(sizeof table / sizeof table[0]), &text);
}

/* ---- frames ---- */

/* The points of all lines in all frames, and the box that holds them. */
typedef struct film {
  const command *c;
  const drawing *what;
  long frames;
  int points[SETUP_MOST_LINES]; /* of each line, the same in all frames */
  int first[SETUP_MOST_LINES];  /* of each line in a frame */
  int all;
  double *xy;    /* frames x all x 2 */
  long steps;    /* of trails: FINER from frame to frame */
  double *trail; /* steps x lines x 2: the last points */
  double left, right, bottom, top;
  double scale;      /* pixels per unit */
  int width, height; /* pixels */
} film;

static const double *trail(const film *f, long step, int line) { return f->trail + 2 * (step * f->what->lines + line); }
static const double *point(const film *f, long frame, int line, int i) { return f->xy + 2 * (frame * f->all + f->first[line] + i); }

static void take_in(film *f, const double *xy, long count) {
  for (long i = 0; i < count; i++) {
    const double x = xy[2 * i], y = xy[2 * i + 1];
    f->left = fmin(f->left, x), f->right = fmax(f->right, x), f->bottom = fmin(f->bottom, y), f->top = fmax(f->top, y);
  }
}

/* A box around all points, at least a little wide and high, and the picture that shows it with equal scales. */
static void frame_box(film *f) {
  f->left = f->bottom = HUGE_VAL, f->right = f->top = -HUGE_VAL;
  take_in(f, f->xy, f->frames * f->all);
  take_in(f, f->trail, f->steps * f->what->lines);
  const double most = fmax(fmax(f->right - f->left, f->top - f->bottom), 1e-9), least = 0.2 * most;
  if (f->right - f->left < least) f->left -= least / 2, f->right += least / 2;
  if (f->top - f->bottom < least) f->bottom -= least / 2, f->top += least / 2;
  f->scale = (f->c->size - 2.0 * margin) / fmax(f->right - f->left, f->top - f->bottom);
  f->width = (int)lround(f->scale * (f->right - f->left)) + (int)(2.0 * margin);
  f->height = (int)lround(f->scale * (f->top - f->bottom)) + (int)(2.0 * margin);
}

/* Says so where a point of line i is not a number. */
static int check_points(const film *f, int i, double t, const double *xy) {
  for (int k = 0; k < f->points[i]; k++)
    if (!isfinite(xy[2 * k]) || !isfinite(xy[2 * k + 1]))
      return complain("point %d of line %d (both counted from 1) is not a number at t = %g s", k + 1, i + 1, t), -1;
  return 0;
}

static int shoot(film *f, const motion *m) {
  static double xy[2 * DRAWING_MOST_POINTS];
  const series *r = &m->rows;
  const setup *s = &f->c->s;
  const int lines = f->what->lines;
  f->steps = r->count;
  f->frames = (r->count - 1) / FINER + 1;
  for (int i = 0; i < lines; i++) {
    f->first[i] = f->all;
    f->all += f->points[i] = drawing_points(&f->what->line[i], s, r->rows[0], r->rows + 1, xy);
  }
  f->xy = malloc(2 * (size_t)f->frames * (size_t)f->all * sizeof *f->xy);
  f->trail = malloc(2 * (size_t)f->steps * (size_t)lines * sizeof *f->trail);
  if (f->xy == NULL || f->trail == NULL) return complain("not enough memory for the frames"), -1;
  for (long k = 0; k < f->steps; k++)
    for (int i = 0; i < lines; i++) {
      const double *row = r->rows + k * r->width;
      if (drawing_points(&f->what->line[i], s, row[0], row + 1, xy) != f->points[i])
        return complain("a line has not as many points at t = %g s as at the start", row[0]), -1;
      if (check_points(f, i, row[0], xy) != 0) return -1;
      memcpy(f->trail + 2 * (k * lines + i), xy + 2 * (f->points[i] - 1), 2 * sizeof *xy);
      if (k % FINER == 0) memcpy(f->xy + 2 * (k / FINER * f->all + f->first[i]), xy, 2 * (size_t)f->points[i] * sizeof *xy);
    }
  return frame_box(f), 0;
}

/* ---- SVG ---- */

static double pixel_x(const film *f, const double *p) { return margin + f->scale * (p[0] - f->left); }
static double pixel_y(const film *f, const double *p) { return margin + f->scale * (f->top - p[1]); }

static void print_points(FILE *file, const film *f, long frame, int line) {
  for (int i = 0; i < f->points[line]; i++)
    fprintf(file, "%s%.1f,%.1f", i > 0 ? " " : "", pixel_x(f, point(f, frame, line, i)), pixel_y(f, point(f, frame, line, i)));
}

/* An attribute that goes through one value per frame, again and again. */
static void begin_values(FILE *file, const film *f, const char *attribute) {
  fprintf(file, "<animate attributeName=\"%s\" dur=\"%.3fs\" repeatCount=\"indefinite\" values=\"", attribute,
          (double)(f->frames - 1) / f->c->rate);
}

static void print_trail(FILE *file, const film *f, int line) {
  fprintf(file, "<polyline class=\"trail\" stroke=\"%s\" points=\"", colours[line % COLOURS]);
  for (long k = 0; k < f->steps; k++)
    fprintf(file, "%s%.1f,%.1f", k > 0 ? " " : "", pixel_x(f, trail(f, k, line)), pixel_y(f, trail(f, k, line)));
  fputs("\"/>\n", file);
}

static void print_line(FILE *file, const film *f, int line) {
  fprintf(file, "<polyline class=\"line\" stroke=\"%s\" points=\"", colours[line % COLOURS]);
  print_points(file, f, 0, line);
  fputs("\">", file);
  begin_values(file, f, "points");
  for (long k = 0; k < f->frames; k++) {
    if (k > 0) fputc(';', file);
    print_points(file, f, k, line);
  }
  fputs("\"/></polyline>\n", file);
}

static void print_dot(FILE *file, const film *f, int line, int i) {
  const double *p = point(f, 0, line, i);
  fprintf(file, "<circle r=\"5\" fill=\"%s\" cx=\"%.1f\" cy=\"%.1f\">", colours[line % COLOURS], pixel_x(f, p), pixel_y(f, p));
  for (int part = 0; part < 2; part++) {
    begin_values(file, f, part == 0 ? "cx" : "cy");
    for (long k = 0; k < f->frames; k++) {
      p = point(f, k, line, i);
      fprintf(file, "%s%.1f", k > 0 ? ";" : "", part == 0 ? pixel_x(f, p) : pixel_y(f, p));
    }
    fputs("\"/>", file);
  }
  fputs("</circle>\n", file);
}

static int write_svg(const film *f, const char *path) {
  output o;
  if (output_open(&o, path) != 0) return -1;
  FILE *file = o.file;
  fprintf(file,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n<title>Motion of %s, t = %g s "
          "to %g "
          "s</title>\n<style>polyline{fill:none;stroke-linejoin:round;stroke-linecap:round}.line{stroke-width:3}"
          ".trail{stroke-width:1;stroke-opacity:.35}</style>\n<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
          f->width, f->height, f->width, f->height, f->c->s.model.description->model->name, f->c->s.t0, f->c->t_end);
  for (int i = 0; i < f->what->lines && !f->c->still; i++) print_trail(file, f, i);
  for (int i = 0; i < f->what->lines; i++) {
    if (f->points[i] > 1) print_line(file, f, i);
    for (int k = 0; k < f->points[i]; k++) print_dot(file, f, i, k);
  }
  fprintf(file, "<rect y=\"%d\" height=\"%d\" width=\"0\" fill=\"#999999\">", f->height - BAR, BAR);
  begin_values(file, f, "width");
  fprintf(file, "0;%d\"/></rect>\n</svg>\n", f->width);
  return output_commit(&o);
}

/* ---- GIF ---- */

static void print_frame(FILE *script, const film *f, long frame) {
  const char *between = "plot ";
  for (int i = 0; i < f->what->lines && !f->c->still; i++, between = ", ")
    fprintf(script, "%s$trail%d every ::0::%ld using 1:2 with lines linewidth 1 linecolor '#b0b0b0' notitle", between, i,
            FINER * frame);
  for (int i = 0; i < f->what->lines; i++, between = ", ")
    fprintf(script, "%s'-' using 1:2 with linespoints linewidth 3 pointtype 7 pointsize 1.2 linecolor '%s' notitle", between,
            colours[i % COLOURS]);
  fputc('\n', script);
  for (int i = 0; i < f->what->lines; i++) {
    for (int k = 0; k < f->points[i]; k++) fprintf(script, "%.8g %.8g\n", point(f, frame, i, k)[0], point(f, frame, i, k)[1]);
    fputs("e\n", script);
  }
}

static int write_gif(const film *f, const char *path) {
  gnuplot g;
  const double beside = margin / f->scale;
  if (gnuplot_open(&g, path, f->width, f->height) != 0) return -1;
  fprintf(g.script, "set terminal gif animate delay %d loop 0 size %d,%d\n", (int)lround(fmax(1.0, 100.0 / f->c->rate)), f->width,
          f->height);
  for (int i = 0; i < f->what->lines && !f->c->still; i++) {
    fprintf(g.script, "$trail%d << EOD\n", i);
    for (long k = 0; k < f->steps; k++) fprintf(g.script, "%.8g %.8g\n", trail(f, k, i)[0], trail(f, k, i)[1]);
    fputs("EOD\n", g.script);
  }
  fprintf(g.script,
          "unset border\nunset tics\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\nset xrange [%.10g:%.10g]\nset yrange "
          "[%.10g:%.10g]\n",
          f->left - beside, f->right + beside, f->bottom - beside, f->top + beside);
  for (long k = 0; k < f->frames; k++) print_frame(g.script, f, k);
  return gnuplot_close(&g);
}

/* ---- the whole ---- */

static int show(const command *c, const drawing *what, const motion *m) {
  film f = {.c = c, .what = what};
  int status = 0;
  if (m->rows.count <= FINER) return complain("a moving picture needs two frames"), -1;
  if (shoot(&f, m) != 0) status = -1;
  if (status == 0 && c->svg != NULL && write_svg(&f, c->svg) != 0) status = -1;
  if (status == 0 && c->gif != NULL && write_gif(&f, c->gif) != 0) status = -1;
  if (status == 0)
    printf("%ld frames in %s%s%s: open it in a browser\n", f.frames, c->svg != NULL ? c->svg : "",
           c->svg != NULL && c->gif != NULL ? " and " : "", c->gif != NULL ? c->gif : "");
  free(f.xy);
  free(f.trail);
  return status;
}

static int check_times(const command *c) {
  const double way = fabs(c->t_end - c->s.t0);
  if (way == 0.0) return complain("--t-end %g is the time of the start", c->t_end), -1;
  if (method_check_step(c->how.step, c->s.t0, c->t_end) != 0) return -1;
  if (way / c->speed * c->rate > most_frames)
    return complain("that makes more than %g frames; take a higher --speed or a lower --rate", most_frames), -1;
  return 0;
}

static int watch(const command *c, const drawing *what) {
  motion m;
  const motion_request ask = {.s = &c->s, .how = &c->how, .t_end = c->t_end, .every = c->speed / c->rate / (double)FINER};
  if (motion_open(&m, &ask) != 0) return refuse();
  motion_follow(&m);
  int status = m.end == MOTION_FAILED ? EXIT_FAILED : m.end == MOTION_INTERRUPTED ? EXIT_INTERRUPTED : EXIT_DONE;
  if (m.rows.count > 0 && show(c, what, &m) != 0) status = EXIT_FAILED;
  motion_close(&m);
  return status;
}

/* Without an output the picture has the model's name. */
static int name_output(command *c) {
  if (c->svg != NULL || c->gif != NULL) return 0;
  snprintf(c->own_name, sizeof c->own_name, "%s.svg", c->s.model.description->model->name);
  c->svg = c->own_name;
  files_distinct((wanted_files){{{"the default of --svg,", c->svg}}}, &c->s);
  return output_check(c->svg);
}

static int draw(command *c) {
  drawing what;
  if (check_times(c) != 0 || drawing_open(&what, &c->s, &c->lines) != 0) return refuse();
  setup_print(&c->s);
  const int status = name_output(c) == 0 && setup_consistent(&c->s) == 0 ? watch(c, &what) : EXIT_FAILED;
  drawing_close(&what);
  return status;
}

int watch_command(int argc, char **argv) {
  command c = {.how = method_default, .t_end = 10.0, .speed = 1.0, .rate = 25.0, .size = 600};
  read_command(&c, argc, argv);
  const wanted_files wanted = {{{"--svg", c.svg}, {"--gif", c.gif}}};
  method_complete(&c.how);
  files_distinct(wanted, &c.s);
  if (c.gif != NULL && (strlen(c.gif) < 4 || strcmp(c.gif + strlen(c.gif) - 4, ".gif") != 0))
    usage_error("--gif %s: the name must end in .gif", c.gif);
  const eom_options options = method_system_options(&c.how, EOM_NEED_SIMULATE);
  watch_interrupts();
  if (files_possible(wanted) != 0) return EXIT_FAILED;
  if (setup_load(&c.s, c.s.model.path, &options) != 0) return refuse();
  const int status = draw(&c);
  setup_close(&c.s);
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
