/* Plots of a page: axes, curves, key and numbers, drawn as SVG. */
#include "host/page.h"
#include "host/page_text.h"

#include <math.h>
#include <stdlib.h>

/* The drawing, in units of which 11 are the height of a letter: about as wide as a phone. */
enum { WIDTH = 400, HEIGHT = 300, LEFT = 56, RIGHT = 14, TOP = 24, BOTTOM = 42, INSET = 7 };
enum { ACROSS = WIDTH - LEFT - RIGHT, DOWN = HEIGHT - TOP - BOTTOM };
enum { COLOURS = 8, MARKERS = 7, MOST_TICKS = 64, MOST_LABELS = 8 };

/* One axis: from values to the drawing. */
typedef struct scale {
  bool log;
  double least, most; /* logarithms of base 10 where log */
  double from, to;    /* where they lie in the drawing */
} scale;

static double of_value(bool log, double x) { return !log ? x : x > 0.0 ? log10(x) : (double)NAN; }

/* NaN where the axis cannot show x. */
static double place(const scale *s, double x) {
  const double u = of_value(s->log, x);
  return isfinite(u) ? s->from + (u - s->least) / (s->most - s->least) * (s->to - s->from) : (double)NAN;
}

static bool inside(const scale *s, double at) {
  const double low = fmin(s->from, s->to) - 0.5, high = fmax(s->from, s->to) + 0.5;
  return at >= low && at <= high;
}

/* ---- what the axes show ---- */

static void include(bool log, const double *x, int count, double *least, double *most) {
  for (int i = 0; x != NULL && i < count; i++) {
    const double u = of_value(log, x[i]);
    if (!isfinite(u)) continue;
    *least = fmin(*least, u);
    *most = fmax(*most, u);
  }
}

/* Points whose other coordinate cannot be shown count as well: a page is not harmed by a wider axis. */
static scale scale_of(const page_plot *plot, const page_axis *axis, bool vertical) {
  scale s = {.log = axis->log, .least = HUGE_VAL, .most = -HUGE_VAL};
  if (axis->least < axis->most) {
    s.least = of_value(s.log, axis->least), s.most = of_value(s.log, axis->most);
  } else {
    for (int i = 0; i < plot->count; i++) {
      const page_series *c = &plot->series[i];
      include(s.log, vertical ? c->y : c->x, c->count, &s.least, &s.most);
      if (vertical) include(s.log, c->low, c->count, &s.least, &s.most), include(s.log, c->high, c->count, &s.least, &s.most);
    }
  }
  if (!(s.least <= s.most) || !isfinite(s.most - s.least)) s.least = 0.0, s.most = 1.0;
  const double room = s.log ? 0.15 : 1e-6 * fmax(fabs(s.least), 1e-300);
  if (s.most - s.least < 2.0 * room) s.least -= room, s.most += room;
  s.from = vertical ? HEIGHT - BOTTOM - INSET : LEFT + INSET;
  s.to = vertical ? TOP + INSET : WIDTH - RIGHT - INSET;
  return s;
}

/* ---- ticks ---- */

/* 1, 2 or 5 times a power of ten, so that a range has at most MOST_LABELS of them. */
static double step_of(double range) {
  const double least = range / (double)MOST_LABELS, decade = pow(10.0, floor(log10(least)));
  for (int i = 0; i < 3; i++)
    if ((double[]){1.0, 2.0, 5.0}[i] * decade >= least) return (double[]){1.0, 2.0, 5.0}[i] * decade;
  return 10.0 * decade;
}

static int even_ticks(double least, double most, double step, double *at) {
  const double slack = 1e-9 * (most - least);
  int count = 0;
  for (double u = step * ceil((least - slack) / step); u <= most + slack && count < MOST_TICKS; u += step) at[count++] = u;
  return count;
}

/* 1, 2 and 5 times the powers of ten. */
static int ticks_of_decades(const scale *s, double *at) {
  const double slack = 1e-9 * (s->most - s->least);
  int count = 0;
  for (double d = floor(s->least); d <= s->most && count + 3 < MOST_TICKS; d += 1.0)
    for (int i = 0; i < 3; i++) {
      const double u = d + log10((double[]){1.0, 2.0, 5.0}[i]);
      if (u >= s->least - slack && u <= s->most + slack) at[count++] = u;
    }
  return count;
}

/* Where ticks stand, in the units of the scale: powers of ten, or in a short range of logarithms numbers between them; even steps
 * elsewhere. Returns how many. */
static int ticks_of(const scale *s, double *at) {
  const double range = s->most - s->least;
  if (!s->log) return even_ticks(s->least, s->most, step_of(range), at);
  if (range >= 2.5) return even_ticks(s->least, s->most, fmax(1.0, step_of(range)), at);
  int count = ticks_of_decades(s, at);
  if (count >= 3) return count;
  const double least = pow(10.0, s->least), most = pow(10.0, s->most);
  count = even_ticks(least, most, step_of(most - least), at);
  for (int i = 0; i < count; i++) at[i] = log10(at[i]);
  return count;
}

