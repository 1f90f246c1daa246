add_adjoint(powers FOLDER ${CMAKE_CURRENT_SOURCE_DIR} SOURCES powers.c LAGRANGIAN powers_lagrangian DOF 2 SIZES degree=4 PARAMETERS shape
  PARAMS "&(struct powers){4, 2.0, 4.5, -3.0, 1.75}")
add_adjoint(partial_sums FOLDER ${CMAKE_CURRENT_SOURCE_DIR} SOURCES partial_sums.c LAGRANGIAN partial_sums DOF 6)
add_adjoint(last_values FOLDER ${CMAKE_CURRENT_SOURCE_DIR} SOURCES last_values.c LAGRANGIAN last_values DOF 6)
add_adjoint(decided_by_sums FOLDER ${CMAKE_CURRENT_SOURCE_DIR} SOURCES decided_by_sums.c LAGRANGIAN decided_by_sums DOF 6)
add_adjoint(logistic FOLDER ${CMAKE_CURRENT_SOURCE_DIR} SOURCES logistic.c LAGRANGIAN logistic DOF 2)
foreach(by IN ITEMS mass shape)
  add_adjoint(gamma_spring_by_${by} FOLDER ${CMAKE_CURRENT_SOURCE_DIR} SOURCES gamma_spring.c LAGRANGIAN gamma_spring_lagrangian DOF 1
    PARAMETERS ${by} PARAMS "&(struct gamma_spring){1.2, 2.5}")
endforeach()

# The models of the examples, with parameters.
function(add_example name source)
  add_adjoint(${name} FOLDER ${PROJECT_SOURCE_DIR}/examples/models SOURCES ${source}.c LAGRANGIAN ${name}_lagrangian ${ARGN})
endfunction()

add_example(pendulum pendulum DOF n SIZES n=5 PARAMETERS g
  PARAMS "&(struct pendulum){.n = 5, .g = 9.81, .mass = {1.0, 0.5, 2.0, 1.0, 3.0}, .length = {1.0, 1.5, 0.75, 1.0, 0.5}}")
add_example(central_field central_field DOF 4 HOLONOMIC central_field_unit PARAMETERS m mu PARAMS "&(struct central_field){2.0, 1.7}")
add_example(central_field_reduced central_field DOF 4 HOLONOMIC central_field_unit PARAMETERS m mu PARAMS "&(struct central_field){2.0, 1.7}")
add_example(double_cart_pole double_cart_pole DOF 3 FORCE double_cart_pole_force PARAMETERS cart_mass push
  PARAMS "&(struct double_cart_pole){1.0, {0.3, 0.2}, {0.8, 0.5}, 9.81, 2.0, 0.1, {0.02, 0.01}}")
add_example(cart_pole cart_pole DOF 2 FORCE cart_pole_force PARAMETERS cart_mass pole_length hinge_drag
  PARAMS "&(cart_pole){1.0, 0.3, 0.8, 9.81, 2.0, 0.1, 0.02}")
add_example(double_pendulum double_pendulum DOF 2 PARAMETERS gravity
  PARAMS "&(DoublePendulum){{1.0, 1.0, 0.5, 0.1}, {0.7, 0.8, 0.4, 0.05}, 9.81}")
add_example(relative_chain relative_chain DOF n SIZES n=5 PARAMETERS gravity PARAMS "&(struct relative_chain){5, 9.81}")
add_example(kepler kepler DOF 2)
add_example(hoop hoop DOF 1 PARAMETERS mass radius spin PARAMS "&(struct hoop){0.5, 0.8, 9.81, 3.0, 2.0}")
add_example(spring_pendulum spring_pendulum DOF 2 PARAMETERS rest stiffness PARAMS "&(struct spring_pendulum){1.1, 0.9, 30.0, 9.81}")
add_example(cartesian_pendulum cartesian_pendulum DOF coordinates SIZES links=2 coordinates=4 HOLONOMIC cartesian_pendulum_rods:links
  PARAMETERS g PARAMS "&(cartesian_pendulum){2, 4, 9.81, {1.0, 0.5}, {1.0, 1.5}}")
add_example(knife_edge knife_edge DOF 3 NONHOLONOMIC knife_edge_slip PARAMETERS mass slope PARAMS "&(struct knife_edge){1.2, 0.3, 9.81, 0.2}")
add_example(magnets magnets DOF 2 FORCE magnets_drag)

# Those of the hard cases, whose sources have functions SOURCE_parameters of their own: motion functions take that name.
function(add_scene source)
  add_adjoint(scene_${source} FOLDER ${PROJECT_SOURCE_DIR}/examples/models SOURCES ${source}.c LAGRANGIAN ${source}_lagrangian ${ARGN})
endfunction()

add_scene(andrews DOF 7 FORCE andrews_torque HOLONOMIC andrews_loops:6 PARAMETERS c0 mom
  PARAMS "&(andrews){0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498, 2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, \
1.912e-5, -0.06934, -0.00227, -0.03635, 0.03273, 0.014, 0.072, 28e-3, 115e-4, 2e-2, 1421e-5, 7e-3, 92e-5, 35e-3, 1874e-5, 1043e-5, 18e-3, 2e-2, \
2308e-5, 916e-5, 4e-2, 1228e-5, 449e-5, 2e-2, 4e-2, 1421e-5, 4530.0, 0.07785, 0.033}")
add_scene(flyball DOF 4 FORCE flyball_dampers PARAMETERS stiffness
  PARAMS "&(flyball){1.0, 0.3, 0.01, 5.0, 0.3, 3.0, 0.1, 0.05, 1.0, 8e3, 4e2, 0.5, 9.81}")
add_scene(elastic_crank DOF 7 HOLONOMIC elastic_crank_loops:3
  PARAMS "&(elastic_crank){0.151104, 0.075552, 0.002727, 0.0045339259, 0.15, 0.30, 0.008, 0.008, 7870.0, 0.2e12, 3.1415927, 150.0}")
add_scene(quaternion_top DOF 4 HOLONOMIC quaternion_top_unit PARAMETERS mass
  PARAMS "&(quaternion_top){0.8, 0.3, 1.2, 0.5, 9.81}")
add_scene(repeated_rod DOF 2 HOLONOMIC repeated_rod_lengths:rows SIZES rows=3
  PARAMS "&(repeated_rod){1.0, 0.9, 9.81, 3, {1.0, 2.0, -0.5}}")
add_scene(four_bars DOF coordinates HOLONOMIC four_bars_rods:rods SIZES loops=2 coordinates=6 rods=5
  PARAMS "&(four_bars){2, 6, 5, 1.1, 0.9, 9.81}")
add_scene(bricard DOF 24 HOLONOMIC bricard_joints:24 PARAMS "&(bricard){1.0, 0.1, 1.2, 9.81}")
