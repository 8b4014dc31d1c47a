/** Small programs for the stories, each for one thing to see. */

/** Two seconds of turning, a look every half second, one line printed. */
export const LOOK_ROUND = `from bugbot import *

left(30)
for i in range(4):
    wait(0.5)
    near = [cm for angle, cm in scan() if cm < 200]
    plot("beams that found something", len(near))
    draw("free", [(102.5, 102.5), (107.5, 102.5)], colour="#9ecae1", shape="squares", size=5)
stop()
print("looked round")
`;

export const NEVER_ENDS = `from bugbot import *

print("off we go")
while True:
    pass
`;

export const FAILS_ON_LINE_4 = `from bugbot import *

wait(1)
print(nothing_of_this_name)
`;
