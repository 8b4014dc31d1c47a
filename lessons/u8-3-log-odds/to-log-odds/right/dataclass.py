# style: a dataclass for odds

from dataclasses import dataclass


@dataclass
class Odds:
    value: float

    def p(self):
        return self.value / (1 + self.value)


def log_odds(p):
    odds = Odds(p / (1 - p))
    return math.log(odds.value)


def probability(l):
    return Odds(math.e**l).p()
