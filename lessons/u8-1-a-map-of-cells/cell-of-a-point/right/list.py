# style: a list

return [math.floor(value / CELL) for value in (x, y)]
