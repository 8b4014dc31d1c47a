# style: a generator


def walk():
    along = 0
    while along < reading - CELL:
        yield cell_of(*end_of_beam(x, y, angle, along))
        along += CELL / 2


cells = [cell for cell in walk() if cell]
