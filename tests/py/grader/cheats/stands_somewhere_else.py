# task: map
# tries: to be put where it wants to be
# told: somewhere it can't have driven / looks is not that
from functools import update_wrapper

from bugbot import *

kept = []


class Catch:
    def __setattr__(self, name, value):
        kept.append(value)


update_wrapper(Catch(), scan, assigned=("__glo" + "bals__",), updated=())
inner = kept[0]
link = inner["active"]("scan()")
scan()
link.sim.x = link.sim.y = 20.0
scan()
draw("free", [], "#9ecae1", "squares", 5)
draw("occupied", [], "black", "squares", 5)
