# The models of this folder: the mechanism; the habits of its C.
add_mechanics(planar_arm "planar arm with three joints; 4x4 matrices in flat arrays, memset and memcpy, out-parameters" DOF 3
  LAGRANGIAN arm_lagrangian ARGS p=arm PARAMS "&bench_arm")
add_mechanics(heavy_top "heavy top in Euler angles; terse scalars, macro for squares" DOF 3 LAGRANGIAN L ARGS q=phi,th,psi qd=phid,thd,psid)
add_mechanics(spatial_arm "arm with six axes; matrices as structs by value, designated table" DOF 6 LAGRANGIAN arm6_lagrangian)
add_mechanics(recursive_chain "chain of rods in relative angles; a function that calls itself" DOF count SIZES count=4 LAGRANGIAN chain_lagrangian ARGS p=c
  RECURSION rest_of:5 PARAMS "&whip")
add_mechanics(gimbal "gyroscope in two frames; vector algebra in macros" DOF 3 LAGRANGIAN GyroLagrangian PARAMS "&Gyro")
add_mechanics(kepler_j2 "orbit about an oblate planet; Fortran translated by f2c: arrays from 1, goto" DOF 3 LAGRANGIAN xlagr_ ARGS q=x qd=xd)
add_mechanics(three_bodies "three softened bodies; restrict, pointer walks, do and while" DOF 6 SIZES bodies=3 LAGRANGIAN nbody_lagrangian ARGS p=system
  PARAMS "&figure")
add_mechanics(relativistic "relativistic charge; Hungarian names and typedefs for every type" DOF 2 LAGRANGIAN RelativisticLagrangian
  ARGS q=lpdPos qd=lpdVel p=lpstParticle PARAMS "&g_stElectron")
add_mechanics(toda "periodic Toda lattice; one-line functions, recursion instead of loops" DOF 4 LAGRANGIAN toda_lagrangian
  RECURSION kinetic_from:5 potential_from:5)
add_mechanics(fput "Fermi-Pasta-Ulam-Tsingou chain; kernel style: tabs, iterator macros, ret" DOF nr_masses SIZES nr_masses=5 LAGRANGIAN fput_lagrangian
  ARGS p=chain PARAMS "&fput_default")
add_mechanics(lennard_jones "cluster of four atoms; MISRA C: exact-width types, one exit" DOF 8 LAGRANGIAN lj_lagrangian)
add_mechanics(stop "carriages with end stops and play; early returns, chains of ?:, fmax in a force" DOF 2 LAGRANGIAN carriages FORCE dampers)
add_mechanics(terrain "puck on measured ground; static tables of float and short, search for the cell" DOF 2 LAGRANGIAN puck
  ARGS q=x,y qd=vx,vy)
add_mechanics(stick_slip "blocks on a belt with tanh friction; a list of elements, enum and switch" DOF num_blocks SIZES num_blocks=3 num_elements=9
  LAGRANGIAN RigEnergyDifference FORCE RigForces ARGS p=rig PARAMS "&kBrakeRig")
add_mechanics(rotating_hoop "bead on a hoop spun up in time; header-only inline helpers, array typedefs" DOF 1 LAGRANGIAN bead_on_hoop)
add_mechanics(terrain_floor "point mass in a sampled potential; (int)floor of coordinates, switch of spline weights" DOF 2 SIZES width=8 height=8 LAGRANGIAN walker
  ARGS p=map PARAMS "&yard")
add_mechanics(mesh "net of knots and threads; objects with flags and floats filled by memcpy, laws as callbacks in a table" DOF 8
  LAGRANGIAN net_lagrangian)
add_mechanics(coils "coil on a spring over a coil, with circuits; elliptic integrals of a library by the user's rules" DOF 3
  LAGRANGIAN gun_lagrangian FORCE gun_losses ARGS p=gun RULES ellint_K:ellint_K_taylor ellint_E:ellint_E_taylor PARAMS "&toy_gun" EXTERNAL elliptic.c)
add_mechanics(quaternion_body "rigid body with a quaternion of unit length; small value types, functions that return them" DOF 4
  LAGRANGIAN quaternion_body HOLONOMIC quaternion_norm)
add_mechanics(snakeboard "snakeboard with PD laws along sinusoids; output of a symbolic program, t2 t3 t4" DOF 6 LAGRANGIAN snakeboard_L
  NONHOLONOMIC snakeboard_psi:2 FORCE snakeboard_tau)
add_mechanics(chaplygin_sleigh "Chaplygin sleigh on a tilting table; every quantity has its unit for a type" DOF 3 LAGRANGIAN sleigh_lagrangian
  NONHOLONOMIC sleigh_slip FORCE sleigh_damping ARGS p=s PARAMS "&toy")
