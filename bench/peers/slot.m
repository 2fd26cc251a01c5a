% SPDX-License-Identifier: Apache-2.0
% SLOT with a constant limit of 12 under u = sin(2 pi t), a loop in Octave. The last line is the end state, as JSON.
% usage: octave-cli -qf slot.m N
steps = str2double(argv(){1});
last = 100;
if steps == 10
  last = 1;
end
u = sin(2*pi*linspace(0, last, steps + 1));
stiffness = 1e4; limit = 12; force = 0; slip = 0; accumulated = 0;
f = zeros(1, steps + 1); s = f;
for i = 2:steps + 1
  trial = force + stiffness*(u(i) - u(i - 1));
  over = abs(trial) - limit;
  if over > 0
    force = sign(trial)*limit;
    slip += sign(trial)*over/stiffness;
    accumulated += over/stiffness;
  else
    force = trial;
  end
  f(i) = force; s(i) = accumulated;
end
printf('{"f": %.17g, "slip": %.17g, "s": %.17g}\n', force, slip, accumulated);
