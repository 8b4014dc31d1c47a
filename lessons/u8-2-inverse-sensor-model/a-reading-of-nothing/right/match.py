# style: match

match reading < FAR:
    case True:
        length, end = reading - CELL, reading
    case False:
        length, end = FAR, math.inf
free = cells_along(x, y, angle, length)
hit = cell_of(*end_of_beam(x, y, angle, end)) if end < FAR else None
