/* Private to the page: escaped text and rows of cells. */
#ifndef HOST_PAGE_TEXT_H
#define HOST_PAGE_TEXT_H

#include <stdio.h>

/* Text as it stands, for attributes too; and text with code between backquotes. */
void page_escape(FILE *file, const char *text);
void page_prose(FILE *file, const char *text);

/* A row of a table; kind: th or td; align and cells as page_table and page_row have them. */
void page_cells(FILE *file, const char *kind, const char *align, const char *const *cells);

#endif
