# A variable that is not set.
wipe
model basic -ndm 3 -ndf 6
frictionModel Coulomb 1 $mu
