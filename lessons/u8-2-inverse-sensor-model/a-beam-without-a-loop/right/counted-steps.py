# style: a count of steps, and columns and rows apart

n = max(0, int(np.ceil((reading - CELL) / (CELL / 2))))
along = np.arange(n) * CELL / 2
a = np.deg2rad(angle)
column = np.floor((x + along * np.sin(a)) / CELL).astype(int)
row = np.floor((y + along * np.cos(a)) / CELL).astype(int)
ok = (column >= 0) & (column < ACROSS) & (row >= 0) & (row < ACROSS)
cells = np.stack([column[ok], row[ok]], axis=1)
