// SPDX-License-Identifier: Apache-2.0
// From an Abaqus deck to a case that gives the numbers of its joint.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/import/abaqus/import_for_test.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::abaqus {
namespace {

const std::string kDecks = test::source_dir() + "/tests/decks/abaqus/";

/// A connector between two nodes 50 apart along 1, with a behaviour and what follows it.
std::string deck_of(const std::string& type, const std::string& behavior,
                    const std::string& rest = "") {
  return "*HEADING\nfor a test\n*NODE\n1, 0., 0., 0.\n2, 50., 0., 0.\n"
         "*ELEMENT, TYPE=CONN3D2, ELSET=JOINT\n7, 1, 2\n"
         "*CONNECTOR SECTION, ELSET=JOINT, BEHAVIOR=B\n" +
         type + "\n*CONNECTOR BEHAVIOR, NAME=B\n" + behavior + rest;
}

std::string step_of(const std::string& data) {
  return "*STEP, NAME=slide\n*STATIC\n0.1, 1.\n" + data + "*END STEP\n";
}

struct Folder {
  TemporaryFolder folder;
  ReadDeck read(const std::string& text) { return read_deck(folder.write("d.inp", text).string()); }
};

TEST_CASE("A hinge of a deck as CAE writes it has the limit of its friction") {
  const WrittenCase written = case_of(read_deck(kDecks + "cae_hinge.inp"));
  CHECK(written.asked == std::vector<std::string>{"f1", "f2", "f3", "m2", "m3"});
  const std::vector<base::ParameterText> forces{
      {"f1", 200.0}, {"f2", 300.0}, {"f3", 400.0}, {"m2", 3000.0}, {"m3", 4000.0}};
  CHECK(failed(written.text + at_the_end("FLIM", "954", 2.0), forces).empty());
  CHECK(failed(written.text + at_the_end("CPR1", "-0.4", 1.5), forces).empty());
  CHECK(failed(written.text + at_the_end("CPR1", "0.2", 0.25), forces).empty());
  CHECK(failed(written.text + at_the_end("FLIM", "955", 2.0), forces).size() == 1);
}

TEST_CASE("A guide of a deck in small letters has table, limit, spring, damper and stop") {
  const WrittenCase written = case_of(read_deck(kDecks + "flat_guide.inp"));
  const std::vector<base::ParameterText> forces{
      {"f2", 30.0}, {"f3", 40.0}, {"m1", 20.0}, {"m2", 60.0}, {"m3", 80.0}};
  CHECK(failed(written.text + at_the_end("FN", "12 + 20/4 + 50 + 2/30*100"), forces).empty());
  CHECK(failed(written.text + at_the_end("FLIM", "0.0926371666666667*73.6666666666667"), forces)
            .empty());
  std::vector<base::ParameterText> more = forces;
  more[0].value = 900.0;
  more[1].value = 1200.0;
  CHECK(failed(written.text + at_the_end("FN", "1523.66666666667"), more).empty());
  CHECK(failed(written.text + at_the_end("MU", "0.0755"), more).empty());
  CHECK(failed(written.text + at_the_end("FLIM", "90"), more).empty());
  CHECK(failed(written.text + at_the_end("CEF1", "12.5*15"), forces).empty());
  CHECK(failed(written.text + at_the_end("CVF1", "0.4*15"), forces).empty());
  CHECK_THAT(written.text, Catch::Contains("lower: 20, upper: 80"));
}

TEST_CASE("A belt of a deck has its ratio, and its angle is asked for where it is not given") {
  const ReadDeck read = read_deck(kDecks + "belt.inp");
  REQUIRE(read.model.connectors.size() == 3);
  const WrittenCase first = case_of(read);
  CHECK(first.asked == std::vector<std::string>{"CP2"});
  CHECK(failed(first.text + at_the_end("f_bc/CTF1", "1.2656925"), {{"CP2", 1.0}}).empty());
  CHECK(case_of(read, 1).asked == std::vector<std::string>{"wrap_angle", "CP2"});
  CHECK(read.model.connectors[2].behavior->frictions.empty());
}

TEST_CASE("Friction that the user defines keeps potential, derived components, wear and fields") {
  Folder folder;
  const WrittenCase written = case_of(folder.read(deck_of(
      "CYLINDRICAL",
      "*CONNECTOR DERIVED COMPONENT, NAME=normal\n2, 3\n1., 1.\n"
      "*CONNECTOR DERIVED COMPONENT, NAME=Normal, INDEPENDENT COMPONENTS=POSITION\n1\n5, 6\n"
      "4., 4., 0.\n20., 20., 100.\n"
      "*CONNECTOR FRICTION, CONTACT FORCE=NORMAL, DEPENDENCIES=1\n"
      "100., 0., 20., 0.\n90., 1000., 20., 0.\n50., 0., 80., 1.\n45., 1000., 80., 1.\n"
      "*CONNECTOR POTENTIAL\n1\n4, 0.25\n"
      "*FRICTION, EXPONENTIAL DECAY, ELASTIC SLIP=0.01\n0.3, 0.1, 0.2\n",
      step_of("*CONNECTOR MOTION\nJOINT, 1, 30.\njoint, 4, 0.\n"))));
  CHECK(written.asked == std::vector<std::string>{"f2", "f3", "m2", "m3", "field1", "temperature"});
  const std::vector<base::ParameterText> values{
      {"f2", 3.0}, {"f3", 4.0}, {"m2", 0.3}, {"m3", 0.4}, {"temperature", 20.0}, {"field1", 0.0}};
  // The weight at CP1 = 80 is 4 + 16*0.8; the wear that of the end's accumulated slip.
  const std::string normal = "5 + 0.5*(4 + 16*0.8) + 100 - 0.01*CASUC";
  CHECK(failed(written.text + at_the_end("FN", normal), values).empty());
  CHECK(failed(written.text + at_the_end("MU", "0.1 + 0.2*exp(-0.2*30)"), values).empty());
}

TEST_CASE("Coefficients of a deck become those of the case") {
  Folder folder;
  const auto coefficient = [&](const std::string& friction) {
    const std::string text =
        case_of(folder.read(deck_of("SLOT,", "*CONNECTOR FRICTION, PREDEFINED\n5.\n" + friction)))
            .text;
    const std::size_t begin = text.find("    coefficient: ") + 17;
    return text.substr(begin, text.find("\nhistory", begin) - begin);
  };
  CHECK(coefficient("*FRICTION\n0.2,\n") == "0.2");
  CHECK(coefficient("*FRICTION, TAUMAX=40, SLIP TOL=1.D-3\n.2\n") ==
        "0.2\n    force_limit: 40\n    stick: {slip_tolerance: 0.001}");
  CHECK(coefficient("*FRICTION, EXP, TEST\n0.3\n0.2, 5.\n0.18\n") ==
        "{exponential_test_data: {mu1: 0.3, mu2: 0.2, rate2: 5, mu_inf: 0.18}}");
  CHECK(coefficient("*FRICTION, EXPONENTIAL DECAY, TEST DATA\n0.3\n0.2, 5.\n") ==
        "{exponential_test_data: {mu1: 0.3, mu2: 0.2, rate2: 5}}");
  CHECK(coefficient("*FRICTION\n0.2, , , 20.\n0.1, , , 80.\n") ==
        "{columns: [mu, temperature], rows: [[0.2, 20], [0.1, 80]]}");
  CHECK(coefficient("") == "0");
}

TEST_CASE("Amplitudes and kinds of motion become profiles") {
  Folder folder;
  const auto at = [&](const std::string& amplitude, const std::string& motion,
                      const std::string& time, const std::string& position) {
    const WrittenCase written = case_of(folder.read(
        deck_of("SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n",
                amplitude + step_of("*CONNECTOR MOTION" + motion + "\nJOINT, 1, 2.\n"))));
    INFO(written.text);
    CHECK(failed(written.text + at_the_end("CP1 - 50", position, std::stod(time)),
                 {{"f2", 1.0}, {"f3", 1.0}})
              .empty());
  };
  at("", "", "0.5", "1");
  at("", ", TYPE=VELOCITY", "0.5", "1");
  at("*AMPLITUDE, NAME=A\n0., 0., 0.5, 1., 2., 0.\n", ", AMPLITUDE=a", "1", "2*2/3");
  at("*AMPLITUDE, NAME=A, DEFINITION=TABULAR, VALUE=ABSOLUTE\n0., 0., 1., 1.\n", ", AMPLITUDE=A",
     "1", "1");
  at("*AMPLITUDE, NAME=A, DEFINITION=EQUALLY SPACED, FIXED INTERVAL=0.5\n0., 1., 3.\n",
     ", AMPLITUDE=A", "1", "6");
  at("*AMPLITUDE, NAME=A, DEFINITION=SMOOTH STEP\n0., 0., 1., 1.\n", ", AMPLITUDE=A", "0.3",
     "2*0.3^3*(10 - 15*0.3 + 6*0.3^2)");
  at("*AMPLITUDE, NAME=A, DEFINITION=SMOOTH STEP\n0., 0., 0.5, 1., 1., -1.\n", ", AMPLITUDE=A",
     "0.8", "2*(1 - 2*0.6^3*(10 - 15*0.6 + 6*0.6^2))");
  at("*AMPLITUDE, NAME=A, DEFINITION=PERIODIC\n1, 3., 0.2, 0.5\n0.25, -0.75\n", ", AMPLITUDE=A",
     "0.7", "2*(0.5 + 0.25*cos(3*0.5) - 0.75*sin(3*0.5))");
  // Items that a line leaves out at its end are 0 and shift nothing.
  at("*AMPLITUDE, NAME=A, DEFINITION=PERIODIC\n1, 3., 0.2\n0.25, -0.75\n", ", AMPLITUDE=A", "0.7",
     "2*(0.25*cos(3*0.5) - 0.75*sin(3*0.5))");
  at("*AMPLITUDE, NAME=A\n0., 0., 0.4,\n0.5, 1., 1., 1.\n", ", AMPLITUDE=A", "0.5", "2");
  at("*AMPLITUDE, NAME=A\n0., 0., 0.5, 1., , ,\n1., 3.\n", ", AMPLITUDE=A", "0.8", "4.4");
  at("*AMPLITUDE, NAME=A, DEFINITION=DECAY\n1., 2., 0., 0.5\n", ", AMPLITUDE=A", "1",
     "2*(1 + 2*exp(-2))");
  at("*AMPLITUDE, NAME=A\n0., 1., 1., 1.\n", ", AMPLITUDE=A, TYPE=VELOCITY", "0.6", "1.2");
  at("*AMPLITUDE, NAME=A\n0., 0., 1., 1.\n", ", AMPLITUDE=A, TYPE=VELOCITY", "1", "1");
}

TEST_CASE("Steps follow one another, and change the friction") {
  Folder folder;
  const WrittenCase written = case_of(folder.read(
      deck_of("SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n",
              "*AMPLITUDE, NAME=A, TIME=TOTAL TIME\n0., 0., 1., 1., 3., 5.\n" +
                  step_of("*CONNECTOR MOTION\n7, 1, 2.\n") +
                  "*STEP\n*STATIC, DIRECT\n0.25, 2.\n*CONNECTOR MOTION, AMPLITUDE=A\nJOINT, 1, 2.\n"
                  "*CHANGE FRICTION, ELSET=JOINT\n*FRICTION\n0.4\n*END STEP\n"
                  "*STEP\n*FREQUENCY\n10\n*END STEP\n")));
  const std::vector<base::ParameterText> forces{{"f2", 3.0}, {"f3", 4.0}};
  CHECK(failed(written.text + at_the_end("CP1 - 50", "6", 2.0), forces).empty());
  CHECK(failed(written.text + at_the_end("CP1 - 50", "10", 3.0), forces).empty());
  CHECK(failed(written.text + at_the_end("MU", "0.25", 2.0), forces).empty());
  CHECK(failed(written.text + at_the_end("FLIM", "4", 3.0), forces).empty());
}

TEST_CASE("OP=NEW takes away what a step does not state again") {
  Folder folder;
  const std::string sticky =
      "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION, ELASTIC SLIP=0.01\n0.1\n";
  const std::string two = "*STEP\n*STATIC\n0.1, 1.\n";
  const auto written = [&](const std::string& first, const std::string& second) {
    return case_of(
        folder.read(deck_of("SLIDE-PLANE", sticky, step_of(first) + two + second + "*END STEP\n")));
  };
  const std::vector<base::ParameterText> forces{{"f1", 20.0}};
  const std::string moves = "*CONNECTOR MOTION\nJOINT, 2, 3.\nJOINT, 3, 0.\n";
  // Let go, the friction of a plane springs back until nothing pulls.
  const WrittenCase freed = written(moves, "*CONNECTOR MOTION, OP=NEW\nJOINT, 3, 0.\n");
  INFO(freed.text);
  CHECK_THAT(freed.text, Catch::Contains("OP=NEW lets component 2 go in step 1"));
  CHECK(failed(freed.text + at_the_end("CSF2", "0", 2.0), forces).empty());
  const WrittenCase held = written(moves, "*CONNECTOR MOTION\nJOINT, 3, 0.\n");
  CHECK(failed(held.text + at_the_end("CP2", "3", 2.0), forces).empty());
  // A load goes as it came.
  const std::string loads = "*CONNECTOR LOAD\nJOINT, 2, 1.\nJOINT, 3, 0.5\n";
  const WrittenCase unloaded = written(loads, "*CONNECTOR LOAD, OP=NEW\nJOINT, 3, 0.5\n");
  INFO(unloaded.text);
  CHECK(failed(unloaded.text + at_the_end("CSF2", "0.5", 1.5), forces).empty());
  CHECK(failed(unloaded.text + at_the_end("CSF2", "0", 2.0), forces).empty());
  const WrittenCase loaded = written(loads, "*CONNECTOR LOAD\nJOINT, 3, 0.5\n");
  CHECK(failed(loaded.text + at_the_end("CSF2", "1", 2.0), forces).empty());
}

TEST_CASE("A step behind a periodic motion sets out from its end") {
  Folder folder;
  const std::string more = "*STEP\n*STATIC\n0.1, 1.\n*CONNECTOR MOTION";
  for (const auto& [second, end] : {std::pair<std::string, std::string>{", FIXED\nJOINT, 1\n", "0"},
                                    {", TYPE=VELOCITY\nJOINT, 1, 4.\n", "4"}}) {
    const WrittenCase written = case_of(folder.read(deck_of(
        "SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n",
        "*AMPLITUDE, NAME=A, DEFINITION=PERIODIC\n2, 3., 0.2, 0.5\n0.25, -0.75, 0.1, 0.2\n" +
            step_of("*CONNECTOR MOTION, AMPLITUDE=A\nJOINT, 1, 2.\n") + more + second +
            "*END STEP\n")));
    INFO(written.text);
    const std::string last =
        "2*(0.5 + 0.25*cos(2.4) - 0.75*sin(2.4) + 0.1*cos(4.8) + 0.2*sin(4.8))";
    CHECK(failed(written.text + at_the_end("CP1 - 50", last + " + " + end, 2.0),
                 {{"f2", 1.0}, {"f3", 1.0}})
              .empty());
  }
}

TEST_CASE("AMPLITUDE=STEP brings loads and changes of friction at once") {
  Folder folder;
  const WrittenCase written = case_of(folder.read(deck_of(
      "SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION, ELASTIC SLIP=0.01\n0.1\n",
      step_of("*CONNECTOR MOTION\n7, 1, 2.\n") +
          "*STEP, AMPLITUDE=STEP\n*STATIC\n0.25, 1.\n*CONNECTOR LOAD\nJOINT, 1, 0.3\n"
          "*CHANGE FRICTION, ELSET=JOINT\n*FRICTION, ELASTIC SLIP=0.01\n0.4\n*END STEP\n")));
  INFO(written.text);
  const std::vector<base::ParameterText> forces{{"f2", 3.0}, {"f3", 4.0}};
  CHECK(failed(written.text + at_the_end("CSF1", "0.3", 1.25), forces).empty());
  CHECK(failed(written.text + at_the_end("MU", "0.4", 1.25), forces).empty());
}

TEST_CASE("AMPLITUDE=STEP makes a motion in the first increment") {
  Folder folder;
  const WrittenCase written = case_of(folder.read(
      deck_of("SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n",
              "*STEP, AMPLITUDE=STEP\n*STATIC\n0.25, 1.\n*CONNECTOR MOTION\n7, 1, 2.\n*END STEP\n"
              "*STEP, AMPL=S\n*STATIC\n0.25, 1.\n*CONNECTOR MOTION\nJOINT, 1, 5.\n*END STEP\n")));
  INFO(written.text);
  const std::vector<base::ParameterText> forces{{"f2", 3.0}, {"f3", 4.0}};
  CHECK(failed(written.text + at_the_end("CP1 - 50", "2", 0.25), forces).empty());
  CHECK(failed(written.text + at_the_end("CP1 - 50", "2", 1.0), forces).empty());
  CHECK(failed(written.text + at_the_end("CP1 - 50", "5", 1.25), forces).empty());
  CHECK(failed(written.text + at_the_end("CP1 - 50", "5", 2.0), forces).empty());
}

TEST_CASE("Velocities and amplitudes over the total time go on until they are stated again") {
  Folder folder;
  const std::string friction =
      "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION, ELASTIC SLIP=0.01\n0.1\n";
  const std::string total = "*AMPLITUDE, NAME=A, TIME=TOTAL TIME\n0., 0., 3., 3.\n";
  const std::string own = "*AMPLITUDE, NAME=A\n0., 0., 1., 1.\n";
  // Text of the first and the second of three steps, and the position at the end of each.
  const auto at = [&](const std::string& amplitude, const std::string& first,
                      const std::string& second, const std::array<std::string, 3>& ends) {
    const std::string begin = "*STEP\n*STATIC\n0.1, 1.\n";
    const WrittenCase written = case_of(
        folder.read(deck_of("SLOT", friction,
                            amplitude + step_of("*CONNECTOR MOTION" + first + "\nJOINT, 1, 2.\n") +
                                begin + second + "*END STEP\n" + begin + "*END STEP\n")));
    INFO(written.text);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(failed(written.text + at_the_end("CP1 - 50", ends[i], 1.0 + static_cast<double>(i)),
                   {{"f2", 1.0}, {"f3", 1.0}})
                .empty());
    }
  };
  at("", ", TYPE=VELOCITY", "", {"2", "4", "6"});
  at("", ", TYPE=VELOCITY", "*CONNECTOR MOTION, TYPE=VELOCITY\n7, 1, -1.\n", {"2", "1", "0"});
  at("", ", TYPE=VELOCITY", "*CONNECTOR MOTION, FIXED\nJOINT, 1\n", {"2", "2", "2"});
  at("", "", "", {"2", "2", "2"});
  at(total, ", AMPLITUDE=A", "", {"2", "4", "6"});
  at(total, ", AMPLITUDE=A, TYPE=VELOCITY", "", {"1", "4", "9"});
  at(own, ", AMPLITUDE=A", "", {"2", "2", "2"});
  at(own, ", AMPLITUDE=A, TYPE=VELOCITY", "", {"1", "3", "5"});
  at(total, ", AMPLITUDE=A", "*CONNECTOR MOTION\nJOINT, 1, 3.\n", {"2", "3", "3"});
  const auto force_at_2 = [&](const std::string& second, const std::string& force) {
    const WrittenCase written = case_of(
        folder.read(deck_of("SLOT", friction,
                            total + step_of("*CONNECTOR LOAD, AMPLITUDE=A\nJOINT, 1, 0.1\n") +
                                "*STEP\n*STATIC\n0.1, 1.\n" + second + "*END STEP\n")));
    INFO(written.text);
    CHECK(
        failed(written.text + at_the_end("CSF1", force, 2.0), {{"f2", 1.0}, {"f3", 1.0}}).empty());
  };
  force_at_2("", "0.2");
  force_at_2("*CONNECTOR LOAD, OP=NEW\n", "0");
  // A motion that OP=NEW takes away does not go on.
  const WrittenCase freed = case_of(
      folder.read(deck_of("SLOT", friction,
                          step_of("*CONNECTOR MOTION, TYPE=VELOCITY\nJOINT, 1, 2.\n") +
                              "*STEP\n*STATIC\n0.1, 1.\n*CONNECTOR MOTION, OP=NEW\n*END STEP\n")));
  CHECK(failed(freed.text + at_the_end("CSF1", "0", 2.0), {{"f2", 1.0}, {"f3", 1.0}}).empty());
}

