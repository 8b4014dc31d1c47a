# A look ahead: the same distance, read again and again.

from bugbot import *

# Numbers to change
LOOKS = 20  # how often the robot looks (1 to 100)

readings = []
for look in range(LOOKS):
    readings.append(distance())
    plot("reading [cm]", readings[-1])
    wait(0.1)

print("mean:", round(sum(readings) / len(readings), 1))
print("nearest:", min(readings))
