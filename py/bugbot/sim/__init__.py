"""The simulated robot on its mat: where it goes, what it sees, what it believes.

May import: the standard library, `bugbot.errors`, `bugbot.frames`, `bugbot.trace` and
`bugbot.worlds`. It knows nothing of programs: `bugbot.link` drives it.

    simulator.py   one robot in one world: commands in, events out
    world.py       a world's rectangles, laid out for quick questions
    motion.py      speeds, and where a moving circle first touches something
    depth.py       the eight beams of the depth sensor
    odometry.py    dead reckoning: what the robot believes it did
    rounding.py    what makes every engine keep the same numbers
    noise.py       the seeded generators and how strong each noise is
"""
