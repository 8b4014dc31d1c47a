# task: map
# tries: a map of all that is not known yet as free, without looking
# told: of its 1600 known cells lie where no beam has been
from bugbot import *

middles = [(5 * column + 2.5, 5 * row + 2.5) for row in range(40) for column in range(40)]
draw("free", middles, "#9ecae1", "squares", 5)
draw("occupied", [], "black", "squares", 5)
