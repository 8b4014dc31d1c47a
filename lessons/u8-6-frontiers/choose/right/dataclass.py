# style: a dataclass for a region
from dataclasses import dataclass


@dataclass
class Region:
    here: tuple
    cells: set

    def nearest(self):
        return list(min((dist(self.here, cell), cell) for cell in self.cells)[1])

    def worth(self, gain):
        return gain * len(self.cells) - dist(self.here, self.nearest())


def nearest_cell(here, region):
    return Region(here, region).nearest()


def choose(here, regions, gain):
    all_regions = [Region(here, each) for each in regions]
    if all_regions:
        return max(all_regions, key=lambda each: each.worth(gain)).nearest()
