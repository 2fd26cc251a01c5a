// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/trust_region.hpp"

#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_multilarge_nlinear.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>

namespace slipbench::driver::fit {
namespace {

/// Entries of the Jacobian from which the normal equations are faster; their loss of digits is
/// made up for by the steps by QR at the end.
constexpr std::size_t kManyEntries = 4000;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// G u or G^T u of a row-major G.
void multiply(const std::vector<double>& entries, CBLAS_TRANSPOSE_t transposed, const gsl_vector* u,
              gsl_vector* v) {
  const bool by_rows = transposed == CblasTrans;
  const auto columns = static_cast<Eigen::Index>(by_rows ? v->size : u->size);
  const auto rows = static_cast<Eigen::Index>(entries.size()) / columns;
  const Eigen::Map<const RowMajor> jacobian(entries.data(), rows, columns);
  const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>> from(
      u->data, static_cast<Eigen::Index>(u->size),
      Eigen::InnerStride<>(static_cast<Eigen::Index>(u->stride)));
  Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<>> to(
      v->data, static_cast<Eigen::Index>(v->size),
      Eigen::InnerStride<>(static_cast<Eigen::Index>(v->stride)));
  if (by_rows) {
    to.noalias() = jacobian.transpose() * from;
  } else {
    to.noalias() = jacobian * from;
  }
}

/// State that GSL's callbacks work on. The model is never asked twice for the same.
class Callbacks {
 public:
  Callbacks(Objective& objective, SearchPoint& here, SearchPoint& trial)
      : objective_(objective),
        here_(here),
        trial_(trial),
        root_weights_(objective.root_weights(here)),
        z_(here.z) {}

  /// \param[out] f sqrt(w) r; huge where the model has no value, so that the step is refused
  void residuals(const gsl_vector* free, gsl_vector* f) {
    constexpr double kHuge = 1e120;
    const std::span<double> out{f->data, f->size};
    set(free);
    if (z_ == here_.z) {
      objective_.weigh(here_, root_weights_, out, {});
    } else if (try_point()) {
      objective_.weigh(trial_, root_weights_, out, {});
    } else {
      std::fill(out.begin(), out.end(), kHuge);
    }
  }

  /// Brings the derivatives to the free coordinates; false where the model has none.
  bool move_to(const gsl_vector* free) {
    set(free);
    if (z_ == here_.z) return true;
    const bool known = tried_with_derivatives_ && trial_.z == z_;
    if (!known && !objective_.derivatives(z_, trial_, false)) return false;
    std::swap(here_, trial_);
    tried_with_derivatives_ = false;
    accepted_ = true;
    current_ = false;
    return true;
  }

  /// G^T u and, where asked for, G^T G.
  void products(const gsl_vector* u, gsl_vector* v, gsl_matrix* normal);

  void jacobian(std::span<double> out) const { objective_.weigh(here_, root_weights_, {}, out); }

  /// sqrt(w) dr/dz, kept for as long as the point stays.
  const std::vector<double>& kept_jacobian() {
    if (!current_) {
      jacobian_.resize(here_.residuals.size() * objective_.free().size());
      jacobian(jacobian_);
      current_ = true;
    }
    return jacobian_;
  }

 private:
  /// A point after one that was accepted is likely to be accepted, too: then its derivatives are
  /// wanted.
  bool try_point() {
    const bool with = accepted_ && objective_.evaluator().has_cheap_derivatives();
    accepted_ = false;
    tried_with_derivatives_ = with && objective_.derivatives(z_, trial_, false);
    return tried_with_derivatives_ || objective_.cost(z_, trial_);
  }

  void set(const gsl_vector* free) {
    const std::span<const std::size_t> coordinate = objective_.free();
    for (std::size_t c = 0; c < coordinate.size(); ++c) {
      z_[coordinate[c]] = gsl_vector_get(free, c);
    }
  }

  Objective& objective_;
  SearchPoint& here_;
  SearchPoint& trial_;
  std::vector<double> root_weights_;
  std::vector<double> z_;
  std::vector<double> f_;
  std::vector<double> jacobian_;
  bool current_ = false;
  bool accepted_ = true;
  bool tried_with_derivatives_ = false;
};

void Callbacks::products(const gsl_vector* u, gsl_vector* v, gsl_matrix* normal) {
  const Eigen::MatrixXd all = objective_.normal_products(here_, root_weights_);
  const auto columns = static_cast<std::size_t>(all.cols()) - 1;
  const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  if (v != nullptr) {
    f_.resize(here_.residuals.size());
    objective_.weigh(here_, root_weights_, f_, {});
    if (u->stride == 1 && std::equal(f_.begin(), f_.end(), u->data)) {
      for (std::size_t c = 0; c < columns; ++c) gsl_vector_set(v, c, all(at(c), all.cols() - 1));
    } else {
      multiply(kept_jacobian(), CblasTrans, u, v);
    }
  }
  if (normal == nullptr) return;
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t j = 0; j < columns; ++j) gsl_matrix_set(normal, i, j, all(at(i), at(j)));
  }
}

int residuals(const gsl_vector* free, void* callbacks, gsl_vector* f) {
  static_cast<Callbacks*>(callbacks)->residuals(free, f);
  return GSL_SUCCESS;
}

