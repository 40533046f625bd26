"""The route of a cable: straight spans tangent to the pulleys, and arcs on the pulleys."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise, product

from ...algebra.scalars import Triple
from ...algebra.vectors import FrameError, cross3, dot3, scale3, sub3
from ..page.projection import moved, norm3, on_circle


@dataclass(frozen=True)
class Pulley:
    """The circle on which a cable runs: centre and normal are triples, the radius is in m."""

    centre: tuple
    normal: tuple
    radius: float


def route(
    stops: Sequence[Pulley | Triple], turns: Sequence[int] | None = None
) -> tuple[list[tuple[Triple, Triple]], list[list[Triple]]]:
    """The spans, a pair of places for each two neighbouring stops, and the arcs, a list of places
    for each stop (empty unless it is a pulley); stops and turns as in :meth:`.Machines.cable`.
    """
    turned = [n for n, stop in enumerate(stops) if isinstance(stop, Pulley)]
    closed = len(stops) > 2 and stops[0] is stops[-1] and 0 in turned
    free = turned[: len(turned) - closed]
    listed = isinstance(turns, (list, tuple)) and len(turns) == len(free)
    if turns is not None and not (listed and all(n in (1, -1) for n in turns)):
        raise FrameError(
            f"turns is 1 or -1 for each of {len(free)} pulleys, about its normal; got {turns!r}"
        )
    if len(free) > 10 and turns is None:  # at most 2**10 routes are compared
        raise FrameError(
            f"say how the cable goes round each of {len(free)} pulleys, as in turns=[1, -1, ...]"
        )
    routes, failures = [], []
    for signs in product((1, -1), repeat=len(free)) if turns is None else [turns]:
        ways = dict(zip(free, signs, strict=True))
        if closed:
            ways[len(stops) - 1] = ways[0]
        try:
            routes.append(_route_with_turns(stops, ways, closed))
        except FrameError as error:
            failures.append(error)
    if not routes:
        raise failures[-1]
    shortest = min(length for length, *_ in routes)
    # among equally long ones the first, whatever the round-off
    return next(lines for length, *lines in routes if length <= shortest * (1 + 1e-9))


def _route_with_turns(stops, ways, closed):
    """The length, the spans and the arcs with the given turns."""
    pairs = enumerate(pairwise(stops))
    spans = [_span(a, ways.get(n), b, ways.get(n + 1)) for n, (a, b) in pairs]
    arcs = [[] for _ in stops]
    for n, ((_, arrival), (leaving, _)) in enumerate(pairwise(spans), 1):
        if n in ways:
            arcs[n] = _arc(stops[n], ways[n], arrival, leaving)
    if closed:
        arcs[0] = _arc(stops[0], ways[0], spans[-1][1], spans[0][0])
    length = sum(norm3(sub3(q, p)) for line in [*spans, *arcs] for p, q in pairwise(line))
    return length, spans, arcs


def _span(a, turn_a, b, turn_b):
    """The straight part between two stops, a pair of places, by iteration; at once in a plane."""
    P, Q = (stop.centre if isinstance(stop, Pulley) else stop for stop in (a, b))
    for _ in range(50):
        before = P, Q
        P = _tangent_point(a, Q, -turn_a) if isinstance(a, Pulley) else P
        Q = _tangent_point(b, P, turn_b) if isinstance(b, Pulley) else Q
        if norm3(sub3(P, before[0])) + norm3(sub3(Q, before[1])) <= 1e-12 * norm3(sub3(Q, P)):
            break
    return P, Q


def _tangent_point(pulley, P, turn):
    """Where a cable from P arrives in the sense ``turn``; in the opposite sense it leaves to P."""
    C, n, r = pulley.centre, pulley.normal, pulley.radius
    v = sub3(P, C)
    v = moved(v, -dot3(v, n), n)
    distance = norm3(v)
    if distance <= r:
        raise FrameError(
            f"no cable runs from {P} to a pulley about {C}: it is within the radius {r:g}"
        )
    e1 = scale3(1 / distance, v)
    return on_circle(C, e1, cross3(n, e1), r, turn * math.acos(r / distance))


def _arc(pulley, turn, arrival, leaving):
    """Places along the pulley, every 6 degrees, from where the cable arrives to where it leaves."""
    C, r = pulley.centre, pulley.radius
    a, b = sub3(arrival, C), sub3(leaving, C)
    angle = turn * math.atan2(dot3(pulley.normal, cross3(a, b)), dot3(a, b)) % (2 * math.pi)
    if angle > 2 * math.pi - 1e-6:  # a straight cable that just touches: 0 less round-off
        angle = 0.0
    e1, count = scale3(1 / r, a), 1 + math.ceil(angle / math.radians(6))
    e2 = cross3(pulley.normal, e1)
    return [on_circle(C, e1, e2, r, turn * angle * n / count) for n in range(count + 1)]
