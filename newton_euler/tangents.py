"""Where a cable runs: straight between places, tangent to the pulleys on its way, and round these as far as it lies on them."""

import math
from dataclasses import dataclass
from itertools import pairwise, product

from .projection import norm3, on_circle
from .vectors import FrameError, cross3, dot3, scale3, sub3


@dataclass(frozen=True)
class Pulley:
    """A pulley as a cable meets it: the circle of ``radius`` about ``centre`` on which it runs, across ``normal``; triples."""

    centre: tuple
    normal: tuple
    radius: float


def route(stops, turns=None):
    """The legs, a pair of places between each two stops, and the arcs, a list of places for each stop (empty but on pulleys).

    stops : triples and pulleys; a route that ends on the pulley it began with is closed, and a belt
    turns : for each pulley 1 or -1, the way the cable goes round it, right-handed about its normal or not; by default the shortest
    """
    turned = [n for n, stop in enumerate(stops) if isinstance(stop, Pulley)]
    closed = len(stops) > 2 and stops[0] is stops[-1] and 0 in turned
    free = turned[: len(turned) - closed]
    if turns is not None and (len(turns) != len(free) or set(turns) - {1, -1}):
        raise FrameError(f"turns names for each of the {len(free)} pulleys on the way 1 or -1, right-handed about its normal or not; got {turns!r}")
    if len(free) > 10 and turns is None:
        raise FrameError(f"over {len(free)} pulleys the way is not searched for: say how it goes round each, as in turns=[1, -1, ...]")
    shortest, why = None, None
    for signs in [turns] if turns is not None else product((1, -1), repeat=len(free)):
        ways = dict(zip(free, signs, strict=True))
        if closed:
            ways[len(stops) - 1] = ways[0]
        try:
            found = _one_way(stops, ways, closed)
        except FrameError as error:
            why = error
        else:
            if shortest is None or found[0] < shortest[0] * (1 - 1e-9):
                shortest = found
    if shortest is None:
        raise why
    return shortest[1:]


def _one_way(stops, ways, closed):
    """Length, legs and arcs with the given turns."""
    legs = [_leg(stops[n], ways.get(n), stops[n + 1], ways.get(n + 1)) for n in range(len(stops) - 1)]
    arcs = [[] for _ in stops]
    for n, ((_, arrival), (leaving, _)) in enumerate(pairwise(legs), 1):
        if n in ways:
            arcs[n] = _arc(stops[n], ways[n], arrival, leaving)
    if closed:
        arcs[0] = _arc(stops[0], ways[0], legs[-1][1], legs[0][0])
    length = sum(norm3(sub3(q, p)) for line in [*legs, *arcs] for p, q in pairwise(line))
    return length, legs, arcs


def _leg(a, turn_a, b, turn_b):
    """The straight part between two stops. Touching points move along the leg when the other end does, so that this settles at once."""
    P, Q = (stop.centre if isinstance(stop, Pulley) else stop for stop in (a, b))
    for _ in range(50):
        before = P, Q
        P = _touch(a, Q, -turn_a) if isinstance(a, Pulley) else P
        Q = _touch(b, P, turn_b) if isinstance(b, Pulley) else Q
        if norm3(sub3(P, before[0])) + norm3(sub3(Q, before[1])) <= 1e-12 * norm3(sub3(Q, P)):
            break
    return P, Q


def _touch(pulley, P, turn):
    """Where a line from P touches the pulley and then turns with it; the line back from a cable that leaves turns the other way."""
    v = sub3(P, pulley.centre)
    v = sub3(v, scale3(dot3(v, pulley.normal), pulley.normal))
    distance = norm3(v)
    if distance <= pulley.radius:
        raise FrameError(f"no cable runs from {P} to a pulley about {pulley.centre}: it lies within the radius {pulley.radius:g}")
    e1 = scale3(1 / distance, v)
    return on_circle(pulley.centre, e1, cross3(pulley.normal, e1), pulley.radius, turn * math.acos(pulley.radius / distance))


def _arc(pulley, turn, arrival, leaving):
    """Places along the pulley from where the cable arrives to where it leaves it."""
    a, b = sub3(arrival, pulley.centre), sub3(leaving, pulley.centre)
    angle = turn * math.atan2(dot3(pulley.normal, cross3(a, b)), dot3(a, b)) % (2 * math.pi)
    if angle > 2 * math.pi - 1e-6:  # a straight cable that only just touches, but for rounding
        angle = 0.0
    e1, count = scale3(1 / pulley.radius, a), 1 + math.ceil(angle / math.radians(6))
    e2 = cross3(pulley.normal, e1)
    return [on_circle(pulley.centre, e1, e2, pulley.radius, turn * angle * n / count) for n in range(count + 1)]
