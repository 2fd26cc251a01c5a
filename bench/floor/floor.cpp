// SPDX-License-Identifier: Apache-2.0
// The least that the workloads of bench/run take: loops by hand that know one problem each, judge
// nothing and refuse nothing. The last line that is printed is JSON: the end state.
// usage: floor slot N [OUT.csv] | plane IN.csv OUT.csv | update N | sweep LEVELS STEPS | compare A
// B
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kEndTime = 100.0;

/// Columns of text, written by pieces of a megabyte.
class Text {
 public:
  explicit Text(const char* name) : file_(std::fopen(name, "w")) {
    if (file_ == nullptr) std::exit(2);
  }
  ~Text() {
    flush();
    std::fclose(file_);
  }
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  void header(std::string_view names) { text_.append(names) += '\n'; }
  template <std::size_t Count>
  void row(const std::array<double, Count>& numbers) {
    std::array<char, 32> digits{};
    for (const double number : numbers) {
      const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
      text_.append(digits.data(), end) += ',';
    }
    text_.back() = '\n';
    if (text_.size() > kPiece) flush();
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 20U;
  void flush() {
    std::fwrite(text_.data(), 1, text_.size(), file_);
    text_.clear();
  }
  std::FILE* file_;
  std::string text_;
};

/// SLOT with a constant limit of 12 under u = sin(2 pi t).
int slot(long steps, const char* out) {
  constexpr double kStiffness = 1e4;
  constexpr double kLimit = 0.2 * (50.0 + 10.0);
  // Ten steps are one cycle, more are a hundred.
  const double end = steps == 10 ? 1.0 : kEndTime;
  double force = 0.0;
  double slip = 0.0;
  double accumulated = 0.0;
  double before = 0.0;
  const auto run = [&](const auto& write) {
    for (long i = 0; i <= steps; ++i) {
      const double t = end * static_cast<double>(i) / static_cast<double>(steps);
      const double u = std::sin(kTurn * t);
      const double trial = force + kStiffness * (u - before);
      before = u;
      force = std::clamp(trial, -kLimit, kLimit);
      const double passed = (trial - force) / kStiffness;
      slip += passed;
      accumulated += std::abs(passed);
      write(t, u);
    }
  };
  if (out != nullptr) {
    Text text(out);
    text.header("t,u,force,slip,accumulated");
    run([&](double t, double u) { text.row(std::array{t, u, force, slip, accumulated}); });
  } else {
    run([](double, double) {});
  }
  std::printf("{\"f\": %.17g, \"slip\": %.17g, \"s\": %.17g}\n", force, slip, accumulated);
  return 0;
}

constexpr std::array kRates{0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
constexpr std::array kTemperatures{0.0, 50.0, 100.0, 200.0};
constexpr std::array<std::array<double, 8>, 4> kMu{{{.30, .27, .25, .23, .20, .18, .17, .16},
                                                    {.28, .25, .235, .22, .19, .175, .165, .155},
                                                    {.25, .23, .215, .20, .18, .165, .155, .15},
                                                    {.20, .19, .18, .17, .16, .15, .145, .14}}};
constexpr std::array kSlips{0.0, 5.0, 10.0, 20.0, 50.0, 100.0, 500.0, 1000.0};
constexpr std::array kGrips{100.0, 98.0, 95.0, 90.0, 80.0, 72.0, 60.0, 55.0};

template <std::size_t Count>
double line(const std::array<double, Count>& x, const std::array<double, Count>& y, double at) {
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  std::size_t i = 0;
  while (at >= x[i + 1]) ++i;
  return y[i] + (y[i + 1] - y[i]) * (at - x[i]) / (x[i + 1] - x[i]);
}

double coefficient(double rate, double temperature) {
  const std::size_t row = temperature < kTemperatures[1]   ? 0
                          : temperature < kTemperatures[2] ? 1
                                                           : 2;
  const double share =
      (temperature - kTemperatures[row]) / (kTemperatures[row + 1] - kTemperatures[row]);
  const double low = line(kRates, kMu[row], rate);
  return low + share * (line(kRates, kMu[row + 1], rate) - low);
}

/// Motions, normal force and temperature at one time.
struct Drive {
  double t = 0, u2 = 0, u3 = 0, f1 = 0, temperature = 0;
};

Drive drive(double t) {
  return {t, std::sin(kTurn * t), 0.5 * std::sin(kTurn * 1.37 * t + 0.3),
          500.0 + 200.0 * std::sin(kTurn * 0.31 * t), 60.0 + 40.0 * std::sin(kTurn * 0.05 * t)};
}

/// SLIDE-PLANE with two tables: rate of the motion, grip at the start of the increment.
struct Plane {
  double f2 = 0, f3 = 0, s = 0, mu = 0, normal = 0, size = 0;
  bool slips = false;

  void step(const Drive& begin, const Drive& end) {
    constexpr double kStiffness = 2e3;
    const double d2 = end.u2 - begin.u2;
    const double d3 = end.u3 - begin.u3;
    f2 += kStiffness * d2;
    f3 += kStiffness * d3;
    size = std::sqrt(f2 * f2 + f3 * f3);
    mu = coefficient(std::sqrt(d2 * d2 + d3 * d3) / (end.t - begin.t), end.temperature);
    normal = std::abs(end.f1 + line(kSlips, kGrips, s));
    const double limit = mu * normal;
    slips = size > limit;
    if (!slips) return;
    f2 *= limit / size;
    f3 *= limit / size;
    s += (size - limit) / kStiffness;
    size = limit;
  }
};

void print(const Plane& plane, double seconds) {
  std::printf("{\"f2\": %.17g, \"f3\": %.17g, \"s\": %.17g, \"seconds\": %.9g}\n", plane.f2,
              plane.f3, plane.s, seconds);
}

std::string whole(const char* name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

const char* number(const char* at, const char* end, double& value) {
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error != std::errc{}) std::exit(3);
  return stop + 1;
}

/// Returns where the line behind comments and header begins.
const char* rows_of(const std::string& text) {
  const char* at = text.data();
  while (*at == '#') at = std::strchr(at, '\n') + 1;
  return std::strchr(at, '\n') + 1;
}

int plane(const char* in, const char* out) {
  const std::string text = whole(in);
  const char* const end = text.data() + text.size();
  Text rows(out);
  rows.header("t,u2,u3,f1,T,f2,f3,s,mu,normal,slips,size");
  Plane state;
  Drive before;
  for (const char* at = rows_of(text); at < end;) {
    Drive now;
    for (double* value : {&now.t, &now.u2, &now.u3, &now.f1, &now.temperature}) {
      at = number(at, end, *value);
    }
    if (now.t > before.t) state.step(before, now);
    before = now;
    rows.row(std::array{now.t, now.u2, now.u3, now.f1, now.temperature, state.f2, state.f3, state.s,
                        state.mu, state.normal, state.slips ? 1.0 : 0.0, state.size});
  }
  print(state, 0.0);
  return 0;
}

/// The update alone, on a history in memory.
int update(long steps) {
  std::vector<Drive> history;
  for (long i = 0; i <= steps; ++i) {
    history.push_back(drive(kEndTime * static_cast<double>(i) / static_cast<double>(steps)));
  }
  Plane state;
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t i = 1; i < history.size(); ++i) state.step(history[i - 1], history[i]);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  print(state, elapsed.count());
  return 0;
}

/// Lanes that differ in stiffness, coefficient and grip, a block of them at a time.
struct Lanes {
  static constexpr std::size_t kWidth = 64;
  using Numbers = std::array<double, kWidth>;
  alignas(64) Numbers f2{}, f3{}, s{}, stiffness{}, mu{}, grip{};
};

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#endif
void step_lanes(Lanes& lanes, double d2, double d3, double f1, double mu) {
  for (std::size_t i = 0; i < Lanes::kWidth; ++i) {
    const double s = lanes.s[i];
    // The table as a sum of bends: no branch.
    double grip = kGrips[0];
    double slope = 0.0;
    for (std::size_t k = 0; k + 1 < kSlips.size(); ++k) {
      const double next = (kGrips[k + 1] - kGrips[k]) / (kSlips[k + 1] - kSlips[k]);
      const double beyond = s - kSlips[k];
      grip += (next - slope) * (beyond > 0.0 ? beyond : 0.0);
      slope = next;
    }
    const double limit = mu * lanes.mu[i] * std::abs(f1 + lanes.grip[i] * grip);
    const double x = lanes.f2[i] + lanes.stiffness[i] * d2;
    const double y = lanes.f3[i] + lanes.stiffness[i] * d3;
    const double size = std::sqrt(x * x + y * y);
    const double over = size > limit ? size - limit : 0.0;
    const double share = (size - over) / (size > 1e-300 ? size : 1e-300);
    lanes.f2[i] = x * share;
    lanes.f3[i] = y * share;
    lanes.s[i] = s + over / lanes.stiffness[i];
  }
}

/// All combinations of `levels` values of three numbers over the first `steps` milliseconds.
int sweep(long levels, long steps) {
  std::vector<Drive> history;
  std::vector<double> mu(1);
  for (long i = 0; i <= steps; ++i) history.push_back(drive(1e-3 * static_cast<double>(i)));
  for (std::size_t i = 1; i < history.size(); ++i) {
    const Drive& a = history[i - 1];
    const Drive& b = history[i];
    mu.push_back(coefficient(std::hypot(b.u2 - a.u2, b.u3 - a.u3) / (b.t - a.t), b.temperature));
  }
  const auto level = [&](long k, double low, double high) {
    return low + (high - low) * static_cast<double>(k) / static_cast<double>(levels - 1);
  };
  double f2 = 0.0;
  double s = 0.0;
  const long cases = levels * levels * levels;
  const long width = static_cast<long>(Lanes::kWidth);
  for (long first = 0; first < cases; first += width) {
    Lanes lanes;
    for (long i = 0; i < width; ++i) {
      const long id = std::min(first + i, cases - 1);
      const auto lane = static_cast<std::size_t>(i);
      lanes.stiffness[lane] = 2e3 * level(id / (levels * levels), 0.9, 1.1);
      lanes.mu[lane] = level(id / levels % levels, 0.8, 1.2);
      lanes.grip[lane] = level(id % levels, 0.9, 1.1);
    }
    for (std::size_t i = 1; i < history.size(); ++i) {
      step_lanes(lanes, history[i].u2 - history[i - 1].u2, history[i].u3 - history[i - 1].u3,
                 history[i].f1, mu[i]);
    }
    for (long i = 0; i < std::min(width, cases - first); ++i) {
      f2 += lanes.f2[static_cast<std::size_t>(i)];
      s += lanes.s[static_cast<std::size_t>(i)];
    }
  }
  std::printf("{\"f2\": %.17g, \"s\": %.17g}\n", f2 / static_cast<double>(cases),
              s / static_cast<double>(cases));
  return 0;
}

/// Tells by the exit code whether all numbers of two files agree.
int compare(const char* first, const char* second) {
  const std::string a = whole(first);
  const std::string b = whole(second);
  const char* p = rows_of(a);
  const char* q = rows_of(b);
  const char* const p_end = a.data() + a.size();
  const char* const q_end = b.data() + b.size();
  bool agree = true;
  while (p < p_end && q < q_end) {
    double x = 0.0;
    double y = 0.0;
    p = number(p, p_end, x);
    q = number(q, q_end, y);
    agree = agree && std::abs(x - y) <= 1e-9 + 1e-9 * std::abs(y);
  }
  return agree && p >= p_end && q >= q_end ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 2 ? argv[1] : "";
  if (what == "slot") return slot(std::atol(argv[2]), argc > 3 ? argv[3] : nullptr);
  if (what == "update") return update(std::atol(argv[2]));
  if (what == "plane" && argc > 3) return plane(argv[2], argv[3]);
  if (what == "sweep" && argc > 3) return sweep(std::atol(argv[2]), std::atol(argv[3]));
  if (what == "compare" && argc > 3) return compare(argv[2], argv[3]);
  return 2;
}
