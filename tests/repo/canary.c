/* Faults on request: "heap" reads past an array on the heap, "shift" shifts too far. Without an argument it does nothing wrong. */
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv) {
  const char *fault = argc > 1 ? argv[1] : "";
  volatile int size = 4, width = 32;
  if (strcmp(fault, "heap") == 0) {
    volatile char *memory = calloc((size_t)size, 1);
    if (!memory) return 1;
    char past = memory[size];
    free((void *)memory);
    return past ? 1 : 2;
  }
  if (strcmp(fault, "shift") == 0) return (1 << width) == 0 ? 1 : 2;
  return 0;
}
