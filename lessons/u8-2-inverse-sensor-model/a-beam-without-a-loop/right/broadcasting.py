# style: broadcasting

direction = np.array([np.sin(np.radians(angle)), np.cos(np.radians(angle))])
along = np.arange(0, reading - CELL, CELL / 2)[:, None]
cells = np.floor_divide(np.array([[x, y]]) + along * direction, CELL).astype(int)
cells = cells[np.logical_and(cells >= 0, cells < ACROSS).min(axis=1)]
