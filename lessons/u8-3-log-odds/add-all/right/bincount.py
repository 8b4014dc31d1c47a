# style: np.bincount on the flattened grid

flat = np.ravel_multi_index((rows, columns), grid.shape)
counts = np.bincount(flat, minlength=grid.size).reshape(grid.shape)
grid = np.clip(grid + counts * evidence, -limit, limit)
