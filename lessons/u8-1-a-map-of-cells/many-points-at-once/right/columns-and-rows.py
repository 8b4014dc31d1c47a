# style: columns and rows apart

column = np.floor(points[:, 0] / CELL).astype(int)
row = np.floor(points[:, 1] / CELL).astype(int)
good = (column >= 0) & (column < ACROSS) & (row >= 0) & (row < ACROSS)
cells = np.column_stack([column[good], row[good]])
