# A tag that is no number.
wipe
model basic -ndm 3 -ndf 6
set mu 0.05
frictionModel Coulomb one $mu
