# A command of the shell.
wipe
model basic -ndm 3 -ndf 6
set mu [exec cat /etc/hostname]
frictionModel Coulomb 1 $mu
