# task: numbers
# tries: to change its answer when it has been given
# told: total([1, 2, 3]) gives 6
answer = [0]


def total(numbers):
    answer[0] = sum(numbers)
    return (each for each in answer)
