# style: NumPy: all points at once, the evidence one after the other
import numpy as np


def add_beam(log_odds, x, y, angle, reading):
    hit = reading < FAR
    along = np.arange(0, reading - CELL if hit else FAR, CELL / 2)
    weights = np.full(len(along), L_FREE)
    if hit:
        along = np.append(along, reading)
        weights = np.append(weights, L_OCC)
    columns = np.floor((x + along * np.sin(np.radians(angle))) / CELL).astype(int)
    rows = np.floor((y + along * np.cos(np.radians(angle))) / CELL).astype(int)
    good = (columns >= 0) & (columns < ACROSS) & (rows >= 0) & (rows < ACROSS)
    for cell, weight in zip((rows * ACROSS + columns)[good], weights[good]):
        log_odds[cell] = np.clip(log_odds[cell] + weight, -L_MAX, L_MAX)
