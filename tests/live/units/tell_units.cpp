// SPDX-License-Identifier: Apache-2.0
// Prints how units are converted into each other, by whichever library it is linked with.
#include <udunits2.h>

#include <cmath>
#include <cstdio>
#include <memory>

namespace {

constexpr const char* kUnits[] = {"mm",        "m",
                                  "cm",        "km",
                                  "um",        "in",
                                  "ft",        "N",
                                  "kN",        "mN",
                                  "daN",       "lbf",
                                  "kip",       "kgf",
                                  "s",         "ms",
                                  "us",        "min",
                                  "h",         "degC",
                                  "K",         "degF",
                                  "degR",      "deg",
                                  "rad",       "Hz",
                                  "rpm",       "kg",
                                  "g",         "t",
                                  "MPa",       "N/mm",
                                  "N.m",       "N mm",
                                  "kN/m",      "m/s",
                                  "mm/s2",     "m.s-2",
                                  "1/s",       "psi",
                                  "lbf/in^2",  "inches",
                                  "feet",      "micron",
                                  "\302\265m", "N/mm\302\262",
                                  "slug",      "tonne",
                                  "deg/s",     "degrees",
                                  "Newton",    "2.5 mm",
                                  "mm^-1",     "%",
                                  "cm H2O",    "Nmm",
                                  "xyz",       "hPa",
                                  "kWh",       "\302\260C",
                                  "N/(mm.s)",  "kg.m2",
                                  "J/K",       "1e-3 m",
                                  "mm mm",     "m^",
                                  "(m",        "turn",
                                  "atm",       "N-m",
                                  "lbf-in",    "N - m",
                                  "N . m",     "N -m",
                                  "m.5",       "m .5",
                                  "m -2",      "m*-2",
                                  "N-2m",      "Millimeter",
                                  "Kilometer", "MILLIMETER",
                                  "mmm",       "kmm",
                                  "millikm",   "kilokilometer",
                                  "KPa",       "kiloPa",
                                  "dakm",      "m PER s",
                                  "((m))",     "m^200",
                                  "m^300",     "2^-1",
                                  "m/",        "m-",
                                  "m//s",      "m2s-1",
                                  "m^2^2",     "1/(2 m)",
                                  "pa",        "PA",
                                  "PASCAL",    "mdegC",
                                  "millidegC"};

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

}  // namespace

int main() {
  ut_set_error_message_handler(ut_ignore);
  ut_system* const system = ut_read_xml(nullptr);
  const Unit degree(ut_parse(system, "degree", UT_UTF8));
  ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());
  for (const char* from : kUnits) {
    const Unit one(ut_parse(system, from, UT_UTF8));
    std::printf("%s:%s", from, one ? "" : " no unit");
    for (const char* to : kUnits) {
      const Unit other(ut_parse(system, to, UT_UTF8));
      const std::unique_ptr<cv_converter, FreeConverter> converter(
          one && other ? ut_get_converter(one.get(), other.get()) : nullptr);
      if (!converter) continue;
      const double zero = cv_convert_double(converter.get(), 0.0);
      // Of the reciprocal of a unit only that it is one.
      std::printf(" %s=%.17g", to, zero);
      if (std::isfinite(zero)) std::printf(",%.17g", cv_convert_double(converter.get(), 3.7));
    }
    std::printf("\n");
  }
}
