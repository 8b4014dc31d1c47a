"""find_frontier(free, occupied): the free cells with an unknown cell at a side."""

from grader import check, function
from mapping.frontiers import State, frontier_cells
from mapping.grid import Grid

MAT = Grid(10)
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
AROUND = [*SIDES, (-1, -1), (1, -1), (-1, 1), (1, 1)]
CELLS = {MAT.cell(index) for index in range(len(MAT.cells))}


def reference(free, occupied):
    states = [
        State.FREE if cell in free else State.OCCUPIED if cell in occupied else State.UNKNOWN
        for cell in map(MAT.cell, range(len(MAT.cells)))
    ]
    return {MAT.cell(index) for index in frontier_cells(MAT, states)}


def missing(side):
    """Only three of the four sides were looked at."""
    steps = [each for each in SIDES if each != side]
    return lambda free, occupied: beside(free, CELLS - free - occupied, steps)


def round_the_edge(free, occupied):
    """The cells beyond an edge are taken from the other side, as a list does with -1."""
    unknown = CELLS - free - occupied
    return {
        (c, r) for c, r in free if any(((c + i) % 20, (r + j) % 20) in unknown for i, j in SIDES)
    }


def cut_mat(first, last):
    """A mat whose columns and rows go from first to last only."""
    mat = {(c, r) for c, r in CELLS if first <= c <= last and first <= r <= last}
    return lambda free, occupied: beside(free, mat - free - occupied)


def beside(cells, others, steps=SIDES):
    """The cells that have one of the others beside them."""
    return {(c, r) for c, r in cells if any((c + i, r + j) in others for i, j in steps)}


find_frontier = function(
    "find_frontier(free, occupied)",
    reference,
    cell_cm=10,
    leaves=True,
    mistakes=[
        (
            "off the mat there is nothing to explore: only cells of the mat can be unknown",
            lambda free, occupied: {
                (c, r)
                for c, r in free
                if any((c + i, r + j) not in free | occupied for i, j in SIDES)
            },
            1,
        ),
        (
            "walls were taken for unknown: an occupied cell is known",
            lambda free, occupied: beside(free, CELLS - free),
            0,
        ),
        (
            "cells at a corner were counted: only the four at the sides count",
            lambda free, occupied: beside(free, CELLS - free - occupied, AROUND),
            2,
        ),
        (
            "these are the unknown cells beside free ones: "
            "a frontier cell is free, so the robot can go there",
            lambda free, occupied: beside(CELLS - free - occupied, free),
            0,
        ),
        (
            "walls were counted as frontier: a frontier cell is free",
            lambda free, occupied: beside(free | occupied, CELLS - free - occupied),
            0,
        ),
        (
            "only cells with nothing but unknown round them were found: one unknown side is enough",
            lambda free, occupied: {
                (c, r)
                for c, r in free
                if all((c + i, r + j) in CELLS - free - occupied for i, j in SIDES)
            },
            2,
        ),
        ("these are all the free cells: an unknown cell must be beside them", lambda f, o: f, 0),
        ("these are the unknown cells: a frontier cell is free", lambda f, o: CELLS - f - o, 0),
        ("the left side is missing: look at all four", missing((-1, 0)), 2),
        ("the right side is missing: look at all four", missing((1, 0)), 2),
        ("the lower side is missing: look at all four", missing((0, -1)), 2),
        ("the upper side is missing: look at all four", missing((0, 1)), 2),
        (
            "a cell at the edge was given a neighbour from the other edge: off the mat "
            "there are no cells",
            round_the_edge,
            1,
        ),
        (
            "the last column and the last row are missing: they have the number ACROSS - 1",
            cut_mat(0, 18),
            1,
        ),
        (
            "the first column and the first row are missing: they have the number 0",
            cut_mat(1, 19),
            1,
        ),
    ],
)


SMALL_MAT = {(column, row) for column in range(10) for row in range(10)}
ON_A_SMALL_MAT = function(
    "find_frontier(free, occupied)",
    lambda free, occupied: beside(free, SMALL_MAT - free - occupied),
    cell_cm=20,
    leaves=True,
    mistakes=[
        (
            "20 was typed in: ACROSS says how many cells lie side by side",
            lambda free, occupied: beside(free, CELLS - free - occupied),
            1,
        ),
    ],
)


def some_map(task, share):
    cells = sorted(CELLS)
    task.random.shuffle(cells)
    free = round(share * len(cells))
    return set(cells[:free]), set(cells[free : free + 80])


@check("Free on the left, unknown on the right", hint=0)
def halves(task):
    left = {cell for cell in CELLS if cell[0] < 10}
    task.call(find_frontier, left, set(), gives={(9, row) for row in range(20)})
    wall = {(9, row) for row in range(5, 20)}
    task.call(find_frontier, left - wall, wall, gives={(9, row) for row in range(5)})


@check("A mat that is all free", hint=1)
def all_free(task):
    task.call(find_frontier, CELLS, set(), gives=set())


@check("One free cell, or none", hint=0)
def few(task):
    task.call(find_frontier, set(), set(), gives=set())
    for cell in ((0, 0), (19, 19), (0, 19), (7, 12)):
        task.call(find_frontier, {cell}, set(), gives={cell})
        task.call(find_frontier, {cell}, CELLS - {cell}, gives=set())
    task.call(find_frontier, CELLS - {(0, 8), (19, 3), (5, 0), (9, 19)}, set())


@check("Cells strewn about", hint=2)
def strewn(task):
    for share in (0.2, 0.5, 0.7):
        task.call(find_frontier, *some_map(task, share))


@check("A mat of 10 by 10 cells", hint=1)
def small_mat(task):
    task.set("ACROSS", 10)
    task.call(ON_A_SMALL_MAT, SMALL_MAT, set(), gives=set())
    task.call(ON_A_SMALL_MAT, SMALL_MAT - {(9, 9)}, set(), gives={(8, 9), (9, 8)})
