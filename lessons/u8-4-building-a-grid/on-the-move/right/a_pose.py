# style: a dataclass for the pose, a clock for the loop
from dataclasses import dataclass


@dataclass
class Pose:
    x: float
    y: float
    facing: float

    @classmethod
    def now(cls):
        return cls(*(start + moved for start, moved in zip(START, position())), heading())


def look():
    """Add one scan to the map, from where the robot is now."""
    pose = Pose.now()
    for beam in scan():
        add_beam(pose.x, pose.y, pose.facing + beam[0], beam[1])


def drive_and_map():
    """Drive the circle, and look ten times a second."""
    begin = clock()
    drive(100, 0, 25)
    while clock() - begin < 12:
        look()
        wait(0.1)
    stop()
