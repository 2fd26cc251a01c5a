// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/keyword_list.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace slipbench::driver::abaqus {
namespace {

/// Others, which a shortened name might be meant for.
constexpr std::array<std::string_view, 86> kOthers{
    "ANISOTROPIC HYPERELASTIC",
    "ANNEAL",
    "AQUA",
    "ASYMMETRIC-AXISYMMETRIC",
    "CAPACITY",
    "CAVITY DEFINITION",
    "CECHANGE",
    "CENTROID",
    "CFLUX",

    "COHESIVE BEHAVIOR",
    "COHESIVE SECTION",
    "COMPLEX FREQUENCY",
    "CONDUCTIVITY",
    "CONNECTOR DAMAGE EVOLUTION",
    "CONNECTOR DAMAGE INITIATION",
    "CONNECTOR FAILURE",
    "CONNECTOR HARDENING",
    "CONNECTOR LOCK",
    "CONNECTOR PLASTICITY",
    "CONNECTOR UNIAXIAL BEHAVIOR",
    "CONSTRAINT CONTROLS",
    "CONTACT",
    "CONTACT CONTROLS",
    "CONTACT DAMPING",
    "CONTACT PAIR",
    "CONTOUR INTEGRAL",
    "CONTROLS",
    "COUPLED TEMPERATURE-DISPLACEMENT",
    "COUPLING",
    "CREEP",
    "DYNAMIC TEMPERATURE-DISPLACEMENT",
    "EL FILE",
    "EL PRINT",
    "ELASTIC",
    "ELCOPY",
    "ELECTRICAL CONDUCTIVITY",
    "ELEMENT MATRIX OUTPUT",
    "ELEMENT OUTPUT",
    "ELEMENT RESPONSE",
    "ELGEN",
    "EMBEDDED ELEMENT",
    "END LOAD CASE",
    "ENERGY FILE",
    "ENERGY OUTPUT",
    "ENERGY PRINT",
    "EQUATION",
    "FRACTURE CRITERION",
    "FREQUENCY",
    "GAP CONDUCTANCE",
    "GAP FLOW",
    "GAP HEAT GENERATION",
    "GAP RADIATION",
    "HEAT GENERATION",
    "HEAT TRANSFER",
    "HEATCAP",
    "IMPEDANCE",
    "IMPERFECTION",
    "IMPORT",
    "INCIDENT WAVE",
    "INELASTIC HEAT FRACTION",
    "INERTIA RELIEF",
    "INITIAL CONDITIONS",
    "INTEGRATED OUTPUT",
    "NODAL ENERGY RATE",
    "NODAL THICKNESS",
    "NODE FILE",
    "NODE OUTPUT",
    "NODE PRINT",
    "NODE RESPONSE",
    "NONSTRUCTURAL MASS",
    "NORMAL",
    "NSET",
    "ORNL",
    "OUTPUT",
    "PARAMETER DEPENDENCE",
    "PARAMETER SHAPE VARIATION",
    "PARTICLE GENERATOR",
    "STEADY STATE DYNAMICS",
    "STEADY STATE TRANSPORT",
    "SURFACE",
    "SURFACE BEHAVIOR",
    "SURFACE FLAW",
    "SURFACE PROPERTY",
    "SURFACE SECTION",
    "VISCOELASTIC",
    "VISCOUS",
};

const std::vector<std::string_view>& all_names() {
  static const std::vector<std::string_view> kAll = [] {
    std::vector<std::string_view> names(kOthers.begin(), kOthers.end());
    for (const KeywordRule& rule : read_keywords()) names.push_back(rule.name);
    return names;
  }();
  return kAll;
}

}  // namespace

