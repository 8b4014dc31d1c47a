from bugbot import *

# Drive 20 cm up the mat.
