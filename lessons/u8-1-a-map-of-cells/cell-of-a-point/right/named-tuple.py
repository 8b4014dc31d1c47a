# style: a named tuple

from collections import namedtuple

Cell = namedtuple("Cell", "column row")
return Cell(column=math.floor(x / CELL), row=math.floor(y / CELL))