add_mechanics(rolling_disk "disk that rolls on a plane; Autolev's Z array, numbered from 1" DOF 5 LAGRANGIAN disk_L NONHOLONOMIC disk_roll:2)
add_mechanics(elastic_double_pendulum "double pendulum with elastic links; tiny pure functions, const structs" DOF 4
  LAGRANGIAN elastic_double_pendulum)
add_mechanics(furuta "Furuta pendulum with a motor; parameters, indices and locals from lists of X-macros" DOF 2 LAGRANGIAN furuta_lagrangian
  FORCE furuta_force PARAMS "&furuta_lab")
add_mechanics(ball_and_beam "ball on a driven beam; inheritance by the first member, methods that take self" DOF 2 LAGRANGIAN Beam_lagrangian
  FORCE Beam_torque)
add_mechanics(cart_pendulums "cart with a chain of links; arrays of variable length, restrict, static n, prefix sums" DOF coordinates SIZES links=3 coordinates=4
  LAGRANGIAN cart_lagrangian FORCE cart_joint_friction PARAMS "&cart")
add_mechanics(four_bar "four-bar linkage closed by constraints; compound literals by address" DOF 3 LAGRANGIAN linkage HOLONOMIC loop_closure:2
  FORCE motor)
add_mechanics(foucault "Foucault pendulum in the rotating frame; terse, one comma expression" DOF 3 LAGRANGIAN L HOLONOMIC f FORCE drag
  ARGS q=r qd=v out=F)
add_mechanics(swinging_atwood "swinging Atwood machine with wide pulleys; GNU style, scalar arguments" DOF 2 LAGRANGIAN atwood_lagrangian
  ARGS q=r,theta qd=rdot,thetadot)
add_mechanics(hoist "hoist on a rail with brake, rope and air drag, by Rayleigh's dissipation; kernel style, tabs, designated initialisers" DOF 3
  LAGRANGIAN hoist_lagrangian DISSIPATION hoist_losses HOLONOMIC hoist_rope FORCE hoist_drive PARAMS "&harbour")
add_mechanics(half_car "half-car suspension; table of elements with kinds, switch with fall-through" DOF 4 SIZES n_elements=8 LAGRANGIAN half_car_lagrangian
  FORCE half_car_dampers PARAMS "&car")
add_mechanics(tethered_drone "drone on a cable of three segments; vector macros, pointer walk in do while" DOF 9 LAGRANGIAN drone_lagrangian
  FORCE drone_thrust)
add_mechanics(maglev "magnetic levitation with its circuit; BSD style, two translation units" DOF 2 LAGRANGIAN maglev_lagrangian
  FORCE maglev_force ARGS q=x,z qd=xdot,i p=c PARAMS "&magnet" FILES maglev_coil.c)
add_mechanics(landau_governor "governor of Landau and Lifshitz; formulas as macros" DOF 1 LAGRANGIAN governor ARGS q=theta qd=theta_dot)
add_mechanics(goldstein_table "two masses on a string through a table, after Goldstein; Numerical Recipes style, everything from 1" DOF 4
  LAGRANGIAN table)
add_mechanics(landau_rods "two hinged rods of Landau and Lifshitz; objects that answer for their energies" DOF 1 LAGRANGIAN rods)
add_mechanics(five_bar "parallel robot with five bars; complex numbers as a struct" DOF 4 LAGRANGIAN five_bar_lagrangian HOLONOMIC five_bar_loop:2)
add_mechanics(cam_follower "cam and rocker; angle by Newton's method, assert, results with a success flag" DOF 1 LAGRANGIAN cam_lagrangian FORCE cam_drive)
add_mechanics(slider_crank "slider-crank engine with gas force; output of f2c: arrays moved to start at 1, goto, computed goto by switch" DOF 1
  LAGRANGIAN slcrnk_ FORCE gasfrc_)
add_mechanics(fem_beam "cantilever of four finite elements on a hardening foundation; gather and scatter, tables of unnamed structs" DOF 8
  LAGRANGIAN beam_lagrangian FORCE beam_load)
add_mechanics(satellite "satellite with reaction wheels in the gravity gradient; flight software, array typedefs, results first" DOF 7
  LAGRANGIAN sat_lagrangian FORCE sat_motor_torque)
add_mechanics(dipole_field "charge among magnets; small structs by value through helpers of another file" DOF 3 LAGRANGIAN charge_lagrangian
  ARGS q=x,y,z qd=xd,yd,zd p=s PARAMS "&trap" FILES dipole_vec.c)
add_mechanics(andrews "Andrews' squeezing mechanism; the example's own source" DOF 7 LAGRANGIAN andrews_lagrangian FORCE andrews_torque
  HOLONOMIC andrews_loops:6 PARAMS "published()")
add_mechanics(flyball_rods "flyball governor with rigid rods; the example's source and a constraint beside it" DOF 4 LAGRANGIAN flyball_lagrangian
  FORCE flyball_dampers HOLONOMIC rods:2 PARAMS "with_rods()")