static void power_text(FILE *file, int power) {
  fprintf(file, "10<tspan dy=\"-4\" font-size=\"8\">%s%d</tspan>", power < 0 ? "−" : "", abs(power));
}

/* The number at a tick, as text of SVG that is no wider than its margin: with a power of ten where it is small or large. */
static void tick_text(FILE *file, const scale *s, double u) {
  const double x = s->log ? pow(10.0, u) : fabs(u) < 1e-9 * (s->most - s->least) ? 0.0 : u;
  const int power = x != 0.0 ? (int)floor(log10(fabs(x)) + 1e-9) : 0;
  const double mantissa = fabs(x) * pow(10.0, -power);
  if (x < 0.0) fputs("−", file);
  if (power >= -2 && power <= 4) {
    fprintf(file, "%.5g", fabs(x));
    return;
  }
  if (fabs(mantissa - 1.0) > 1e-9) fprintf(file, "%.3g·", mantissa);
  power_text(file, power);
}

static void draw_tick(FILE *file, const scale *s, double u, bool vertical) {
  const double at = s->from + (u - s->least) / (s->most - s->least) * (s->to - s->from);
  if (vertical)
    fprintf(file, "<path class=\"grid\" d=\"M%d %.1fh%d\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">", LEFT, at, ACROSS, LEFT - 5,
            at + 4.0);
  else
    fprintf(file, "<path class=\"grid\" d=\"M%.1f %dv%d\"/><text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">", at, TOP, DOWN, at,
            HEIGHT - BOTTOM + 15);
  tick_text(file, s, u);
  fputs("</text>\n", file);
}

static void draw_axis(FILE *file, const page_axis *axis, const scale *s, bool vertical) {
  double at[MOST_TICKS];
  const int count = ticks_of(s, at);
  for (int i = 0; i < count; i++) draw_tick(file, s, at[i], vertical);
  if (vertical)
    fprintf(file, "<text x=\"2\" y=\"14\">");
  else
    fprintf(file, "<text x=\"%d\" y=\"%d\" text-anchor=\"end\">", WIDTH - RIGHT, HEIGHT - 8);
  page_escape(file, axis->label);
  fputs("</text>\n", file);
}

/* ---- curves ---- */

static const char *line_class(const page_series *c) {
  if (c->dashed) return c->bold ? "line dashed bold" : "line dashed";
  return c->bold ? "line bold" : "line";
}

static void draw_line(FILE *file, const page_series *c, const scale *x, const scale *y) {
  bool drawing = false, begun = false;
  for (int i = 0; i < c->count; i++) {
    const double px = place(x, c->x[i]), py = place(y, c->y[i]);
    const bool shown = isfinite(px) && isfinite(py);
    if (shown && !begun) fprintf(file, "<path class=\"%s\" d=\"", line_class(c));
    if (shown) fprintf(file, "%s%.1f %.1f", drawing ? " " : "M", px, py);
    begun = begun || shown;
    drawing = shown;
  }
  if (begun) fputs("\"/>\n", file);
}

/* There along the upper edge and back along the lower one. */
static void draw_band(FILE *file, const page_series *c, const scale *x, const scale *y) {
  int points = 0;
  for (int k = 0; k < 2 * c->count; k++) {
    const int i = k < c->count ? k : 2 * c->count - 1 - k;
    const double px = place(x, c->x[i]), high = place(y, c->high[i]), low = place(y, c->low[i]);
    if (isfinite(px) && isfinite(high) && isfinite(low))
      fprintf(file, "%s%.1f %.1f", points++ == 0 ? "<path class=\"band\" d=\"M" : " ", px, k < c->count ? high : low);
  }
  if (points > 0) fputs("z\"/>\n", file);
}

/* Seven shapes about a point; odd rounds through the colours are open. */
static void draw_marker(FILE *file, int look, double x, double y) {
  const char *kind = look / COLOURS % 2 == 0 ? "mark" : "open";
  static const char *const shapes[MARKERS] = {"m-2.7 0a2.7 2.7 0 1 0 5.4 0a2.7 2.7 0 1 0-5.4 0z",
                                              "m-2.4-2.4h4.8v4.8h-4.8z",
                                              "m0-3.2l3 5.4h-6z",
                                              "m0-3.4l2.8 3.4l-2.8 3.4l-2.8-3.4z",
                                              "m0 3.2l3-5.4h-6z",
                                              "m-1-3h2v2h2v2h-2v2h-2v-2h-2v-2h2z",
                                              "m-4 0l4-2l4 2l-4 2z"};
  fprintf(file, "<path class=\"%s\" d=\"M%.1f %.1f%s\"", kind, x, y, shapes[look % MARKERS]);
}

