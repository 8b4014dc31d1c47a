# style: points sorted out before they become cells

inside = ((points >= 0) & (points < CELL * ACROSS)).all(axis=1)
cells = (points[inside] // CELL).astype(int)
