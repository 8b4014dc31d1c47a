# style: cells that a clip leaves as they are

cells = np.clip(np.floor(points / CELL).astype(int), 0, ACROSS - 1)
