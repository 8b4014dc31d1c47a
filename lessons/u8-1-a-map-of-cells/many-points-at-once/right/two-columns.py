# style: a comprehension over the two columns, and a loop over two answers

columns, rows = (np.floor(v / CELL).astype(int) for v in points.T)
good = np.ones(len(points), dtype=bool)
for numbers in (columns, rows):
    good &= (numbers >= 0) & (numbers < ACROSS)
cells = np.column_stack([columns, rows])[good]
