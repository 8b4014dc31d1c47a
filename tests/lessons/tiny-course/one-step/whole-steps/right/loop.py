# style: a loop
n = 0
while (n + 1) * step <= length:
    n += 1
return n
