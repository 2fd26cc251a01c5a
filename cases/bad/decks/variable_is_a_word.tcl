# A variable that is no number.
wipe
model basic -ndm 3 -ndf 6
set mu low
frictionModel Coulomb 1 $mu