TEST_CASE("Of two lines for one component in one step the last one holds") {
  Folder folder;
  const WrittenCase written =
      case_of(folder.read(deck_of("SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n",
                                  step_of("*CONNECTOR MOTION\nJOINT, 1, 1.\n7, 1, 2.\n"
                                          "*CHANGE FRICTION, ELSET=JOINT\n*FRICTION\n0.2\n"
                                          "*CHANGE FRICTION, ELSET=JOINT\n*FRICTION\n0.4\n"))));
  INFO(written.text);
  CHECK_THAT(written.text,
             Catch::Contains("CP1: stated twice in slide (d.inp:19 and d.inp:20): the last one"));
  CHECK_THAT(written.text, Catch::Contains("*CHANGE FRICTION: twice in slide (d.inp:21 and"));
  const std::vector<base::ParameterText> forces{{"f2", 3.0}, {"f3", 4.0}};
  CHECK(failed(written.text + at_the_end("CP1 - 50", "2"), forces).empty());
  CHECK(failed(written.text + at_the_end("MU", "0.4"), forces).empty());
}

TEST_CASE("A change of friction begins with its step, and has the stick of its own *FRICTION") {
  Folder folder;
  const WrittenCase written = case_of(folder.read(
      deck_of("SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION, ELASTIC SLIP=0.01\n0.1\n",
              "*AMPLITUDE, NAME=A, TIME=TOTAL TIME\n0., 0., 1., 0., 1.5, 1., 9., 1.\n" +
                  step_of("*CONNECTOR MOTION\n7, 1, 2.\n") +
                  "*STEP\n*STATIC\n0.1, 1.\n*CONNECTOR MOTION\nJOINT, 1, 4.\n"
                  "*CHANGE FRICTION, ELSET=JOINT, AMPLITUDE=A\n*FRICTION\n0.4\n*END STEP\n")));
  INFO(written.text);
  const std::vector<base::ParameterText> forces{{"f2", 3.0}, {"f3", 4.0}};
  CHECK(failed(written.text + at_the_end("MU", "0.4", 1.5), forces).empty());
  CHECK_THAT(written.text, Catch::Contains("stick: {slip_tolerance: 0.0001}"));
}

