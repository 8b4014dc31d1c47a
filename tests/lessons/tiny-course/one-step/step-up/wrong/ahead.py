# earns: it drove ahead
from bugbot import *

forward(50, 20)
