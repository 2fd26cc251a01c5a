// SPDX-License-Identifier: Apache-2.0
/** Calls of the core's functions, by name: of texts, which give a text. */
const coreCalls = (program) => (name, ...texts) => {
  const places = texts.map((text) => {
    const size = program.lengthBytesUTF8(text) + 1;
    const place = program._malloc(size);
    program.stringToUTF8(text, place, size);
    return place;
  });
  const answer = program.UTF8ToString(program[`_slipbench_${name}`](...places));
  places.forEach((place) => program._free(place));
  return answer;
};
