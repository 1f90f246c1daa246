/* Pages of results: what a browser is given is well formed, escaped, and shows every point where it belongs. */
#include "close.h"

#include "host/message.h"
#include "host/page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char program[] = "test_page";

enum { MOST = 1 << 18, MOST_DEPTH = 64, MOST_POINTS = 16 };

static char name[] = "test_page_XXXXXX";
static char text[MOST];

/* Writes what draw does as a page, and reads it back into text. */
static void write_page(void (*draw)(page *p)) {
  page p;
  assert_int_equal(page_open(&p, name, "a < b & `c`"), 0);
  draw(&p);
  assert_int_equal(page_close(&p), 0);
  FILE *file = fopen(name, "r");
  assert_non_null(file);
  const size_t length = fread(text, 1, MOST - 1, file);
  assert_true(length < MOST - 1);
  text[length] = '\0';
  fclose(file);
}

/* Every element that is opened is closed in its turn. */
static void check_nesting(void) {
  const char *open[MOST_DEPTH];
  int depth = 0;
  for (const char *at = strstr(text, "<html"); (at = strchr(at, '<')) != NULL; at++) {
    const char *end = strchr(at, '>');
    assert_non_null(end);
    if (at[1] == '/') {
      assert_true(depth > 0);
      depth--;
      const size_t length = (size_t)(end - at) - 2;
      assert_memory_equal(open[depth] + 1, at + 2, length);
      assert_true(open[depth][1 + length] == ' ' || open[depth][1 + length] == '>');
    } else if (end[-1] != '/') {
      assert_true(depth < MOST_DEPTH);
      open[depth++] = at;
    }
  }
  assert_int_equal(depth, 0);
}

static const char *after(const char *where, const char *what) {
  const char *at = strstr(where, what);
  assert_non_null(at);
  return at + strlen(what);
}

/* Where the markers stand. */
static int markers(double *x, double *y) {
  int count = 0;
  const char *end = strstr(text, "class=\"key\"");
  for (const char *at = text; (at = strstr(at, "class=\"mark\" d=\"M")) != NULL && at < end; count++) {
    char *next;
    assert_true(count < MOST_POINTS);
    x[count] = strtod(at += strlen("class=\"mark\" d=\"M"), &next);
    y[count] = strtod(next, NULL);
  }
  return count;
}

/* ---- text and tables ---- */

static void draw_text(page *p) {
  page_text(p, "%d < %d & `x->y`", 1, 2);
  page_table(p, "\"quoted\"", "lr", (const char *const[]){"name", "s"});
  page_row(p, (const char *const[]){"<b>", NULL});
  page_table_end(p);
  page_heading(p, 3, "an `open end");
}

static void text_is_escaped(void **state) {
  (void)state;
  write_page(draw_text);
  check_nesting();
  (void)after(text, "<h1>a &lt; b &amp; <code>c</code></h1>");
  (void)after(text, "<p>1 &lt; 2 &amp; <code>x-&gt;y</code></p>");
  (void)after(text, "<caption>&quot;quoted&quot;</caption>");
  (void)after(text, "<td>&lt;b&gt;</td><td class=\"n\"></td>");
  (void)after(text, "<h3>an <code>open end</code></h3>");
}

/* ---- plots ---- */

static void draw_decades(page *p) {
  const double x[] = {1e-9, 1e-6, 1e-3, 1.0}, y[] = {1.0, 10.0, 100.0, 1000.0};
  const page_series s = {.name = "decades", .x = x, .y = y, .count = 4, .style = PAGE_LINE_POINTS};
  page_draw(p,
            &(page_plot){.title = "t", .x = {.label = "x", .log = true}, .y = {.label = "y", .log = true}, .series = &s, .count = 1});
}

