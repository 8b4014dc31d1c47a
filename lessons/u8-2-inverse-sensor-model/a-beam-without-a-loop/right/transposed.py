# style: two rows, then transposed

a = np.radians(angle)
along = np.r_[0 : max(reading - CELL, 0) : CELL / 2]
cells = np.array(
    [np.floor((x + along * np.sin(a)) / CELL), np.floor((y + along * np.cos(a)) / CELL)],
    dtype=np.int32,
).T
inside = (cells >= 0).all(axis=1) & (cells < ACROSS).all(axis=1)
cells = cells[inside]
