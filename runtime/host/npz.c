/* NumPy's .npz: a zip file whose members are not compressed, each in the format .npy 1.0. */
#include "host/npz.h"

#include "host/message.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

static const unsigned long most_bytes = 0xffffffffUL; /* what zip's fields hold without its 64-bit extension */

enum { HEAD = 30, NPY_HEAD = 128, DATE = 0x21 /* 1 January 1980, the same for every file */ };

/* ---- bytes ---- */

typedef struct bytes {
  unsigned char at[64];
  size_t count;
} bytes;

static void put(bytes *b, unsigned long value, int count) {
  for (int i = 0; i < count; i++) b->at[b->count++] = (unsigned char)(value >> (8 * i) & 255u);
}

static void write_bytes(npz *z, const bytes *b) { fwrite(b->at, 1, b->count, z->out.file); }

unsigned long npz_crc32(unsigned long crc, const void *data, size_t count) {
  static uint32_t table[256];
  if (table[1] == 0)
    for (uint32_t i = 0; i < 256; i++) {
      table[i] = i;
      for (int k = 0; k < 8; k++) table[i] = table[i] >> 1 ^ (table[i] & 1 ? 0xedb88320u : 0u);
    }
  uint32_t c = (uint32_t)crc ^ 0xffffffffu;
  for (const unsigned char *p = data, *end = p + count; p < end; p++) c = c >> 8 ^ table[(c ^ *p) & 255u];
  return c ^ 0xffffffffu;
}

/* ---- members ---- */

/* The 26 bytes that a member's own header and its entry in the directory share. */
static void put_common(bytes *b, const npz_entry *e) {
  put(b, 20, 2); /* version 2.0 reads it */
  put(b, 0, 2);
  put(b, 0, 2); /* stored */
  put(b, 0, 2);
  put(b, DATE, 2);
  put(b, e->crc, 4);
  put(b, e->size, 4);
  put(b, e->size, 4);
  put(b, strlen(e->name), 2);
  put(b, 0, 2);
}

static void npy_head(char *head, int dimensions, const long *shape) {
  const uint16_t one = 1;
  const char order = *(const unsigned char *)&one == 1 ? '<' : '>';
  memset(head, ' ', NPY_HEAD);
  memcpy(head, "\x93NUMPY\x01\x00", 8);
  head[8] = NPY_HEAD - 10, head[9] = 0;
  int n = snprintf(head + 10, NPY_HEAD - 10, "{'descr': '%cf8', 'fortran_order': False, 'shape': (", order);
  for (int i = 0; i < dimensions; i++)
    n += snprintf(head + 10 + n, (size_t)(NPY_HEAD - 10 - n), "%ld,%s", shape[i], i + 1 < dimensions ? " " : "");
  n += snprintf(head + 10 + n, (size_t)(NPY_HEAD - 10 - n), "), }");
  head[10 + n] = ' ';
  head[NPY_HEAD - 1] = '\n';
}

static int too_large(npz *z) {
  complain("cannot write '%s': more than 4 GiB", z->out.target);
  output_discard(&z->out);
  return -1;
}

static unsigned long place(const npz *z) {
  const npz_entry *last = z->entries > 0 ? &z->entry[z->entries - 1] : NULL;
  return last != NULL ? last->at + HEAD + strlen(last->name) + last->size : 0;
}

int npz_open(npz *z, const char *path) {
  z->entries = 0;
  return output_open(&z->out, path);
}

int npz_add(npz *z, const char *name, const double *data, int dimensions, const long *shape, long stride) {
  assert(z->entries < NPZ_MOST_ENTRIES && strlen(name) < 60 && dimensions <= NPZ_MOST_DIMENSIONS);
  char head[NPY_HEAD];
  long rows = dimensions > 0 ? shape[0] : 1, width = 1;
  for (int i = 1; i < dimensions; i++) width *= shape[i];
  if (stride == 0) stride = width;
  if ((double)rows * (double)width * sizeof *data + (double)place(z) > (double)most_bytes - 1e6) return too_large(z);
  npz_entry *e = &z->entry[z->entries];
  *e = (npz_entry){.size = NPY_HEAD + (unsigned long)(rows * width) * sizeof *data, .at = place(z)};
  snprintf(e->name, sizeof e->name, "%s.npy", name);
  z->entries++;
  npy_head(head, dimensions, shape);
  e->crc = npz_crc32(0, head, NPY_HEAD);
  for (long i = 0; i < rows; i++) e->crc = npz_crc32(e->crc, data + i * stride, (size_t)width * sizeof *data);
  bytes b = {.count = 0};
  put(&b, 0x04034b50UL, 4);
  put_common(&b, e);
  write_bytes(z, &b);
  fputs(e->name, z->out.file);
  fwrite(head, 1, NPY_HEAD, z->out.file);
  for (long i = 0; i < rows; i++) fwrite(data + i * stride, sizeof *data, (size_t)width, z->out.file);
  return output_flush(&z->out);
}

int npz_close(npz *z) {
  const unsigned long start = place(z);
  unsigned long size = 0;
  for (int i = 0; i < z->entries; i++) {
    const npz_entry *e = &z->entry[i];
    bytes b = {.count = 0};
    put(&b, 0x02014b50UL, 4);
    put(&b, 20, 2);
    put_common(&b, e);
    put(&b, 0, 2);
    put(&b, 0, 2);
    put(&b, 0, 2);
    put(&b, 0, 4);
    put(&b, e->at, 4);
    write_bytes(z, &b);
    fputs(e->name, z->out.file);
    size += (unsigned long)(b.count + strlen(e->name));
  }
  bytes b = {.count = 0};
  put(&b, 0x06054b50UL, 4);
  put(&b, 0, 4);
  put(&b, (unsigned long)z->entries, 2);
  put(&b, (unsigned long)z->entries, 2);
  put(&b, size, 4);
  put(&b, start, 4);
  put(&b, 0, 2);
  write_bytes(z, &b);
  return output_commit(&z->out);
}
