"""A world's solids, laid out once for the many questions a run asks of them.

May import: the standard library, `bugbot.worlds`.
"""

from __future__ import annotations

from bugbot.worlds import World

__all__ = ["Box", "boxes_of"]

Box = tuple[float, float, float, float]
"""A solid rectangle: left, bottom, right, top [cm]. Its edges belong to it."""


def boxes_of(world: World) -> tuple[Box, ...]:
    """The obstacles as plain corners: rays and collisions compare with nothing else."""
    return tuple(
        (each.x, each.y, each.x + each.width, each.y + each.height) for each in world.obstacles
    )
