# The models of this folder: how each is called.
add_behaviour(loops DOF n LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(branches DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(assignment DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(by_value DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(out_parameters DOF 2 LAGRANGIAN "lagrangian(q, qd, t, out)")
add_behaviour(structs DOF bodies LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(arrays DOF 3 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(pointers DOF 3 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(tables DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(functions DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(activity DOF n LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params")
add_behaviour(names DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t, &params)" PARAMS "&params" ARGS p=params)
add_behaviour(scopes DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(integers DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(iteration DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(time DOF 1 LAGRANGIAN "out[0] = lagrangian(t, &params, qd, q)" FORCE "drag(qd, t, out)" HOLONOMIC "out[0] = ahead(q, t)"
  PARAMS "&params")
add_behaviour(constraints DOF coordinates LAGRANGIAN "out[0] = energy(&params, q, qd)" FORCE "friction(qd, &params, out)"
  HOLONOMIC "links: rods(q, t, &params, out)" "out[0] = ground(q)" NONHOLONOMIC "3: rolling(q, qd, t, &params, out)" "out[0] = sleigh(q, qd)"
  PARAMS "&params")
add_behaviour(marks MARKED DOF 2 LAGRANGIAN "action(out, &params, qd, q)" FORCE "push(qd, out)" HOLONOMIC "links: loop(q, &params, t, out)"
  PARAMS "&params")
add_behaviour(order DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(aliases DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(two_files HELPERS other_file FILES two_files_helper.c DOF 1 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(passive DOF n LAGRANGIAN "out[0] = lagrangian(q, &params)" FORCE "push(q, qd, out)" HOLONOMIC "2: fixed(q, out)"
  NONHOLONOMIC "out[0] = zero(qd)" PARAMS "&params")
add_behaviour(literals DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(pointer_arrays DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd)")
add_behaviour(jumps DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd)")
add_behaviour(variable_length DOF n LAGRANGIAN "out[0] = lagrangian(q, qd, &params)" PARAMS "&params")
add_behaviour(scalars DOF 2 LAGRANGIAN "out[0] = lagrangian(qd[0], q[0], q[1], qd[1], t)" FORCE "push(q[0], q[1], out)"
  ARGS q=x,y qd=xd,yd)
add_behaviour(recursive DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, &params)" PARAMS "&params" RECURSION branch:depth even:6)
add_behaviour(copies DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(callbacks DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)" RECURSION power:4)
add_behaviour(steps DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(rules DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)" RULES rules_bump:rules_bump_taylor)
target_sources(behaviour_rules PRIVATE rules_external.c)
add_behaviour(mixed_structs DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
add_behaviour(floats SINGLE DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
# its functions differ from library to library
add_behaviour(float_functions SINGLE VALUE_RTOL 1e-6 DOF 2 LAGRANGIAN "out[0] = lagrangian(q, qd, t)")
