# style: a Counter of the named cells

from collections import Counter

for (row, column), times in Counter(zip(rows, columns)).items():
    grid[row][column] += times * evidence
grid[grid > limit] = limit
grid[grid < -limit] = -limit
