# A brace that is not closed.
wipe
if {1} {
  set mu 0.05
frictionModel Coulomb 1 $mu
