// SPDX-License-Identifier: Apache-2.0
// Puts what a slider's position has been run to into its picture; `played` has all positions.
for (const figure of document.querySelectorAll("figure.play")) {
  const {told, frames} = played[figure.dataset.play], slider = figure.querySelector("input");
  const show = () => {
    figure.querySelector("output").textContent = told[slider.value];
    slider.setAttribute("aria-valuetext", told[slider.value]);
    for (const [name, what] of Object.entries(frames[slider.value])) {
      const one = document.getElementById(name);
      if (one instanceof SVGPathElement) one.setAttribute("d", what);
      else one.textContent = what;
    }
  };
  slider.addEventListener("input", show);
  show();  // where the browser has kept it from the last visit
}
