/* Pages of results: the document, its text and its tables. */
#include "host/page.h"

#include "host/page_text.h"

#include <stdarg.h>
#include <stdlib.h>

/* Colours that colour-blind readers can tell apart, darker on light ground than on dark. --k: a line's or marker's colour. */
static const char style[] =
    ":root{color-scheme:light dark;--paper:#fff;--ink:#1d2126;--soft:#5b6570;--rule:#d5dae0;"
    "--c0:#0072b2;--c1:#c04e00;--c2:#00805c;--c3:#b0518a;--c4:#a06f00;--c5:#2b8fcf;--c6:#6a4fc0;--c7:#555b62}\n"
    "@media(prefers-color-scheme:dark){:root{--paper:#14171a;--ink:#e6e9ec;--soft:#a3adb8;--rule:#39414a;"
    "--c0:#4fb0ea;--c1:#ff8a4c;--c2:#3fcf9f;--c3:#e793c4;--c4:#e8b341;--c5:#8fd0ff;--c6:#ab98ff;--c7:#b4bcc5}}\n"
    "*{box-sizing:border-box}\n"
    "body{margin:0 auto;padding:1rem;max-width:84rem;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif}\n"
    "h1{font-size:1.6rem;line-height:1.25}h2{font-size:1.25rem;margin-top:2.2rem;border-bottom:1px solid var(--rule)}"
    "h3{font-size:1.05rem}\n"
    "p{max-width:48rem}h1,h2,h3,p,figcaption,li{overflow-wrap:anywhere}\n"
    "code{font:.92em/1.4 ui-monospace,monospace}\n"
    ".wide{overflow-x:auto;max-width:100%}\n"
    "table{border-collapse:collapse;font-size:.86rem;font-variant-numeric:tabular-nums;margin:.6rem 0}"
    "caption{text-align:left;font-weight:600;padding:.3rem 0}"
    "th,td{padding:.2rem .6rem;border-bottom:1px solid var(--rule);text-align:left;vertical-align:top}"
    "td:not(.n)+td:not(.n){overflow-wrap:anywhere}"
    "th{color:var(--soft);font-weight:600}td.n,th.n{text-align:right;white-space:nowrap}\n"
    ".figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,26rem),34rem));gap:1.2rem 1.6rem}\n"
    "figure{margin:0;min-width:0;max-width:34rem}figcaption{font-weight:600}figure p{margin:.3rem "
    "0;font-size:.86rem;color:var(--soft)}\n"
    "svg.plot{display:block;width:100%;height:auto}svg text{fill:var(--ink);font:11px system-ui,sans-serif}\n"
    ".grid{stroke:var(--rule);stroke-width:.6}.frame{fill:none;stroke:var(--soft);stroke-width:.8}\n"
    ".key{list-style:none;display:flex;flex-wrap:wrap;gap:.1rem 1rem;margin:.3rem 0;padding:0;font-size:.8rem}"
    ".key svg{width:30px;height:10px;vertical-align:middle;margin-right:.35rem}\n"
    ".line{fill:none;stroke:var(--k);stroke-width:1.3;stroke-linejoin:round}.bold{stroke-width:2.4}.dashed{stroke-dasharray:4 2.5}"
    ".mark{fill:var(--k);stroke:none}.open{fill:var(--paper);stroke:var(--k);stroke-width:1.1}"
    ".band{fill:var(--k);opacity:.2;stroke:none}\n"
    ".k0{--k:var(--c0)}.k1{--k:var(--c1)}.k2{--k:var(--c2)}.k3{--k:var(--c3)}.k4{--k:var(--c4)}.k5{--k:var(--c5)}.k6{--k:var(--c6)}"
    ".k7{--k:var(--c7)}\n"
    "@media(max-width:40rem){table{font-size:.68rem}th,td{padding:.15rem .13rem}}\n"
    "details{font-size:.86rem}summary{cursor:pointer;color:var(--soft)}details .wide{max-height:24rem;overflow:auto}"
    "details :is(td,th)+:is(td,th){text-align:right;white-space:nowrap}\n";

static void escape(FILE *file, char c) {
  switch (c) {
  case '&':
    fputs("&amp;", file);
    break;
  case '<':
    fputs("&lt;", file);
    break;
  case '>':
    fputs("&gt;", file);
    break;
  case '"':
    fputs("&quot;", file);
    break;
  default:
    fputc(c, file);
  }
}

void page_escape(FILE *file, const char *text) {
  for (; *text != '\0'; text++) escape(file, *text);
}

void page_prose(FILE *file, const char *text) {
  bool code = false;
  for (; *text != '\0'; text++) {
    if (*text != '`') {
      escape(file, *text);
      continue;
    }
    fputs(code ? "</code>" : "<code>", file);
    code = !code;
  }
  if (code) fputs("</code>", file);
}

static void element(page *p, const char *name, const char *text) {
  fprintf(p->out.file, "<%s>", name);
  page_prose(p->out.file, text);
  fprintf(p->out.file, "</%s>\n", name);
}

/* What follows is no plot beside the last one. */
static void leave_figures(page *p) {
  if (p->in_figures) fputs("</div>\n", p->out.file);
  p->in_figures = false;
}

int page_open(page *p, const char *path, const char *title) {
  *p = (page){.in_figures = false};
  if (output_open(&p->out, path) != 0) return -1;
  fputs("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"/>\n<link rel=\"icon\" href=\"data:,\"/>\n",
        p->out.file);
  element(p, "title", title);
  fprintf(p->out.file, "<style>\n%s</style></head>\n<body>\n", style);
  element(p, "h1", title);
  return 0;
}

int page_close(page *p) {
  leave_figures(p);
  fputs("</body></html>\n", p->out.file);
  return output_commit(&p->out);
}

void page_heading(page *p, int level, const char *text) {
  leave_figures(p);
  element(p, level <= 2 ? "h2" : "h3", text);
}

void page_text(page *p, const char *format, ...) {
  char *text = NULL;
  size_t size = 0;
  va_list arguments;
  leave_figures(p);
  FILE *memory = open_memstream(&text, &size);
  if (memory == NULL) return;
  va_start(arguments, format);
  vfprintf(memory, format, arguments);
  va_end(arguments);
  if (fclose(memory) == 0) element(p, "p", text);
  free(text);
}

/* ---- tables ---- */

void page_cells(FILE *file, const char *kind, const char *align, const char *const *cells) {
  fputs("<tr>", file);
  for (; *align != '\0'; align++, cells++) {
    fprintf(file, "<%s%s>", kind, *align == 'r' ? " class=\"n\"" : "");
    if (*cells != NULL) page_prose(file, *cells);
    fprintf(file, "</%s>", kind);
  }
  fputs("</tr>\n", file);
}

void page_table(page *p, const char *caption, const char *align, const char *const *heads) {
  leave_figures(p);
  p->align = align;
  fputs("<div class=\"wide\"><table>", p->out.file);
  if (caption != NULL) element(p, "caption", caption);
  fputs("<thead>", p->out.file);
  page_cells(p->out.file, "th", align, heads);
  fputs("</thead><tbody>\n", p->out.file);
}

void page_row(page *p, const char *const *cells) { page_cells(p->out.file, "td", p->align, cells); }

void page_table_end(page *p) { fputs("</tbody></table></div>\n", p->out.file); }
