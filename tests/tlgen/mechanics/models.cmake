# The models of this folder: the mechanism; the habits of its C.
add_mechanics(planar_arm "planar arm with three joints; 4x4 matrices in flat arrays, out-parameters" DOF 3 LAGRANGIAN arm_lagrangian ARGS p=arm
  PARAMS "&bench_arm")
add_mechanics(heavy_top "heavy top in Euler angles; terse scalars, macro for squares" DOF 3 LAGRANGIAN L ARGS q=phi,th,psi qd=phid,thd,psid)
