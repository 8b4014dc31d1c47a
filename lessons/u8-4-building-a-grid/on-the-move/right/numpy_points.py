# style: NumPy, all points of a scan at once
import numpy as np

ALONG = np.arange(0, FAR, CELL / 2)


def look():
    """Add one scan to the map, from where the robot is now."""
    global log_odds
    x, y = np.array(START) + np.array(position())
    angles, readings = np.array(scan()).T
    ways = np.radians(heading() + angles)[:, None]
    clear = np.where(readings < FAR, readings - CELL, FAR)[:, None]
    cells = np.array(log_odds)
    for lengths, marked, weight in (
        (np.broadcast_to(ALONG, (8, len(ALONG))), ALONG < clear, L_FREE),
        (readings[:, None], readings[:, None] < FAR, L_OCC),
    ):
        columns = np.floor((x + lengths * np.sin(ways)) / CELL).astype(int)[marked]
        rows = np.floor((y + lengths * np.cos(ways)) / CELL).astype(int)[marked]
        on = (0 <= columns) & (columns < ACROSS) & (0 <= rows) & (rows < ACROSS)
        np.add.at(cells, rows[on] * ACROSS + columns[on], weight)
    log_odds = np.clip(cells, -L_MAX, L_MAX).tolist()


def drive_and_map():
    """Drive the circle, and look ten times a second."""
    drive(100, 0, 25)
    for tick in range(120):
        look()
        if tick % 10 == 0:
            show()
        wait(0.1)
    stop()
