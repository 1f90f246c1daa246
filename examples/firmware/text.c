/* Numbers as text, by integers alone. */
#include "text.h"

#include "console.h"

#include <string.h>

static void flush(text *t) {
  t->chars[t->length] = '\0';
  t->length = 0;
  console_write(t->chars);
}

static void add(text *t, char c) {
  if (t->length + 1 == (int)sizeof t->chars) flush(t);
  t->chars[t->length++] = c;
}

void text_end(text *t) {
  add(t, '\n');
  flush(t);
}

void text_add(text *t, const char *chars) {
  while (*chars != '\0') add(t, *chars++);
}

static void add_digits(text *t, uint32_t x, uint32_t base, int least) {
  char digits[12];
  int n = 0;
  do {
    digits[n++] = "0123456789abcdef"[x % base];
    x /= base;
  } while (x > 0 || n < least);
  while (n > 0) add(t, digits[--n]);
}

void text_add_count(text *t, uint32_t x) { add_digits(t, x, 10, 1); }

void text_add_name(text *t, const char *name, int number) {
  text_add(t, name);
  text_add_count(t, (uint32_t)number);
}

void text_add_decimal(text *t, tl_real x) {
  const tl_real size = x < TL_C(0.0) ? -x : x;
  const uint32_t millionths = (uint32_t)(size * TL_C(1e6) + TL_C(0.5));
  if (x < TL_C(0.0)) add(t, '-');
  text_add_count(t, millionths / 1000000);
  add(t, '.');
  add_digits(t, millionths % 1000000, 10, 6);
}

void text_add_decimals(text *t, int n, const tl_real *x) {
  for (int i = 0; i < n; i++) {
    add(t, ',');
    text_add_decimal(t, x[i]);
  }
}

void text_add_bits(text *t, int n, const tl_real *x) {
  uint32_t words[sizeof *x / sizeof(uint32_t)];
  for (int i = 0; i < n; i++) {
    memcpy(words, &x[i], sizeof words);
    add(t, ',');
    for (int k = (int)(sizeof words / sizeof *words) - 1; k >= 0; k--) add_digits(t, words[k], 16, 8); /* little-endian */
  }
}
