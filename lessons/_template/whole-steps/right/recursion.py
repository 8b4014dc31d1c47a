# style: recursion
def steps(length, step):
    return 0 if length < step else 1 + steps(length - step, step)
