# style: np.subtract.at

np.subtract.at(grid, (rows, columns), -evidence)
grid = grid.clip(-limit, limit)
