# task: map
# tries: a sensor of its own that has seen everything
# told: known cells lie where no beam has been
import bugbot


def see_all():
    return [(angle, 100.0) for angle in range(-180, 180)]


bugbot.scan = see_all
middles = [(5 * column + 2.5, 5 * row + 2.5) for row in range(40) for column in range(40)]
bugbot.scan()
bugbot.draw("free", middles, "#9ecae1", "squares", 5)
bugbot.draw("occupied", [], "black", "squares", 5)
