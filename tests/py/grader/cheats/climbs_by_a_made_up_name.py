# task: map
# tries: the same, with the name put together so that nobody sees it
# told: while it is marked getattr() must be called with a name in quotes
from bugbot import *

inner = getattr(scan, "__glo" + "bals__")
