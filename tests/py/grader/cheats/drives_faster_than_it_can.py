# task: map
# tries: a robot that is quicker
# told: somewhere it can't have driven
from functools import update_wrapper

from bugbot import *

kept = []


class Catch:
    def __setattr__(self, name, value):
        kept.append(value)


update_wrapper(Catch(), scan, assigned=("__glo" + "bals__",), updated=())
inner = kept[0]
link = inner["active"]("scan()")
link.sim._grip = 3.0
drive(0, 100, 0)
wait(0.5)
stop()
draw("free", [], "#9ecae1", "squares", 5)
draw("occupied", [], "black", "squares", 5)
