"""4/37: the angular motion of a disk in a turning bracket, increasing rates."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove = device.solve_turning, device.turning_steps, device.prove_turning
draw = device.figure
follows = {"alpha_disk": device.alpha_disk}


def mistakes(g):
    alpha = solve(g)["alpha_disk"]
    return {
        "no_product": {"alpha_disk": alpha.without("bracket x disk")},
        "product_reversed": {"alpha_disk": alpha.reweighted(**{"bracket x disk": -1})},
        "no_omega_dot": {"alpha_disk": alpha.without("bracket")},
        "no_P_dot": {"alpha_disk": alpha.without("disk")},
    }
