# earns: rounded to the nearest whole number
def steps(length, step):
    return round(length / step)
