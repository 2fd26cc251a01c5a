# A script without a friction model.
wipe
model basic -ndm 3 -ndf 6
set mu 0.05
