# earns: not rounded at all
def steps(length, step):
    return length / step
