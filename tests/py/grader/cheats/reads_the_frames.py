# task: map
# tries: the simulator's own variables, through the frame of a generator
# told: while it is marked a program can't use .gi_frame


def look():
    yield


frame = look().gi_frame
