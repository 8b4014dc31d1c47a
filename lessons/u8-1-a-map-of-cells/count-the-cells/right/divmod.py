# style: divmod

across, rest = divmod(MAT, side)
if rest > 0:
    across += 1
count = across * across
