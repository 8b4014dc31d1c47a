# style: whole division, and cells as lists

dx, dy = last[0] - column, last[1] - row
n = max(abs(dx), abs(dy))
return [
    [column + (2 * k * dx + n) // (2 * n), row + (2 * k * dy + n) // (2 * n)]
    if n
    else [column, row]
    for k in range(n + 1)
]