std::span<const KeywordRule> read_keywords() {
  static const std::vector<KeywordRule> kRules{
      {"AMPLITUDE",
       {"NAME", "DEFINITION", "TIME", "VALUE", "FIXED INTERVAL", "BEGIN", "SMOOTH", "INPUT"}},
      {"ASSEMBLY", {"NAME"}},
      {"BOUNDARY", {}},
      {"CHANGE FRICTION", {"ELSET", "INTERACTION", "AMPLITUDE", "RESET"}},
      {"CLOAD", {"AMPLITUDE", "OP", "FOLLOWER", "LOAD CASE", "REAL", "IMAGINARY", "REGION TYPE"}},
      {"CONNECTOR BEHAVIOR",
       {"NAME", "EXTRAPOLATION", "INTEGRATION", "REGULARIZE", "RATE INTERPOLATION", "RTOL",
        "RATE FACTOR", "OPTIMIZE"}},
      {"CONNECTOR CONSTITUTIVE REFERENCE"},
      {"CONNECTOR DAMPING",
       {"COMPONENT", "NONLINEAR", "TYPE", "DEPENDENCIES", "INDEPENDENT COMPONENTS", "REGULARIZE",
        "RTOL", "EXTRAPOLATION", "FREQUENCY DEPENDENCE", "UNSYMM"}},
      {"CONNECTOR DERIVED COMPONENT",
       {"NAME", "OPERATOR", "SIGN", "INDEPENDENT COMPONENTS", "DEPENDENCIES"}},
      {"CONNECTOR ELASTICITY",
       {"COMPONENT", "NONLINEAR", "RIGID", "DEPENDENCIES", "INDEPENDENT COMPONENTS", "REGULARIZE",
        "RTOL", "EXTRAPOLATION", "FREQUENCY DEPENDENCE", "UNSYMM"}},
      {"CONNECTOR FRICTION",
       {"PREDEFINED", "COMPONENT", "CONTACT FORCE", "INDEPENDENT COMPONENTS", "STICK STIFFNESS",
        "DEPENDENCIES"}},
      {"CONNECTOR LOAD",
       {"AMPLITUDE", "OP", "FOLLOWER", "LOAD CASE", "REAL", "IMAGINARY", "REGION TYPE"}},
      {"CONNECTOR MOTION",
       {"AMPLITUDE", "OP", "TYPE", "FIXED", "LOAD CASE", "REAL", "IMAGINARY", "USER",
        "REGION TYPE"}},
      {"CONNECTOR POTENTIAL", {"EXPONENT", "OPERATOR"}},
      {"CONNECTOR SECTION", {"ELSET", "BEHAVIOR"}},
      {"CONNECTOR STOP", {"COMPONENT"}},
      {"DYNAMIC", {}},
      {"ELEMENT", {"TYPE", "ELSET", "FILE", "INPUT", "OFFSET", "SOLID ELEMENT NUMBERING"}, true},
      {"ELSET", {"ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED"}},
      {"END ASSEMBLY"},
      {"END INSTANCE"},
      {"END PART"},
      {"END STEP"},
      {"FIELD", {"VARIABLE", "AMPLITUDE", "OP", "USER", "FILE", "BSTEP", "ESTEP", "BINC", "EINC"}},
      {"FRICTION",
       {"EXPONENTIAL DECAY", "TEST DATA", "TAUMAX", "SLIP TOLERANCE", "ELASTIC SLIP",
        "DEPENDENCIES", "ROUGH", "LAGRANGE", "USER", "ANISOTROPIC", "PROPERTIES", "DEPVAR",
        "SHEAR TRACTION SLOPE"}},
      {"GAP"},
      {"HEADING"},
      {"INCLUDE", {"INPUT", "PASSWORD"}},
      {"INSTANCE", {"NAME", "PART", "LIBRARY", "INSTANCE"}},
      {"NODE", {"INPUT", "NSET", "SYSTEM"}, true},
      {"ORIENTATION", {"NAME", "DEFINITION", "SYSTEM", "LOCAL DIRECTIONS"}},
      {"PARAMETER", {}},
      {"PART", {"NAME"}},
      {"STATIC", {}},
      {"STEP",
       {"AMPLITUDE", "CONVERT SDI", "EXTRAPOLATION", "INC", "NAME", "NLGEOM", "PERTURBATION",
        "SOLVER", "UNSYMM"},
       true},
      {"SURFACE INTERACTION", {}},
      {"TEMPERATURE",
       {"ABSOLUTE EXTERIOR TOLERANCE", "AMPLITUDE", "BINC", "BSTEP", "DRIVING ELSETS", "EINC",
        "ESTEP", "EXTERIOR TOLERANCE", "FILE", "INPUT", "INTERPOLATE", "MIDSIDE", "OP", "USER"},
       true},
      {"VISCO", {}},
  };
  return kRules;
}

std::string folded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == ' ' || c == '\t') continue;
    out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return out;
}

FoundName find_name(std::string_view text, std::span<const std::string_view> names) {
  const std::string wanted = folded(text);
  FoundName found;
  if (wanted.empty()) return found;
  for (const std::string_view name : names) {
    // As folded(name) begins, letter by letter: decks have many keywords, and each is looked up.
    std::size_t same = 0;
    auto at = name.begin();
    for (; at != name.end() && same < wanted.size(); ++at) {
      if (*at == ' ') continue;
      if (std::toupper(static_cast<unsigned char>(*at)) != wanted[same]) break;
      ++same;
    }
    if (same < wanted.size()) continue;
    if (at == name.end()) return {name, {}};
    found.candidates.push_back(name);
  }
  if (found.candidates.size() == 1) return {found.candidates.front(), {}};
  return found;
}

FoundName find_keyword(std::string_view text) { return find_name(text, all_names()); }

}  // namespace slipbench::driver::abaqus