TEST_CASE("Values of a subroutine and rounded corners are told") {
  Folder folder;
  const std::string friction = "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n";
  const WrittenCase user = case_of(
      folder.read(deck_of("SLOT", friction, step_of("*CONNECTOR MOTION, USER\nJOINT, 1, 1.\n"))));
  CHECK_THAT(user.text, Catch::Contains("USER, a subroutine gives its values"));
  CHECK(std::find(user.asked.begin(), user.asked.end(), "CP1") != user.asked.end());
  const WrittenCase smooth =
      case_of(folder.read(deck_of("SLOT", friction,
                                  "*AMPLITUDE, NAME=A, SMOOTH=0.25\n0., 0., 0.5, 1., 1., 0.\n" +
                                      step_of("*CONNECTOR MOTION, AMPLITUDE=A\nJOINT, 1, 1.\n"))));
  CHECK_THAT(smooth.text, Catch::Contains("SMOOTH rounds the corners"));
  const WrittenCase none =
      case_of(folder.read(deck_of("SLOT", "*CONNECTOR FRICTION, PREDEFINED\n5.\n")));
  CHECK_THAT(none.text, Catch::Contains("has no *FRICTION: its coefficient is 0"));
}

TEST_CASE("A set of an instance names the elements of that instance alone") {
  Folder folder;
  const ReadDeck read = folder.read(
      "*PART, NAME=P\n*NODE\n1, 1., 0., 0.\n2, 1., 30., 0.\n*ELEMENT, TYPE=CONN3D2, ELSET=E\n"
      "5, 1, 2\n*CONNECTOR SECTION, ELSET=E, BEHAVIOR=B\nSLOT\n*END PART\n*ASSEMBLY, NAME=A\n"
      "*INSTANCE, NAME=one, PART=P\n*END INSTANCE\n*INSTANCE, NAME=two, PART=P\n*END INSTANCE\n"
      "*ELSET, ELSET=FIRST, INSTANCE=one\n5\n*ELSET, ELSET=SECOND, INSTANCE=two, GENERATE\n"
      "1, 9, 1\n*ELSET, ELSET=ALSO\nSECOND\n*END ASSEMBLY\n"
      "*CONNECTOR BEHAVIOR, NAME=B\n*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n" +
      step_of("*CONNECTOR MOTION\nFIRST, 1, 1.\nALSO, 1, 2.\none.E, 1, 3.\n"));
  REQUIRE(read.said.empty());
  REQUIRE(read.model.connectors.size() == 2);
  const auto named = [&](std::size_t i, const std::string& set) {
    return read.model.connectors[i].labels.count(set) > 0;
  };
  CHECK(named(0, "FIRST"));
  CHECK_FALSE(named(1, "FIRST"));
  CHECK(named(0, "ONE.E"));
  for (const std::string set : {"SECOND", "ALSO"}) {
    CHECK_FALSE(named(0, set));
    CHECK(named(1, set));
  }
}

