# A friction model that is none.
wipe
model basic -ndm 3 -ndf 6
set mu 0.05
frictionModel Colomb 1 $mu
