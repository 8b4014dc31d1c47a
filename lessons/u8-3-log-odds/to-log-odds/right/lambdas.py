# style: lambdas

log_odds = lambda p: math.log(p) - math.log1p(-p)
probability = lambda l: (1 + math.exp(-l)) ** -1
