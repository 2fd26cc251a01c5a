# A flat slider and a pendulum under a bridge.
wipe
model basic -ndm 3 -ndf 6
set muSlow 0.03
set W [expr 2.0*450]
node 1 0 0 0
node 2 0 0 0
frictionModel Coulomb 1 0.05
frictionModel VelDependent 2 $muSlow [expr {2*$muSlow + 0.01}] 0.025; # rises with the velocity
frictionModel VelDepMultiLinear 3 -vel 0 10 200 \
    -frn 0.03 0.05 0.07
frictionModel VelPressureDep 4 $muSlow 0.085 7.0e4 0.02 0.05 0.025
frictionModel VelNormalFrcDep 5 [expr 0.012/pow($W,0.8-1.0)] 0.8 [expr 0.018/pow($W,0.7-1.0)] 0.7 25.0 0.0 0.0 3.0
uniaxialMaterial Elastic 1 1.e6
element flatSliderBearing 1 1 2 2 1250.0 -P 1 -T 1 -My 1 -Mz 1 -orient 0 0 1 1 0 0
element singleFPBearing 2 1 2 4 2230.0 900.0 -P 1 -T 1 -My 1 -Mz 1
