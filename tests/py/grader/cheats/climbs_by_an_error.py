# task: map
# tries: to climb from an error to the frames that raised it
# told: while it is marked a program can't use .__traceback__
from bugbot import *

try:
    forward("x")
except Exception as error:
    frame = error.__traceback__
