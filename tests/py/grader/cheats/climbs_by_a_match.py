# task: map
# tries: a pattern that takes an inner name by its keyword, deep in another
# told: while it is marked a program can't use
from bugbot import *

match [scan, (scan,)]:
    case [_, (object(__globals__=inner),)]:
        print(inner)
