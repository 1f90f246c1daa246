/* CSV files as tables: a head of names, rows of cells; those in quotes may have commas, but no quotes. */
#ifndef PRECISION_TABLE_H
#define PRECISION_TABLE_H

typedef struct table {
  int rows, columns; /* rows without the head */
  char **cell;       /* (1 + rows) x columns: the head first */
  char *text;        /* that the cells point into */
} table;

/* Reads a file; a table without rows and columns where there is none. Rows with another number of cells than the head are left out. */
table table_read(const char *path);
void table_free(table *t);

/* Number of the column of that name, -1 where there is none. */
int table_column(const table *t, const char *name);

/* Row from 0 on; "" for column -1. */
const char *table_cell(const table *t, int row, int column);

/* NaN where the cell is no number. */
double table_number(const table *t, int row, int column);

#endif
