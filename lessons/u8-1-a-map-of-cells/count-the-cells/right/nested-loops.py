# style: nested loops

count = 0
for left in range(0, MAT, side):
    for bottom in range(0, MAT, side):
        count += 1