int small_jacobian(const gsl_vector* free, void* callbacks, gsl_matrix* jacobian) {
  auto& self = *static_cast<Callbacks*>(callbacks);
  if (!self.move_to(free)) return GSL_EBADFUNC;
  self.jacobian({jacobian->data, jacobian->size1 * jacobian->size2});
  return GSL_SUCCESS;
}

int large_products(CBLAS_TRANSPOSE_t transposed, const gsl_vector* free, const gsl_vector* u,
                   void* callbacks, gsl_vector* v, gsl_matrix* normal) {
  auto& self = *static_cast<Callbacks*>(callbacks);
  if (!self.move_to(free)) return GSL_EBADFUNC;
  if (transposed == CblasTrans) {
    self.products(u, v, normal);
  } else if (v != nullptr) {
    multiply(self.kept_jacobian(), transposed, u, v);
  }
  return GSL_SUCCESS;
}

/// |f|; GSL's own takes a division an element.
double length(const gsl_vector* f) {
  return Eigen::Map<const Eigen::VectorXd>(f->data, static_cast<Eigen::Index>(f->size)).norm();
}

/// Iterates until GSL finds no step or the gain has become small.
template <typename Iterate, typename Norm>
int iterate(const TrustRegionOptions& options, const Iterate& next, const Norm& norm) {
  int iterations = 0;
  int idle = 0;
  double before = norm();
  while (iterations < options.most_iterations && idle < options.most_idle) {
    if (next() != GSL_SUCCESS) break;
    ++iterations;
    const double after = norm();
    const double gain = 1.0 - (after / before) * (after / before);
    idle = gain > options.least_gain ? 0 : idle + 1;
    before = after;
    if (!(after > 0.0)) break;
  }
  return iterations;
}

struct FreeSmall {
  void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
};
struct FreeLarge {
  void operator()(gsl_multilarge_nlinear_workspace* w) const { gsl_multilarge_nlinear_free(w); }
};

int small(Callbacks& callbacks, std::size_t rows, const gsl_vector* start,
          const TrustRegionOptions& options) {
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  parameters.trs = options.scaling == TrustScaling::kAccelerated ? gsl_multifit_nlinear_trs_lmaccel
                                                                 : gsl_multifit_nlinear_trs_lm;
  parameters.solver = gsl_multifit_nlinear_solver_qr;
  parameters.scale =
      options.scaling == TrustScaling::kLevenberg   ? gsl_multifit_nlinear_scale_levenberg
      : options.scaling == TrustScaling::kMarquardt ? gsl_multifit_nlinear_scale_marquardt
                                                    : gsl_multifit_nlinear_scale_more;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, FreeSmall> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, rows, start->size));
  gsl_multifit_nlinear_fdf system{};
  system.f = residuals;
  system.df = small_jacobian;
  system.n = rows;
  system.p = start->size;
  system.params = &callbacks;
  if (!work || gsl_multifit_nlinear_init(start, &system, work.get()) != GSL_SUCCESS) return 0;
  return iterate(
      options, [&] { return gsl_multifit_nlinear_iterate(work.get()); },
      [&] { return length(work->f); });
}

int large(Callbacks& callbacks, std::size_t rows, const gsl_vector* start,
          const TrustRegionOptions& options) {
  gsl_multilarge_nlinear_parameters parameters = gsl_multilarge_nlinear_default_parameters();
  parameters.trs = gsl_multilarge_nlinear_trs_lm;
  parameters.solver = gsl_multilarge_nlinear_solver_cholesky;
  parameters.scale =
      options.scaling == TrustScaling::kLevenberg   ? gsl_multilarge_nlinear_scale_levenberg
      : options.scaling == TrustScaling::kMarquardt ? gsl_multilarge_nlinear_scale_marquardt
                                                    : gsl_multilarge_nlinear_scale_more;
  const std::unique_ptr<gsl_multilarge_nlinear_workspace, FreeLarge> work(
      gsl_multilarge_nlinear_alloc(gsl_multilarge_nlinear_trust, &parameters, rows, start->size));
  gsl_multilarge_nlinear_fdf system{};
  system.f = residuals;
  system.df = large_products;
  system.n = rows;
  system.p = start->size;
  system.params = &callbacks;
  if (!work || gsl_multilarge_nlinear_init(start, &system, work.get()) != GSL_SUCCESS) return 0;
  return iterate(
      options, [&] { return gsl_multilarge_nlinear_iterate(work.get()); },
      [&] { return length(work->f); });
}

}  // namespace

int trust_region(Objective& objective, SearchPoint& point, SearchPoint& scratch,
                 const TrustRegionOptions& options) {
  const std::span<const std::size_t> free = objective.free();
  const std::size_t rows = point.residuals.size();
  if (free.empty() || rows < free.size()) return 0;
  std::vector<double> start;
  for (const std::size_t c : free) start.push_back(point.z[c]);
  const gsl_vector_const_view view = gsl_vector_const_view_array(start.data(), start.size());
  Callbacks callbacks(objective, point, scratch);
  return rows * free.size() > kManyEntries ? large(callbacks, rows, &view.vector, options)
                                           : small(callbacks, rows, &view.vector, options);
}

}  // namespace slipbench::driver::fit
