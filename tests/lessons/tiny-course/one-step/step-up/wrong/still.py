# earns: it never moved
from bugbot import *

stop()
