# style: a class that adds points up one by one, and sums instead of means
class Line:
    def __init__(self):
        self.n = self.x = self.y = self.xx = self.yy = self.xy = 0

    def add(self, x, y):
        self.n += 1
        self.x += x
        self.y += y
        self.xx += x * x
        self.yy += y * y
        self.xy += x * y

    def direction(self):
        sxx = self.xx - self.x * self.x / self.n
        syy = self.yy - self.y * self.y / self.n
        sxy = self.xy - self.x * self.y / self.n
        turned = math.atan2(2 * sxy, syy - sxx) / 2
        if turned < 0:
            turned += math.pi
        return turned * 180 / math.pi


def wall_direction(looks):
    line = Line()
    for facing, readings in looks:
        for angle, reading in readings:
            if reading >= FAR:
                continue
            way = math.radians(90 - facing - angle)
            line.add(reading * math.cos(way), reading * math.sin(way))
    return line.direction()


def drift_rate(first, second, seconds):
    turned = wall_direction(second) - wall_direction(first)
    while turned > 90:
        turned -= 180
    while turned < -90:
        turned += 180
    return turned / seconds
