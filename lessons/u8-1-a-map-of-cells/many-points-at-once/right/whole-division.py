# style: whole division

cells = points // CELL
keep = np.logical_and(cells >= 0, cells < ACROSS).sum(axis=1) == 2
cells = cells[keep].astype(np.int32)