TEST_CASE("Positions come from nodes, orientations and instances") {
  Folder folder;
  const ReadDeck read = folder.read(
      "*PART, NAME=P\n*NODE\n1, 1., 0., 0.\n2, 1., 30., 0.\n*ELEMENT, TYPE=CONN3D2, ELSET=E\n"
      "5, 1, 2\n*ORIENTATION, NAME=O\n0., 2., 0., -3., 0., 0.\n"
      "*CONNECTOR SECTION, ELSET=E, BEHAVIOR=B\nSLOT\nO\n*END PART\n*ASSEMBLY, NAME=A\n"
      "*INSTANCE, NAME=one, PART=P\n*END INSTANCE\n"
      "*INSTANCE, NAME=two, PART=P\n100., 0., 0.\n0., 0., 0., 0., 0., 1., 90.\n*END INSTANCE\n"
      "*ELEMENT, TYPE=CONN3D2, ELSET=F\n1, one.1, two.1\n"
      "*CONNECTOR SECTION, ELSET=F, BEHAVIOR=B\nSLIPRING\n*END ASSEMBLY\n"
      "*CONNECTOR BEHAVIOR, NAME=B\n*CONNECTOR FRICTION, PREDEFINED\n*FRICTION\n0.1\n");
  REQUIRE(read.model.connectors.size() == 3);
  CHECK(read.model.connectors[0].name == "one.5");
  CHECK(read.model.connectors[1].name == "two.5");
  for (const std::size_t i : {0U, 1U}) {
    CHECK_THAT(case_of(read, i).text, Catch::Contains("initial: {CP1: 30}"));
  }
  // Node 1 of the second instance: 100 to the right, then a quarter turn, at (0, 101).
  CHECK_THAT(case_of(read, 2).text,
             Catch::Contains(fmt::format("CP1: {:.8f}", std::hypot(1.0, 101.0))));
}

