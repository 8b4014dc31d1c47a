# style: a while loop

across = 0
while across * side < MAT:
    across += 1
count = across * across
