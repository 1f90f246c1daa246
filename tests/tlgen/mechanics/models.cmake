# The models of this folder: the mechanism; the habits of its C.
add_mechanics(planar_arm "planar arm with three joints; 4x4 matrices in flat arrays, out-parameters" DOF 3 LAGRANGIAN arm_lagrangian ARGS p=arm
  PARAMS "&bench_arm")
add_mechanics(heavy_top "heavy top in Euler angles; terse scalars, macro for squares" DOF 3 LAGRANGIAN L ARGS q=phi,th,psi qd=phid,thd,psid)
add_mechanics(spatial_arm "arm with six axes; matrices as structs by value, designated table" DOF 6 LAGRANGIAN arm6_lagrangian)
add_mechanics(recursive_chain "chain of rods in relative angles; a function that calls itself" DOF count LAGRANGIAN chain_lagrangian ARGS p=c
  RECURSION rest_of:5 PARAMS "&whip")
add_mechanics(gimbal "gyroscope in two frames; vector algebra in macros" DOF 3 LAGRANGIAN GyroLagrangian PARAMS "&Gyro")
add_mechanics(kepler_j2 "orbit about an oblate planet; Fortran translated by f2c: arrays from 1, goto" DOF 3 LAGRANGIAN xlagr_ ARGS q=x qd=xd)
add_mechanics(three_bodies "three softened bodies; restrict, pointer walks, do and while" DOF 6 LAGRANGIAN nbody_lagrangian ARGS p=system
  PARAMS "&figure")
add_mechanics(relativistic "relativistic charge; Hungarian names and typedefs for every type" DOF 2 LAGRANGIAN RelativisticLagrangian
  ARGS q=lpdPos qd=lpdVel p=lpstParticle PARAMS "&g_stElectron")
add_mechanics(toda "periodic Toda lattice; one-line functions, recursion instead of loops" DOF 4 LAGRANGIAN toda_lagrangian
  RECURSION kinetic_from:5 potential_from:5)
add_mechanics(fput "Fermi-Pasta-Ulam-Tsingou chain; kernel style: tabs, iterator macros, ret" DOF nr_masses LAGRANGIAN fput_lagrangian
  ARGS p=chain PARAMS "&fput_default")
add_mechanics(lennard_jones "cluster of four atoms; MISRA C: exact-width types, one exit" DOF 8 LAGRANGIAN lj_lagrangian)
add_mechanics(stop "carriages with end stops and play; early returns, chains of ?:, fmax in a force" DOF 2 LAGRANGIAN carriages FORCE dampers)
add_mechanics(terrain "puck on measured ground; static tables of float and short, search for the cell" DOF 2 LAGRANGIAN puck
  ARGS q=x,y qd=vx,vy)
add_mechanics(stick_slip "blocks on a belt with tanh friction; a list of elements, enum and switch" DOF num_blocks
  LAGRANGIAN RigEnergyDifference FORCE RigForces ARGS p=rig PARAMS "&kBrakeRig")
add_mechanics(rotating_hoop "bead on a hoop spun up in time; header-only inline helpers, array typedefs" DOF 1 LAGRANGIAN bead_on_hoop)
