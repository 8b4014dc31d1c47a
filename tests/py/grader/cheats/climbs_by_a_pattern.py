# task: map
# tries: the same, with a match statement
# told: while it is marked a program can't use .__globals__
from bugbot import *

match scan:
    case object(__globals__=inner):
        print(inner)
