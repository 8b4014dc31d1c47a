# style: a loop over x and y, and one over two answers

along = np.arange(0, reading - CELL, CELL / 2)
way = np.radians(angle)
columns, rows = (
    np.floor((start + along * share) / CELL).astype(int)
    for start, share in ((x, np.sin(way)), (y, np.cos(way)))
)
good = np.ones(along.shape, dtype=bool)
for axis in range(2):
    numbers = (columns, rows)[axis]
    good &= (numbers >= 0) & (numbers < ACROSS)
cells = np.column_stack([columns, rows])[good]
