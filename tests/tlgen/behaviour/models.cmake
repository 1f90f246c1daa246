# The models of this folder: how each is called.
add_behaviour(loops DOF n SIZES n=3 repeat=4 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(branches DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(assignment DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(by_value DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(out_parameters DOF 2 LAGRANGIAN "lagrangian(q, qd, t, out)")
add_behaviour(structs DOF bodies SIZES bodies=2 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(arrays DOF 3 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(pointers DOF 3 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(tables DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(functions DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(activity DOF n SIZES n=2 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(names DOF 2 SIZES result=3 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params" ARGS p=params)
add_behaviour(scopes DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(integers DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(iteration DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(time DOF 1 SIZES harmonics=3 LAGRANGIAN "out[0] = lagrangian(t, &params, qd, q)" FORCE "drag(qd, t, out)" HOLONOMIC "out[0] = ahead(q, t)"
  PARAMS "&params")
add_behaviour(constraints DOF coordinates SIZES coordinates=4 links=2 LAGRANGIAN "out[0] = energy(&params, q, qd)" FORCE "friction(qd, &params, out)"
  HOLONOMIC "links: rods(q, t, &params, out)" "out[0] = ground(q)" NONHOLONOMIC "3: rolling(q, qd, t, &params, out)" "out[0] = sleigh(q, qd)"
  PARAMS "&params")
add_behaviour(marks MARKED DOF 2 SIZES links=2 LAGRANGIAN "action(out, &params, qd, q)" FORCE "push(qd, out)" HOLONOMIC "links: loop(q, &params, t, out)"
  PARAMS "&params")
add_behaviour(dissipation DOF n SIZES n=3 LAGRANGIAN "out[0] = energy(q, qd, &params)" FORCE "drive(t, &params, out)"
  DISSIPATION "losses(&params, q, qd, t, out)" HOLONOMIC "out[0] = closure(q)" PARAMS "&params")
add_behaviour(constant_force MARKED DOF 2 LAGRANGIAN "out[0] = energy(q, qd)" FORCE "weights(&params, out)" DISSIPATION "out[0] = oil(qd)"
  PARAMS "&params")
add_behaviour(order DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(aliases DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(two_files HELPERS other_file two_files_scale two_files_table FILES two_files_helper.c DOF 1 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(passive DOF n SIZES n=1 LAGRANGIAN "out[0] = lagrangian(q, &params)" FORCE "push(q, qd, out)" HOLONOMIC "2: fixed(q, out)"
  NONHOLONOMIC "out[0] = zero(qd)" PARAMS "&params")
add_behaviour(literals DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(pointer_arrays DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd)")
add_behaviour(jumps DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd)")
add_behaviour(variable_length DOF n SIZES n=2 LAGRANGIAN "out[0] = lagrangian(q, qd, &params)" PARAMS "&params")
add_behaviour(scalars DOF 2 LAGRANGIAN "out[0] = lagrangian(qd[0], q[0], q[1], qd[1], t)" FORCE "push(q[0], q[1], out)"
  ARGS q=x,y qd=xd,yd)
add_behaviour(recursive DOF 2 SIZES depth=4 LAGRANGIAN "out[0] = lagrangian(q, qd, &params)" PARAMS "&params" RECURSION branch:depth even:6)
add_behaviour(copies DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(callbacks DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)" RECURSION power:4)
add_behaviour(steps DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(rules DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)" RULES rules_bump:rules_bump_taylor EXTERNAL rules_external.c)
add_behaviour(mixed_structs DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(floats SINGLE DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
# its functions differ from library to library
add_behaviour(float_functions SINGLE VALUE_RTOL 1e-6 DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(sound DOF 2 SIZES dim=2 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(temporaries DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(literal_values DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd)")
add_behaviour(else_if DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd)")
add_behaviour(optional DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(habits DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
