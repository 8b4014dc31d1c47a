# style: whole division of negative numbers

across = -(-MAT // side)
count = across**2
