# task: map
# tries: a perfect map of the world, which it has from elsewhere, without looking
# told: known cells lie where no beam has been
from bugbot import *

REAL = [(130, 70, 8, 70), (40, 150, 70, 8)]


def is_real(x, y):
    return any(a <= x <= a + w and b <= y <= b + h for a, b, w, h in REAL)


middles = [(5 * column + 2.5, 5 * row + 2.5) for row in range(40) for column in range(40)]
draw("free", [each for each in middles if not is_real(*each)], "#9ecae1", "squares", 5)
draw("occupied", [each for each in middles if is_real(*each)], "black", "squares", 5)