static void draw_markers(FILE *file, const page_series *c, const scale *x, const scale *y) {
  for (int i = 0; i < c->count; i++) {
    const double px = place(x, c->x[i]), py = place(y, c->y[i]);
    if (!isfinite(px) || !isfinite(py) || !inside(x, px) || !inside(y, py)) continue;
    draw_marker(file, c->look, px, py);
    fputs("><title>", file);
    page_escape(file, c->name);
    fprintf(file, ": %.4g, %.4g</title></path>\n", c->x[i], c->y[i]);
  }
}

static void draw_series(FILE *file, const page_series *c, const scale *x, const scale *y) {
  fprintf(file, "<g class=\"k%d\">\n", c->look % COLOURS);
  if (c->low != NULL || c->style != PAGE_POINTS) {
    fprintf(file, "<svg x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" viewBox=\"%d %d %d %d\" overflow=\"hidden\">", LEFT, TOP, ACROSS,
            DOWN, LEFT, TOP, ACROSS, DOWN);
    if (c->low != NULL) draw_band(file, c, x, y);
    if (c->style != PAGE_POINTS) draw_line(file, c, x, y);
    fputs("</svg>\n", file);
  }
  if (c->style != PAGE_LINE) draw_markers(file, c, x, y);
  fputs("</g>\n", file);
}

static void draw_key(FILE *file, const page_plot *plot) {
  fputs("<ul class=\"key\">", file);
  for (int i = 0; i < plot->count; i++) {
    const page_series *c = &plot->series[i];
    fprintf(file, "<li class=\"k%d\"><svg viewBox=\"0 0 30 10\" aria-hidden=\"true\">", c->look % COLOURS);
    if (c->low != NULL) fputs("<path class=\"band\" d=\"M1 1h28v8h-28z\"/>", file);
    if (c->style != PAGE_POINTS) fprintf(file, "<path class=\"%s\" d=\"M1 5h28\"/>", line_class(c));
    if (c->style != PAGE_LINE) draw_marker(file, c->look, 15.0, 5.0), fputs("/>", file);
    fputs("</svg>", file);
    page_escape(file, c->name);
    fputs("</li>\n", file);
  }
  fputs("</ul>\n", file);
}

/* ---- numbers ---- */

static void write_point(FILE *file, const page_series *c, int i, bool band) {
  char text[4][32];
  const double values[4] = {c->x[i], c->y[i], c->low != NULL ? c->low[i] : (double)NAN, c->low != NULL ? c->high[i] : (double)NAN};
  const char *cells[] = {i == 0 ? c->name : NULL, text[0], text[1], text[2], text[3]};
  for (int k = 0; k < 4; k++)
    if (isfinite(values[k]))
      snprintf(text[k], sizeof text[k], "%.5g", values[k]);
    else
      text[k][0] = '\0';
  page_cells(file, "td", band ? "lllll" : "lll", cells); /* numbers stand to the right by the style of details */
}

static void write_numbers(FILE *file, const page_plot *plot) {
  bool band = false;
  for (int i = 0; i < plot->count; i++) band = band || plot->series[i].low != NULL;
  const char *const heads[] = {"", plot->x.label, plot->y.label, "from", "to"};
  fputs("<details><summary>Numbers</summary><div class=\"wide\"><table><thead>", file);
  page_cells(file, "th", band ? "lllll" : "lll", heads);
  fputs("</thead><tbody>\n", file);
  for (int i = 0; i < plot->count; i++)
    for (int k = 0; k < plot->series[i].count; k++) write_point(file, &plot->series[i], k, band);
  fputs("</tbody></table></div></details>\n", file);
}

/* ---- the figure ---- */

static void draw_plot(FILE *file, const page_plot *plot) {
  const scale x = scale_of(plot, &plot->x, false), y = scale_of(plot, &plot->y, true);
  fprintf(file, "<svg class=\"plot\" viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"", WIDTH, HEIGHT);
  page_escape(file, plot->title);
  fputs("\">\n", file);
  draw_axis(file, &plot->x, &x, false);
  draw_axis(file, &plot->y, &y, true);
  fprintf(file, "<path class=\"frame\" d=\"M%d %dv%dh%d\"/>\n", LEFT, TOP, DOWN, ACROSS);
  for (int i = 0; i < plot->count; i++) draw_series(file, &plot->series[i], &x, &y);
  fputs("</svg>\n", file);
}

void page_draw(page *p, const page_plot *plot) {
  FILE *file = p->out.file;
  if (!p->in_figures) fputs("<div class=\"figures\">\n", file);
  p->in_figures = true;
  fputs("<figure><figcaption>", file);
  page_escape(file, plot->title);
  fputs("</figcaption>\n", file);
  draw_plot(file, plot);
  draw_key(file, plot);
  if (plot->note != NULL) {
    fputs("<p>", file);
    page_prose(file, plot->note);
    fputs("</p>\n", file);
  }
  write_numbers(file, plot);
  fputs("</figure>\n", file);
}
