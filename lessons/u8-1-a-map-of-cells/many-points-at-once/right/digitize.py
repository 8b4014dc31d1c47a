# style: np.digitize

edges = np.arange(0, 201, CELL)
cells = np.digitize(points, edges) - 1
cells = cells[((cells >= 0) & (cells < ACROSS)).all(axis=1)]
