"""4/34: the angular motion of a disk in a turning bracket, constant rates."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove = device.solve_turning, device.turning_steps, device.prove_turning
draw = device.figure
follows = {"alpha_disk": device.alpha_disk}


def mistakes(g):
    omega, alpha = solve(g).values()
    return {
        "alpha_zero": {"alpha_disk": 0 * alpha},
        "P_cross_omega": {"alpha_disk": -alpha},
        "only_P": {"omega_disk": omega.without("bracket")},
    }
