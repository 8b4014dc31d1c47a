# style: cells that a clip leaves as they are

cells = np.floor(points / CELL).astype(int)
cells = cells[(cells == np.clip(cells, 0, ACROSS - 1)).all(axis=1)]
