# style: new sets in place of the old ones

global free, hits
x, y = START[0] + position()[0], START[1] + position()[1]
says = [beam_says(x, y, heading() + angle, reading) for angle, reading in scan()]
free = free.union(*(passed for passed, _ in says))
hits = hits | {hit for _, hit in says if hit is not None}
