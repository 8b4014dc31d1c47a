# style: a plain loop

for row, column in zip(rows, columns):
    grid[row, column] += evidence
grid = np.clip(grid, -limit, limit)
