/* Text that is put together without the C library and goes to the console whenever there is enough of it. */
#ifndef TEXT_H
#define TEXT_H

#include "taylor/real.h"
#include <stdint.h>

typedef struct text {
  char chars[64];
  int length;
} text;

void text_add(text *t, const char *chars);

/* The end of a line: what is left goes to the console. */
void text_end(text *t);

void text_add_count(text *t, uint32_t x);

/* name and number, as y3. */
void text_add_name(text *t, const char *name, int number);

/* With six digits after the point; |x| < 2000. */
void text_add_decimal(text *t, tl_real x);

/* n numbers, a comma before each: in decimals, or as the hexadecimal digits of their bits. */
void text_add_decimals(text *t, int n, const tl_real *x);
void text_add_bits(text *t, int n, const tl_real *x);

#endif