TEST_CASE("Names may be shortened, files included and numbers named") {
  Folder folder;
  folder.folder.write("n.inc", "1, 0., 0., 0.\r\n** half of it\r\n");
  folder.folder.write("b.inc", "*CONNECTOR BEHAV, NAME=B\n*CONNECTOR FRIC, PRED\n<Force>\n");
  const WrittenCase written = case_of(folder.read(
      "*PARAMETER\nbase = 2*3   # comment\nforce = base**2/4 + 1.\n"
      "*NODE\n*INCLUDE, INPUT=n.inc\n2, 50., 0., 0.\n*ELEMENT, TYPE=CONN3D2,\n  ELSET=JOINT\n"
      "7, 1, 2\n*CONNECTOR SECT, ELS=JOINT, BEH=B\nslot,\n*INCLUDE, "
      "INPUT=b.inc\n*FRICTION\n0.1\n"));
  CHECK_THAT(written.text, Catch::Contains("internal_contact_force: 10}"));
  CHECK_THAT(written.text, Catch::Contains("initial: {CP1: 50}"));
}

TEST_CASE("Values of parameters may be shortened to what is unique") {
  Folder folder;
  const std::string friction = "*CONNECTOR FRICTION, PREDEFINED\n5.\n*FRICTION\n0.1\n";
  const Model model =
      folder
          .read(deck_of("SLOT", friction,
                        "*AMPLITUDE, NAME=A, TIME=TOTAL, VALUE=ABS, DEF=TAB\n0., 0., 1., 1.\n"
                        "*STEP, AMPL=S\n*STATIC\n0.1, 1.\n*CONNECTOR LOAD, OP=N\nJOINT, 1, 1.\n"
                        "*CONNECTOR MOTION, OP=N, TYPE=V\nJOINT, 1, 1.\n*CLOAD, OP=N\n2, 2, 1.\n"
                        "*END STEP\n*STEP, AMPL=R\n*STATIC\n*CONNECTOR LOAD, OP=M\nJOINT, 1, 1.\n"
                        "*END STEP\n"))
          .model;
  REQUIRE(model.steps.size() == 2);
  CHECK(model.steps[0].at_once == true);
  CHECK(model.steps[0].new_loads);
  CHECK(model.steps[0].new_motions);
  CHECK(model.steps[0].new_of_nodes);
  CHECK(model.steps[0].drives.at(1).type == "VELOCITY");
  CHECK(model.steps[1].at_once == false);
  CHECK_FALSE(model.steps[1].new_loads);
  CHECK(model.amplitudes.begin()->second.total_time);
  CHECK(model.amplitudes.begin()->second.absolute);
  const auto said = [&](const std::string& text) {
    const ReadDeck read = folder.read(deck_of("SLOT", friction, text));
    return read.said.empty() ? "nothing" : read.said.front();
  };
  CHECK(said("*STEP, AMPLITUDE=FAST\n*STATIC\n*END STEP\n") ==
        "15:8: *STEP: AMPLITUDE is RAMP or STEP");
  CHECK(said(step_of("*CONNECTOR LOAD, OP=OLD\nJOINT, 1, 1.\n")) ==
        "18:18: *CONNECTOR LOAD: OP is MOD or NEW");
  CHECK(said("*STEP, N\n*STATIC\n*END STEP\n") == "15:8: *STEP: 'N' may mean NAME or NLGEOM");
  CHECK(said("*STEP, NEWTON=1\n*STATIC\n*END STEP\n") == "nothing");
}

