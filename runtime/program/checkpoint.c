/* A Lyapunov run on disk: a line of text with the sizes and a sum of the bytes, then the terms, the rows and the run's image. */
#include "checkpoint.h"

#include "host/message.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define FIRST_WORDS "eom lyapunov run"
#define HEAD FIRST_WORDS " 2: terms %zu rows %ld width %d image %zu crc "

typedef struct sizes {
  size_t terms; /* bytes */
  long rows;
  int width;
  size_t image; /* bytes */
  unsigned long sum;
} sizes;

static size_t bytes_of_rows(const sizes *z) { return (size_t)z->rows * (size_t)z->width * sizeof(double); }

static unsigned long sum_of(const sizes *z, const char *terms, const double *rows, const void *image) {
  return npz_crc32(npz_crc32(npz_crc32(0, terms, z->terms), rows, bytes_of_rows(z)), image, z->image);
}

int checkpoint_write(const char *path, const char *terms, const eom_lyapunov *ly, const series *rows) {
  output o;
  sizes z = {.terms = strlen(terms), .rows = rows->count, .width = rows->width, .image = eom_lyapunov_image_bytes(ly)};
  void *image = malloc(z.image);
  if (image == NULL) return complain("not enough memory for a checkpoint"), -1;
  eom_lyapunov_save(ly, image);
  z.sum = sum_of(&z, terms, rows->rows, image);
  int status = output_open(&o, path);
  if (status == 0) {
    fprintf(o.file, HEAD "%08lx\n", z.terms, z.rows, z.width, z.image, z.sum);
    fwrite(terms, 1, z.terms, o.file);
    if (rows->count > 0) fwrite(rows->rows, 1, bytes_of_rows(&z), o.file);
    fwrite(image, 1, z.image, o.file);
    status = output_commit(&o);
  }
  free(image);
  return status;
}

static int bad(const char *path, const char *why) {
  complain("--checkpoint %s: %s; with --replace in the place of --resume the run begins anew", path, why);
  return -1;
}

/* ---- the file ---- */

/* Null where there is none, with *status 0, or -1 after a message. */
static FILE *open_file(const char *path, int *status) {
  FILE *file = fopen(path, "rb");
  *status = file != NULL || errno == ENOENT ? 0 : bad(path, strerror(errno));
  return file;
}

bool checkpoint_there(const char *path) {
  char first[sizeof FIRST_WORDS] = "";
  struct stat info;
  if (stat(path, &info) != 0 || !S_ISREG(info.st_mode)) return false; /* a device keeps nothing */
  FILE *file = fopen(path, "rb");
  const bool ours = file != NULL && fread(first, 1, sizeof first - 1, file) == sizeof first - 1 && strcmp(first, FIRST_WORDS) == 0;
  if (file != NULL) fclose(file);
  if (!ours) usage_error("--checkpoint %s: there is a file already that is no checkpoint", path);
  return true;
}

/* The sizes and the terms, to be freed; the file stands behind them then. Null after a message. */
static char *read_terms(FILE *file, const char *path, sizes *z) {
  if (fscanf(file, HEAD "%lx", &z->terms, &z->rows, &z->width, &z->image, &z->sum) != 5 || fgetc(file) != '\n' || z->rows < 0 ||
      z->width < 1)
    return bad(path, "it is no checkpoint of this version"), NULL;
  const long begin = ftell(file);
  if (begin < 0 || fseek(file, 0, SEEK_END) != 0) return bad(path, "it cannot be read"), NULL;
  if (ftell(file) - begin != (long)(z->terms + bytes_of_rows(z) + z->image))
    return bad(path, "it has been cut short or added to"), NULL;
  char *terms = calloc(z->terms + 1, 1);
  if (terms != NULL && fseek(file, begin, SEEK_SET) == 0 && fread(terms, 1, z->terms, file) == z->terms) return terms;
  free(terms);
  return bad(path, terms == NULL ? "not enough memory" : "it cannot be read"), NULL;
}

/* ---- terms ---- */

int checkpoint_terms(const char *path, char **terms) {
  sizes z;
  int status;
  FILE *file = open_file(path, &status);
  *terms = file != NULL ? read_terms(file, path, &z) : NULL;
  if (file == NULL) return status;
  fclose(file);
  return *terms != NULL ? 0 : -1;
}

/* Where the value of the line at `at` begins: behind " = ". */
static const char *value_of(const char *line) {
  const char *sign = strstr(line, " = ");
  return sign != NULL ? sign + 3 : line + strlen(line);
}

static const char *next_line(const char *line) {
  const size_t length = strcspn(line, "\n");
  return line + length + (line[length] == '\n');
}

double checkpoint_term(const char *terms, const char *name) {
  for (const char *line = terms; line != NULL && *line != '\0'; line = next_line(line))
    if (strncmp(line, name, strlen(name)) == 0 && value_of(line) == line + strlen(name) + 3) return strtod(value_of(line), NULL);
  return 0.0;
}

/* Complains of the first line that differs. */
static int compare_terms(const char *path, const char *kept, const char *wanted) {
  char why[512];
  while (*kept != '\0' && next_line(kept) - kept == next_line(wanted) - wanted &&
         memcmp(kept, wanted, (size_t)(next_line(kept) - kept)) == 0)
    kept = next_line(kept), wanted = next_line(wanted);
  if (*kept == '\0' && *wanted == '\0') return 0;
  const char *was = value_of(kept), *is = value_of(wanted);
  if (was - kept != is - wanted || memcmp(kept, wanted, (size_t)(was - kept)) != 0) return bad(path, "it is of another model");
  snprintf(why, sizeof why, "it is of a run with %.*s, not %.*s", (int)strcspn(kept, "\n"), kept, (int)strcspn(is, "\n"), is);
  return bad(path, why);
}

/* ---- the run ---- */

/* What stands behind the terms. */
static int read_rest(FILE *file, const char *path, const sizes *z, const char *terms, eom_lyapunov *ly, series *rows) {
  if (z->width != rows->width || z->image != eom_lyapunov_image_bytes(ly)) return bad(path, "it is of a run of another size");
  char *image = malloc(z->image);
  int status = image != NULL ? 0 : bad(path, "not enough memory");
  for (long i = 0; status == 0 && i < z->rows; i++)
    if (series_row(rows) == NULL) status = -1;
  if (status == 0 && (fread(rows->rows, 1, bytes_of_rows(z), file) != bytes_of_rows(z) || fread(image, 1, z->image, file) != z->image))
    status = bad(path, "it cannot be read");
  if (status == 0 && sum_of(z, terms, rows->rows, image) != z->sum) status = bad(path, "its bytes have changed");
  if (status == 0) {
    const eom_status restored = eom_lyapunov_restore(ly, image, z->image);
    if (restored != EOM_OK) status = bad(path, eom_status_text(restored));
  }
  free(image);
  return status;
}

int checkpoint_read(const char *path, const char *terms, eom_lyapunov *ly, series *rows) {
  sizes z;
  int status;
  FILE *file = open_file(path, &status);
  if (file == NULL) return status;
  char *kept = read_terms(file, path, &z);
  status = kept == NULL || compare_terms(path, kept, terms) != 0 ? -1 : read_rest(file, path, &z, kept, ly, rows);
  free(kept);
  fclose(file);
  return status;
}
