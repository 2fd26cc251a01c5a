# Velocities that descend.
wipe
model basic -ndm 3 -ndf 6
set mu 0.05
frictionModel VelDepMultiLinear 1 -vel 0 20 10 -frn 0.03 0.05 0.07
