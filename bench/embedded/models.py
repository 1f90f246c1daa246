"""The plants of docs/embedded.md: tlgen's arguments, and a case of numbers for parameters and state, none of them zero or alike."""
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent.parent
MODELS = PROJECT / "examples" / "models"


class Plant:
    def __init__(self, title, n, arguments, parameters):
        self.title, self.n, self.arguments = title, n, [str(a) for a in arguments]
        self.parameters = parameters  # {name: number or list of numbers}, in the order of the struct
        self.y = [0.3 + 0.25 * k for k in range(n)] + [0.7 - 0.15 * k for k in range(n)]

    def numbers(self):
        """All parameters in a row."""
        return [x for value in self.parameters.values() for x in (value if isinstance(value, list) else [value])]


PLANTS = {
    "cart_pole": Plant("cart-pole", 2, [MODELS / "cart_pole.c", "--lagrangian", "cart_pole_lagrangian", "--force", "cart_pole_force", "--dof", 2],
                       {"cart_mass": 1.2, "pole_mass": 0.3, "pole_length": 0.9, "gravity": 9.81, "push": 2.0, "cart_drag": 0.1,
                        "hinge_drag": 0.02}),
    "furuta": Plant("Furuta pendulum", 2, [PROJECT / "tests/tlgen/mechanics/furuta.c", "--lagrangian", "furuta_lagrangian", "--force",
                                           "furuta_force", "--dof", 2],
                    {"arm_mass": 0.257, "arm_length": 0.2159, "arm_com": 0.0619, "arm_inertia": 9.98e-4, "pend_mass": 0.127, "pend_com": 0.1556,
                     "pend_inertia_x": 1.2e-3, "pend_inertia_y": 1.1e-3, "pend_inertia_z": 2.0e-5, "resistance": 2.6, "motor_constant": 0.5376,
                     "arm_damping": 2.4e-3, "pend_damping": 2.4e-4, "gravity": 9.81}),
    "double_cart_pole": Plant("double cart-pole", 3, [MODELS / "double_cart_pole.c", "--lagrangian", "double_cart_pole_lagrangian", "--force",
                                                      "double_cart_pole_force", "--dof", 3],
                              {"cart_mass": 1.2, "pole_mass": [0.3, 0.4], "pole_length": [0.9, 0.7], "gravity": 9.81, "push": 2.0, "cart_drag": 0.1,
                               "hinge_drag": [0.02, 0.03]}),
    "chain": Plant("chain of six links", 6, [MODELS / "pendulum.c", "--lagrangian", "pendulum_lagrangian", "--dof", "n", "--size", "n=6"],
                   {"g": 9.81, "mass": [0.8, 1.1, 0.9, 1.2, 1.0, 0.7], "length": [0.9, 1.0, 0.8, 1.1, 0.95, 1.05]}),
}
