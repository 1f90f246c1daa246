/* Command lines: a table of options, checked strictly. */
#ifndef HOST_OPTIONS_H
#define HOST_OPTIONS_H

#include <stdbool.h>

typedef enum option_kind {
  OPTION_FLAG,  /* value: bool, set where given */
  OPTION_COUNT, /* value: int, least..most */
  OPTION_REAL,  /* value: double, finite, least..most */
  OPTION_ABOVE, /* value: double, finite, above least, at most most */
  OPTION_TEXT,  /* value: const char *, not empty */
  OPTION_TEXTS, /* value: option_texts; may be given several times */
  OPTION_CHOICE /* value: int, an index into choices */
} option_kind;

enum { OPTION_MOST_TEXTS = 64 };

typedef struct option_texts {
  const char *text[OPTION_MOST_TEXTS];
  int count;
} option_texts;

typedef struct option {
  const char *name; /* "--step" */
  option_kind kind;
  void *value;                /* where the default stands and the value goes */
  double least, most;         /* of a number */
  const char *const *choices; /* ended by null */
  const char *operand;        /* its name in the help, null for a flag */
  const char *help;           /* what it does, with its unit; lines are broken by \n */
} option;

/* What --help prints around the table. */
typedef struct manual {
  const char *command;  /* behind the program's name: "run"; null for a program without subcommands */
  const char *operands; /* what may stand before the options, null for nothing: the driver reads it */
  const char *summary;  /* what the program does */
  const char *examples; /* commands to try, with a word on each */
} manual;

/* Reads "--name value" and "--name=value" into the values of the table (count options). Prints the manual and exits with status 0 at
 * --help or -h; prints what is wrong and what to write instead and exits with EXIT_USAGE at anything that does not fit. */
void read_options(int argc, char **argv, const option *table, int count, const manual *text);

#endif
