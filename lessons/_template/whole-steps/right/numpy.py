# style: NumPy
def steps(length, step):
    import numpy as np

    return np.floor(length / step).astype(int)
