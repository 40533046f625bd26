"""2/28: a boom on a truck at constant speed."""

from exercises.devices.truck_boom import boom, draw, prove, solve, steps


def mistakes(g):
    ground, arm, _ = boom(g)
    right = solve(g)
    on_parked_truck = right["v_B"].without("origin")
    twice = 2 * arm.angular_velocity(ground).cross(g.v * ground.i)
    return {
        "no_truck": {"v_B": on_parked_truck},
        "not_resolved": {"v_B": on_parked_truck + g.v * right["v_B"].frame.i},
        "wrong_sign": {"v_B": solve(g.but(theta=-g.theta))["v_B"]},
        "no_coriolis": {"a_B": right["a_B"].without("coriolis")},
        "truck_in_v_rel": {"a_B": right["a_B"] + right["a_B"].frame.vector(*twice)},
    }
