# task: map
# tries: the same, with a format that reads attributes
# told: while it is marked a program can't use __globals__ in a text
from bugbot import *

print("{0.__globals__}".format(scan))
