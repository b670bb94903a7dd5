#ifndef AEROSTAT_SHARED_HEIGHT_GRID_H
#define AEROSTAT_SHARED_HEIGHT_GRID_H

#include "layout.h"

/* Describes the ground as heights over a grid whose lines need not be evenly spaced. It takes 8
 * bytes for each vertex, which is 4 bytes for each triangle. It is one buffer of 32-bit words, in
 * this order:
 *
 *   columns, rows    cells along x and z, multiples of AERO_GRID_BLOCK, at most AERO_GRID_MOST
 *   columns + 1      x of the grid's lines, metres, ascending; lines that fill up a block are equal
 *   rows + 1         z of the grid's lines in the same form
 *   (columns + 1) * (rows + 1)   heights of the vertices, row by row along x
 *   (columns + 1) * (rows + 1)   unit normals in the same order
 *   AERO_GRID_SLACK  words that wide loads may touch
 *
 * A normal is x and z over |x| + |y| + |z|, as 16-bit signed shares of 32767 with x in the low
 * half; its y is positive.
 *
 * rules/height_cell.h says which triangles a cell has. */
#define AERO_GRID_HEADER 2
#define AERO_GRID_BLOCK 8
#define AERO_GRID_MOST 16384
#define AERO_GRID_SLACK 8

/* The bit that marks the number of a ground triangle among hits, and the position of its row and
 * column in that number. Numbers without the bit are slots of the tree's leaves. */
#define AERO_GRID_TRIANGLE 0x80000000u
#define AERO_GRID_ROW_SHIFT 15
#define AERO_GRID_COLUMN_SHIFT 1
#define AERO_GRID_CELL_MASK 0x3fffu

#endif
