# style: a list

return [(number + 0.5) * CELL for number in (column, row)]
