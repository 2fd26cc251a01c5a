# Two lists of different length.
wipe
model basic -ndm 3 -ndf 6
set mu 0.05
frictionModel VelDepMultiLinear 1 -vel 0 10 20 -frn 0.03 0.05
