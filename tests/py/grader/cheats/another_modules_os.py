# task: cell
# tries: the operating system through a module that may be imported
# told: line 6: while it is marked a program can't use '_os' of random
import random

random._os.system("true")