static void decades_are_equally_far_apart(void **state) {
  (void)state;
  double x[MOST_POINTS], y[MOST_POINTS];
  const double digits = 0.11; /* positions are printed to 0.1 */
  write_page(draw_decades);
  check_nesting();
  assert_int_equal(markers(x, y), 4);
  for (int i = 1; i < 4; i++) {
    assert_close(x[i] - x[i - 1], (x[3] - x[0]) / 3.0, 0.0, digits);
    assert_close(y[i] - y[i - 1], (y[3] - y[0]) / 3.0, 0.0, digits);
  }
  assert_true(x[0] < x[3] && y[0] > y[3]); /* y grows upwards, from the upper edge in SVG */
}

static void draw_thousands(page *p) {
  const double x[] = {100.0, 1000.0, 10000.0, 99999.0};
  const page_series s = {.name = "thousands", .x = x, .y = x, .count = 4};
  page_draw(p, &(page_plot){.title = "t", .x = {.label = "x", .log = true}, .y = {.label = "y"}, .series = &s, .count = 1});
}

/* Whole numbers below a hundred thousand are written out, none in the way of C. */
static void ticks_read_well(void **state) {
  (void)state;
  write_page(draw_thousands);
  (void)after(text, ">1000</text>");
  (void)after(text, ">10000</text>");
  const char *end = strstr(text, "class=\"key\""), *power = strstr(text, "e+");
  assert_true(power == NULL || power > end);
}

static void draw_gaps(page *p) {
  const double x[] = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, y[] = {1.0, 2.0, (double)NAN, 0.0, (double)INFINITY, 3.0};
  const double low[] = {0.5, 1.0, (double)NAN, -1.0, 1.0, 2.0}, high[] = {2.0, 3.0, 4.0, 5.0, (double)INFINITY, 4.0};
  const page_series s[] = {{.name = "a<b", .x = x, .y = y, .low = low, .high = high, .count = 6, .style = PAGE_LINE_POINTS},
                           {.name = "nothing", .x = x, .y = y, .count = 0, .look = 1}};
  page_draw(p,
            &(page_plot){.title = "t", .note = "note", .x = {.label = "x"}, .y = {.label = "y", .log = true}, .series = s, .count = 2});
}

static void what_an_axis_cannot_show_is_left_out(void **state) {
  (void)state;
  double x[MOST_POINTS], y[MOST_POINTS];
  write_page(draw_gaps);
  check_nesting();
  assert_int_equal(markers(x, y), 3);
  const char *line = after(text, "class=\"line\" d=\"M");
  const char *end = strchr(line, '"'), *gap = strchr(line, 'M');
  assert_true(gap != NULL && gap < end); /* the line is taken up again after the gap */
  assert_null(strstr(text, "nan"));
  assert_null(strstr(text, ">inf"));
  (void)after(text, "a&lt;b");
}

static void draw_range(page *p) {
  const double x[] = {-5.0, 0.0, 10.0, 20.0}, y[] = {0.0, 0.0, 1.0, 9.0};
  const page_series s = {.name = "range", .x = x, .y = y, .count = 4, .style = PAGE_LINE_POINTS};
  page_draw(p, &(page_plot){.title = "t",
                            .x = {.label = "x", .least = 0.0, .most = 10.0},
                            .y = {.label = "y", .least = 0.0, .most = 1.0},
                            .series = &s,
                            .count = 1});
}

static void only_the_range_is_shown(void **state) {
  (void)state;
  double x[MOST_POINTS], y[MOST_POINTS];
  write_page(draw_range);
  check_nesting();
  assert_int_equal(markers(x, y), 2);
}

static void a_folder_that_is_not_there(void **state) {
  (void)state;
  page p;
  assert_int_equal(page_open(&p, "no_such_folder/page.html", "t"), -1);
}

static int make_name(void **state) {
  (void)state;
  const int file = mkstemp(name);
  return file < 0 ? -1 : close(file);
}

static int remove_page(void **state) {
  (void)state;
  return unlink(name);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(text_is_escaped),         cmocka_unit_test(decades_are_equally_far_apart),
      cmocka_unit_test(ticks_read_well),         cmocka_unit_test(what_an_axis_cannot_show_is_left_out),
      cmocka_unit_test(only_the_range_is_shown), cmocka_unit_test(a_folder_that_is_not_there),
  };
  return cmocka_run_group_tests(tests, make_name, remove_page);
}
