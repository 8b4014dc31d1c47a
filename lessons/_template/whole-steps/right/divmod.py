# style: divmod, and a whole number from a float
def steps(length, step):
    whole, left_over = divmod(length, step)
    return int(whole)
