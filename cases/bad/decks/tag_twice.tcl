# A tag twice.
wipe
model basic -ndm 3 -ndf 6
set mu 0.05
frictionModel Coulomb 1 $mu
frictionModel Coulomb 1 0.3
