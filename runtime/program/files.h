/* The output files of a command, looked at before it computes. */
#ifndef PROGRAM_FILES_H
#define PROGRAM_FILES_H

#include "setup.h"

/* What an option wants written; path null: nothing. */
typedef struct wanted_file {
  const char *option, *path;
} wanted_file;

enum { WANTED_FILES = 4 };

/* All of a command. */
typedef struct wanted_files {
  wanted_file file[WANTED_FILES];
} wanted_files;

/* Exits with EXIT_USAGE, after a message, where two paths are one file, or one is the model or the start file of s. */
void files_distinct(wanted_files files, const setup *s);

/* Whether every one can be made, and drawn where its option is --plot or --gif. Returns 0, or -1 after a message. */
int files_possible(wanted_files files);

#endif
