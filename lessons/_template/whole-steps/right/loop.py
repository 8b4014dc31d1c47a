# style: a loop that takes one step after another
def steps(length, step):
    count = 0
    while (count + 1) * step <= length:
        count += 1
    return count
