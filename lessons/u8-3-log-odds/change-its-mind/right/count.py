# style: itertools

from itertools import count


def hits_needed(l, l_occ):
    return next(n for n in count() if l + n * l_occ > KNOWN)
