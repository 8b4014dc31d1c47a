# style: rows deleted

cells = np.floor(points / CELL).astype(int)
bad = np.unique(np.argwhere((cells < 0) | (cells >= ACROSS))[:, 0])
cells = np.delete(cells, bad, axis=0)
