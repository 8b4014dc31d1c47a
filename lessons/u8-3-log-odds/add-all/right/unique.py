# style: np.unique with counts

pairs, counts = np.unique(np.column_stack([rows, columns]), axis=0, return_counts=True)
grid[pairs[:, 0], pairs[:, 1]] += counts * evidence
grid = np.minimum(np.maximum(grid, -limit), limit)
