/* A page of results: one HTML file with text, tables and plots drawn as SVG. It needs nothing else, no script and no network, and is
 * made for a phone as well as for a wide window, on light and on dark ground. */
#ifndef HOST_PAGE_H
#define HOST_PAGE_H

#include "host/output.h"

/* A page being written. What a function below is handed is copied out before it returns; a write that fails shows at page_close. */
typedef struct page {
  output out;
  bool in_figures;   /* plots that follow each other stand side by side where there is room */
  const char *align; /* of the table under way */
} page;

/* All text is escaped. In paragraphs, headings, notes and cells what stands between two backquotes is shown as code. Numbers that are
 * not finite are left out. */

/* Returns 0, or -1 after a message, with nothing left behind. The title is the heading of level 1. */
int page_open(page *p, const char *path, const char *title);
int page_close(page *p);

/* Of level 2 or 3. */
void page_heading(page *p, int level, const char *text);

/* A paragraph. */
void page_text(page *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A table: its caption (null: none) and heads, rows of cells, its end. align has a letter for each column, l or r, the side on which it
 * stands, and lives as long as the table. A null cell is empty. */
void page_table(page *p, const char *caption, const char *align, const char *const *heads);
void page_row(page *p, const char *const *cells);
void page_table_end(page *p);

typedef enum page_style { PAGE_LINE, PAGE_POINTS, PAGE_LINE_POINTS } page_style;

typedef struct page_series {
  const char *name;
  const double *x, *y;      /* count each; a point that its axes cannot show breaks the line */
  const double *low, *high; /* count each: a band about y; null: none */
  int count;
  page_style style;
  int look;          /* colour and marker, from 0 on: the same number looks the same in all plots */
  bool dashed, bold; /* the line */
} page_series;

typedef struct page_axis {
  const char *label; /* with the unit */
  bool log;
  double least, most; /* shown; equal: as far as the points go */
} page_axis;

typedef struct page_plot {
  const char *title;
  const char *note; /* below; null: none */
  page_axis x, y;
  const page_series *series;
  int count;
} page_plot;

/* A plot with its key, and its numbers in a table that a reader may unfold. */
void page_draw(page *p, const page_plot *plot);

#endif
