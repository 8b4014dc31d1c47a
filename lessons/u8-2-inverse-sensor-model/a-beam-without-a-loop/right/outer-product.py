# style: the outer product, and points sorted out before they become cells

a = np.radians(angle)
along = np.arange(0, reading - CELL, CELL / 2)
points = np.array([x, y]) + np.outer(along, [np.sin(a), np.cos(a)])
points = points[((points >= 0) & (points < ACROSS * CELL)).all(axis=1)]
cells = (points // CELL).astype(int)
