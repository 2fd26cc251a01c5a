# SPDX-License-Identifier: Apache-2.0
import openseespy.opensees as ops

mu_slow = 0.03
ops.model('basic', '-ndm', 3, '-ndf', 6)
ops.frictionModel('VelDependent', 2, mu_slow,
                  2 * mu_slow + 0.01, 0.025)
ops.element('flatSliderBearing', 1, 1, 2, 2, 1250.0, '-P', 1, '-T', 1, '-My', 1, '-Mz', 1)