TEST_CASE("A fault of a deck is told with its line") {
  Folder folder;
  const auto said = [&](const std::string& behavior, const std::string& rest = "") {
    const ReadDeck read = folder.read(deck_of("SLOT", behavior, rest));
    return read.said.empty() ? "nothing" : read.said.front();
  };
  CHECK(said("*CONNECTOR FRICTION\n0.34, 0.55, 0.0\n*FRICTION\n0.15\n") ==
        "12:1: *CONNECTOR FRICTION: three numbers without a parameter are a form that is no longer "
        "read");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED, COMPONENT=1\n0.24\n") ==
        "11:34: *CONNECTOR FRICTION: PREDEFINED goes with no COMPONENT: it states the contact "
        "force itself");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED\n1.\n*FRICTION, EXPONENTIAL DECAY, TAUMAX=5.\n"
             "0.3, 0.1, 0.2\n") == "13:31: *FRICTION: TAUMAX goes with no EXPONENTIAL DECAY");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED\n1.\n*FRICTION, ROUGH\n") ==
        "13:12: *FRICTION: ROUGH is not for connectors");
  CHECK(said("*FRICTION\n0.1\n") == "11:1: *FRICTION: belongs behind a *CONNECTOR FRICTION");
  CHECK(said("*CONNECTOR S, COMPONENT=1\n1., 2.\n") ==
        "11:1: *CONNECTOR S: may mean CONNECTOR SECTION or CONNECTOR STOP");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED, FORCE=1\n1.\n") ==
        "11:34: *CONNECTOR FRICTION: *CONNECTOR FRICTION has no parameter 'FORCE'");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED\n1.x\n") ==
        "12:1: *CONNECTOR FRICTION: '1.x' is no number: wanted one line of numbers");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED\n<r>\n") ==
        "12:1: *CONNECTOR FRICTION: <r> is no name of *PARAMETER: wanted one line of numbers");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED\n1.\n*FRICTION\n0.1, 1., 1., 1., 1.\n") ==
        "14:18: *FRICTION: is one number too many: wanted mu, slip rate, contact force, "
        "temperature, fields");
  CHECK(said("", "*AMPLITUDE, NAME=A\n0., 0., 1., 1., 0.5, 2.\n") ==
        "12:17: *AMPLITUDE: times must not fall: 0.5 stands behind 1");
  CHECK(said("", "*STEP\n*STATIC\n1., 1.\n") ==
        "11:1: *STEP: has no *END STEP: the deck ends in this step");
  CHECK(said("", "*STEP\n*STATIC\n1., 1.\n*STEP\n*STATIC\n1., 1.\n*END STEP\n") ==
        "14:1: *STEP: stands in the step of d.inp:11, which has no *END STEP");
  CHECK(said("", "*STEP\n*STATIC\n1., 1.\n*CHANGE FRICTION, ELSET=JOINT\n*END STEP\n") ==
        "14:1: *CHANGE FRICTION: wants a *FRICTION behind it, or RESET");
  CHECK(said("*CONECTOR FRICTION, PREDEFINED\n5.\n") ==
        "11:1: *CONECTOR FRICTION: is no keyword that is known");
  CHECK(said("*CONNECTOR FRICTION, PREDEFINED\n5.\n*MATERIAL, NAME=STEEL\n*DENSITY\n7.8\n") ==
        "nothing");
  CHECK(said("*INCLUDE, INPUT=../up.inc\n")
            .find("11:11: *INCLUDE: '../up.inc' contains '..'; a case, fit or deck reads") == 0);
  CHECK(said("*INCLUDE, INPUT=no.inc\n").find("11:11: *INCLUDE: ") == 0);
  CHECK(said("*INCLUDE, INPUT=d.inp\n").find("files include each other without end") !=
        std::string::npos);
  CHECK(said("", "*CONNECTOR FRICTION, PREDEFINED\n").find("nothing") == 0);
}

