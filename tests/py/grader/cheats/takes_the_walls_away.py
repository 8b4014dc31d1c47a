# task: map
# tries: to see through walls
# told: its sensor has read what it can't read there
from functools import update_wrapper

from bugbot import *

kept = []


class Catch:
    def __setattr__(self, name, value):
        kept.append(value)


update_wrapper(Catch(), scan, assigned=("__glo" + "bals__",), updated=())
inner = kept[0]
link = inner["active"]("scan()")
link.sim._boxes = []
scan()
draw("free", [], "#9ecae1", "squares", 5)
draw("occupied", [], "black", "squares", 5)
