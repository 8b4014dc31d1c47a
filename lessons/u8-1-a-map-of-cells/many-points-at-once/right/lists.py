# style: lists as the answer

cells = np.floor(points / CELL).astype(int)
cells = cells[np.all((cells >= 0) & (cells < ACROSS), axis=1)].tolist()
