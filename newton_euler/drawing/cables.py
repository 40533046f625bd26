"""The route of a cable: straight spans, tangent to the pulleys, and arcs on the pulleys between
them.
"""

import math
from dataclasses import dataclass
from itertools import pairwise, product

from ..algebra.vectors import FrameError, cross3, dot3, scale3, sub3
from .projection import norm3, on_circle


@dataclass(frozen=True)
class Pulley:
    """The circle on a pulley on which a cable runs, of ``radius`` about ``centre``, perpendicular
    to ``normal``; triples.
    """

    centre: tuple
    normal: tuple
    radius: float


def route(stops, turns=None):
    """The spans, a pair of places between each two stops, and the arcs, a list of places for each
    stop (empty unless that is a pulley).

    stops : triples and pulleys; a route that ends on the pulley it began with is closed, and a belt
    turns : for each pulley 1 or -1, the way the cable goes round it, right-handed about its normal
        or not; by default the shortest
    """
    turned = [n for n, stop in enumerate(stops) if isinstance(stop, Pulley)]
    closed = len(stops) > 2 and stops[0] is stops[-1] and 0 in turned
    free = turned[: len(turned) - closed]
    if turns is not None and (len(turns) != len(free) or set(turns) - {1, -1}):
        raise FrameError(
            f"turns names for each of the {len(free)} pulleys on the way 1 or -1, right-handed "
            f"about its normal or not; got {turns!r}"
        )
    if len(free) > 10 and turns is None:
        raise FrameError(
            f"over {len(free)} pulleys the way is not searched for: say how it goes round "
            "each, as in turns=[1, -1, ...]"
        )
    routes, failure = [], None
    for signs in [turns] if turns is not None else product((1, -1), repeat=len(free)):
        ways = dict(zip(free, signs, strict=True))
        if closed:
            ways[len(stops) - 1] = ways[0]
        try:
            routes.append(_route_with_turns(stops, ways, closed))
        except FrameError as error:
            failure = error
    if not routes:
        raise failure
    shortest = min(length for length, *_ in routes)
    # of equally long ones always the first
    return next(lines for length, *lines in routes if length <= shortest * (1 + 1e-9))


def _route_with_turns(stops, ways, closed):
    """The length, the spans and the arcs with the given turns."""
    spans = [
        _span(stops[n], ways.get(n), stops[n + 1], ways.get(n + 1)) for n in range(len(stops) - 1)
    ]
    arcs = [[] for _ in stops]
    for n, ((_, arrival), (leaving, _)) in enumerate(pairwise(spans), 1):
        if n in ways:
            arcs[n] = _arc(stops[n], ways[n], arrival, leaving)
    if closed:
        arcs[0] = _arc(stops[0], ways[0], spans[-1][1], spans[0][0])
    length = sum(norm3(sub3(q, p)) for line in [*spans, *arcs] for p, q in pairwise(line))
    return length, spans, arcs


def _span(a, turn_a, b, turn_b):
    """The straight part between two stops, a pair of places, by fixed-point iteration: a tangent
    point moves along the span when the other end moves, so that this converges at once.
    """
    P, Q = (stop.centre if isinstance(stop, Pulley) else stop for stop in (a, b))
    for _ in range(50):
        before = P, Q
        P = _tangent_point(a, Q, -turn_a) if isinstance(a, Pulley) else P
        Q = _tangent_point(b, P, turn_b) if isinstance(b, Pulley) else Q
        if norm3(sub3(P, before[0])) + norm3(sub3(Q, before[1])) <= 1e-12 * norm3(sub3(Q, P)):
            break
    return P, Q


def _tangent_point(pulley, P, turn):
    """The point of the pulley at which a line from P is tangent and goes on in the sense ``turn``;
    of a span that leaves, P is the far end and the sense the opposite one.
    """
    v = sub3(P, pulley.centre)
    v = sub3(v, scale3(dot3(v, pulley.normal), pulley.normal))
    distance = norm3(v)
    if distance <= pulley.radius:
        raise FrameError(
            f"no cable runs from {P} to a pulley about {pulley.centre}: it lies within the "
            f"radius {pulley.radius:g}"
        )
    e1 = scale3(1 / distance, v)
    return on_circle(
        pulley.centre,
        e1,
        cross3(pulley.normal, e1),
        pulley.radius,
        turn * math.acos(pulley.radius / distance),
    )


def _arc(pulley, turn, arrival, leaving):
    """Places along the pulley, from the point where the cable arrives to the point where it leaves."""
    a, b = sub3(arrival, pulley.centre), sub3(leaving, pulley.centre)
    angle = turn * math.atan2(dot3(pulley.normal, cross3(a, b)), dot3(a, b)) % (2 * math.pi)
    if angle > 2 * math.pi - 1e-6:  # a straight cable that only just touches, but for rounding
        angle = 0.0
    e1, count = scale3(1 / pulley.radius, a), 1 + math.ceil(angle / math.radians(6))
    e2 = cross3(pulley.normal, e1)
    return [
        on_circle(pulley.centre, e1, e2, pulley.radius, turn * angle * n / count)
        for n in range(count + 1)
    ]
