// SPDX-License-Identifier: Apache-2.0
// Functions that the program calls in place of dlopen and its like (--wrap): without libraries it
// cannot load any, since one would need those.

extern "C" {

void* __wrap_dlopen(const char*, int) { return nullptr; }
void* __wrap_dlsym(void*, const char*) { return nullptr; }
char* __wrap_dlerror() {
  static char text[] = "this program is linked without libraries and loads none";
  return text;
}
}
