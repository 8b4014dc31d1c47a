# style: lists of lists

table = grid.tolist()
for i in range(len(rows)):
    table[rows[i]][columns[i]] += evidence
return [[max(-limit, min(limit, value)) for value in row] for row in table]
