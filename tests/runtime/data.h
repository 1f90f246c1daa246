/* Lines of numbers from the text files in tests/data: '#' starts a comment line, a line may start with a name. */
#ifndef TEST_DATA_H
#define TEST_DATA_H

#include <stdio.h>

#define DATA_NUMBERS 512 /* most numbers of a line */

typedef struct data_line {
  char name[64]; /* empty where the line starts with a number */
  int count;
  double number[DATA_NUMBERS];
} data_line;

/* Opens a file of tests/data; fails the test where it is not there. */
FILE *data_open(const char *name);

/* Reads the next line that holds anything. 0 at the end of the file. */
int data_next(FILE *file, data_line *line);

#endif
