/* Which of several names a mistyped one was meant to be. */
#include "host/nearest.h"

#include <string.h>

enum { MOST = 48 /* characters that are compared */ };

static int least(int a, int b) { return a < b ? a : b; }

/* Letters to add, leave out, change, or swap with a neighbour, to make one name of the other (Damerau and Levenshtein). */
static int distance(const char *a, const char *b) {
  const int n = least((int)strlen(a), MOST), m = least((int)strlen(b), MOST);
  int d[MOST + 1][MOST + 1];
  for (int i = 0; i <= n; i++) d[i][0] = i;
  for (int j = 0; j <= m; j++) d[0][j] = j;
  for (int i = 1; i <= n; i++)
    for (int j = 1; j <= m; j++) {
      d[i][j] = least(least(d[i - 1][j], d[i][j - 1]) + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1]));
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[n][m];
}

/* A third of the letters may be wrong; one that is a part of the other, from its beginning or end, is near as well. */
static int far(const char *mistyped, const char *name) {
  const int apart = distance(mistyped, name), n = (int)strlen(mistyped), m = (int)strlen(name);
  if (n > 2 && m > n && (strncmp(name, mistyped, (size_t)n) == 0 || strcmp(name + m - n, mistyped) == 0)) return 1;
  return 3 * apart <= (n > m ? n : m) ? apart : MOST;
}

const char *nearer(const char *mistyped, const char *best, const char *name) {
  const int away = far(mistyped, name);
  if (away == MOST || (best != NULL && far(mistyped, best) <= away)) return best;
  return name;
}
