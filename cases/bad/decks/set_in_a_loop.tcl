# A name that a loop sets.
wipe
set mu 0.05
for {set i 0} {$i < 3} {incr i} {
  set mu [expr {$mu + 0.01}]
}
frictionModel Coulomb 1 $mu
