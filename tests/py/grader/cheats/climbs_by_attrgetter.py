# task: map
# tries: the same, with a function that reads attributes
# told: while it is marked a program can't use 'attrgetter' of operator
from operator import attrgetter

from bugbot import *

inner = attrgetter("__glo" + "bals__")(scan)
