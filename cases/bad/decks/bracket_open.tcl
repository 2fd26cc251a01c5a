# A bracket that is not closed.
wipe
model basic -ndm 3 -ndf 6
set mu [expr 0.05
frictionModel Coulomb 1 $mu