TEST_CASE("Joints that the bench does not model are passed over with a reason") {
  Folder folder;
  const auto reason = [&](const std::string& type, const std::string& behavior) {
    const ReadDeck read = folder.read(deck_of(type, behavior));
    INFO((read.said.empty() ? "" : read.said.front()));
    REQUIRE(read.model.connectors.size() == 1);
    const auto written =
        write_case(*read.deck, read.model, read.model.connectors[0], {"d.inp", ""});
    return written ? "" : written.error();
  };
  const std::string friction = "*CONNECTOR FRICTION, PREDEFINED\n1.\n*FRICTION\n0.1\n";
  CHECK(reason("SLOT", friction).empty());
  CHECK(reason("SLOT", friction + "*CONNECTOR PLASTICITY, COMPONENT=1\n") ==
        "its behaviour has *CONNECTOR PLASTICITY (d.inp:15), which the bench does not model");
  CHECK(reason("WHATEVER", friction) == "the bench has no connection type WHATEVER");
  CHECK(reason("SLOT, HINGE", friction) == "SLOT and HINGE make no connection");
  CHECK(reason("CYLINDRICAL", "*CONNECTOR FRICTION, PREDEFINED\n\n*FRICTION\n0.1\n") ==
        "R is missing");
  CHECK_THAT(reason("SLOT", "*CONNECTOR FRICTION, COMPONENT=2\n1.\n*FRICTION\n0.1\n"),
             Catch::Contains("component"));
  CHECK_THAT(reason("SLOT", "*CONNECTOR FRICTION\n1.\n*FRICTION\n0.1\n"),
             Catch::Contains("neither PREDEFINED nor has it a component or a potential"));
}

}  // namespace
}  // namespace slipbench::driver::abaqus
