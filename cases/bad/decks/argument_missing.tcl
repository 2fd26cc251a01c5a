# An argument too few.
wipe
model basic -ndm 3 -ndf 6
set mu 0.05
frictionModel Coulomb 1
