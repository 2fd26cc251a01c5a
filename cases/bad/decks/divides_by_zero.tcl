# An expression that divides by zero.
wipe
model basic -ndm 3 -ndf 6
set mu [expr 1/0]
frictionModel Coulomb 1 $mu
