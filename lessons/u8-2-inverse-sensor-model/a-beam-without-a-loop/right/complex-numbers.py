# style: complex numbers

z = complex(x, y) + np.arange(0, reading - CELL, CELL / 2) * np.exp(1j * np.radians(90 - angle))
cells = np.column_stack([z.real // CELL, z.imag // CELL]).astype(int)
cells = cells[np.all((cells >= 0) & (cells < ACROSS), axis=1)]
