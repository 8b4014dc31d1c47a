# style: each cell once, with np.unique

n = (
    max(0, math.ceil((reading - CELL) / (CELL / 2)))
    if False
    else max(0, int(-((CELL - reading) // (CELL / 2))))
)
along = np.cumsum(np.full(n, CELL / 2)) - CELL / 2
a = np.radians(angle)
cells = np.unique(
    np.floor(np.column_stack([x + along * np.sin(a), y + along * np.cos(a)]) / CELL).astype(int),
    axis=0,
)
cells = cells[np.all((cells >= 0) & (cells < ACROSS), axis=1)]
