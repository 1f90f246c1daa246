# The models of this folder: how each is called.
add_behaviour(loops DOF 3 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(branches DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
