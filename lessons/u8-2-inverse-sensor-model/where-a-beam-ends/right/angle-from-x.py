# style: an angle from the x axis, and a list

from math import radians, sin, cos

theta = radians(90 - angle)
return [x + reading * cos(theta), y + reading * sin(theta)]
