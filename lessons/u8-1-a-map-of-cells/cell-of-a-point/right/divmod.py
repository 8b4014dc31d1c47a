# style: divmod

column, row = (int(divmod(value, CELL)[0]) for value in (x, y))
