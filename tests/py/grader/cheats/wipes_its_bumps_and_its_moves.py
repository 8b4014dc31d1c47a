# task: drive
# tries: to wipe out the drive into the wall as well
# told: somewhere it can't have driven / has a gap
from functools import update_wrapper

from bugbot import *

kept = []


class Catch:
    def __setattr__(self, name, value):
        kept.append(value)


update_wrapper(Catch(), scan, assigned=("__glo" + "bals__",), updated=())
inner = kept[0]
link = inner["active"]("scan()")
backward(100)
wait(12)
link.trace.events[:] = [each for each in link.trace.events if each[0] != "bump"]
link.trace.moves.clear()
