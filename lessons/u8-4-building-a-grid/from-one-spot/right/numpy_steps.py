# style: NumPy, all steps of a beam at once
import numpy as np

log_odds = np.zeros(ACROSS * ACROSS)


def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    clear = FAR if reading >= FAR else max(reading - CELL, 0)
    along = np.arange(0, clear, CELL / 2)
    weights = np.full(along.size, L_FREE)
    if reading < FAR:
        along, weights = np.append(along, reading), np.append(weights, L_OCC)
    way = np.radians(angle)
    columns = np.floor((x + along * np.sin(way)) / CELL).astype(int)
    rows = np.floor((y + along * np.cos(way)) / CELL).astype(int)
    on = (columns >= 0) & (columns < ACROSS) & (rows >= 0) & (rows < ACROSS)
    np.add.at(log_odds, rows[on] * ACROSS + columns[on], weights[on])
    np.clip(log_odds, -L_MAX, L_MAX, out=log_odds)


def look():
    """Add one scan to the map, from where the robot is now."""
    place = np.array(START) + np.array(position())
    for angle, reading in scan():
        add_beam(*place, heading() + angle, reading)


def show():
    """Draw the map, and plot how much of it is known."""
    free = np.flatnonzero(log_odds < -KNOWN)
    occupied = np.flatnonzero(log_odds > KNOWN)
    draw("free", [centre(cell) for cell in free.tolist()], "#9ecae1", "squares", CELL)
    draw("occupied", [centre(cell) for cell in occupied.tolist()], "black", "squares", CELL)
    plot("known %", 100 * (free.size + occupied.size) / log_odds.size)
