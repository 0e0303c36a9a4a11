#include "graze/fem/detail/sparse_cholesky.hpp"

#include <suitesparse/cholmod.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

namespace graze {
namespace {

// A view of the upper triangle; the lower one is ignored. A matrix may have unused space between
// its columns.
cholmod_sparse view(const SparseMatrix& matrix) {
  cholmod_sparse seen{};
  seen.nrow = seen.ncol = static_cast<std::size_t>(matrix.rows());
  seen.nzmax = static_cast<std::size_t>(matrix.data().allocatedSize());
  seen.nz = const_cast<int*>(matrix.innerNonZeroPtr());
  seen.p = const_cast<int*>(matrix.outerIndexPtr());
  seen.i = const_cast<int*>(matrix.innerIndexPtr());
  seen.x = const_cast<double*>(matrix.valuePtr());
  seen.stype = 1;
  seen.itype = CHOLMOD_INT;
  seen.xtype = CHOLMOD_REAL;
  seen.dtype = CHOLMOD_DOUBLE;
  seen.sorted = 1;
  seen.packed = matrix.isCompressed() ? 1 : 0;
  return seen;
}

cholmod_dense view(const double* values, std::size_t rows, std::size_t columns) {
  cholmod_dense seen{};
  seen.nrow = seen.d = rows;
  seen.ncol = columns;
  seen.nzmax = rows * columns;
  seen.x = const_cast<double*>(values);
  seen.xtype = CHOLMOD_REAL;
  seen.dtype = CHOLMOD_DOUBLE;
  return seen;
}

}  // namespace

struct SparseCholesky::Factors {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  Vector diagonal;  // of the matrix that was factorised
  double operations = 0.0, entries = 0.0;
  // Work space of the solutions, kept from one to the next.
  cholmod_dense *solution = nullptr, *first = nullptr, *second = nullptr;

  Factors() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_AUTO;
    common.final_ll = 1;
    common.quick_return_if_not_posdef = 1;
  }
  ~Factors() {
    for (cholmod_dense** dense : {&solution, &first, &second}) cholmod_free_dense(dense, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  void check_memory() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
      throw std::bad_alloc();
  }
};

SparseCholesky::SparseCholesky(const SparseMatrix& pattern) : factors_(new Factors) {
  cholmod_sparse seen = view(pattern);
  factors_->factor = cholmod_analyze(&seen, &factors_->common);
  factors_->check_memory();
  factors_->operations = factors_->common.fl;
  factors_->entries = factors_->common.lnz;
}

SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::factorise(const SparseMatrix& matrix) {
  cholmod_sparse seen = view(matrix);
  factors_->diagonal = matrix.diagonal();
  cholmod_factorize(&seen, factors_->factor, &factors_->common);
  factors_->check_memory();
  return factors_->common.status == CHOLMOD_OK;
}

int SparseCholesky::failed_row() const {
  const cholmod_factor& factor = *factors_->factor;
  return factor.minor < factor.n ? static_cast<const int*>(factor.Perm)[factor.minor] : -1;
}

SparseCholesky::Pivot SparseCholesky::smallest_pivot() const {
  const cholmod_factor& factor = *factors_->factor;
  const auto* order = static_cast<const int*>(factor.Perm);
  const auto* values = static_cast<const double*>(factor.x);
  Pivot smallest{std::numeric_limits<double>::infinity(), -1};
  const auto take = [&](std::size_t column, double root) {
    const double relative = root * root / factors_->diagonal[order[column]];
    if (relative < smallest.relative) smallest = {relative, order[column]};
  };
  if (!factor.is_super) {
    const auto* starts = static_cast<const int*>(factor.p);
    for (std::size_t j = 0; j < factor.n; ++j) take(j, values[starts[j]]);
    return smallest;
  }
  const auto* super = static_cast<const int*>(factor.super);
  const auto* rows = static_cast<const int*>(factor.pi);
  const auto* starts = static_cast<const int*>(factor.px);
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const int height = rows[s + 1] - rows[s];
    for (int j = super[s]; j < super[s + 1]; ++j) {
      const int k = j - super[s];
      take(static_cast<std::size_t>(j), values[starts[s] + k * height + k]);
    }
  }
  return smallest;
}

void SparseCholesky::solve(const double* right, double* result) const {
  const auto rows = static_cast<std::size_t>(factors_->factor->n);
  cholmod_dense seen = view(right, rows, 1);
  cholmod_solve2(CHOLMOD_A, factors_->factor, &seen, nullptr, &factors_->solution, nullptr,
                 &factors_->first, &factors_->second, &factors_->common);
  factors_->check_memory();
  std::copy_n(static_cast<const double*>(factors_->solution->x), rows, result);
}

Matrix SparseCholesky::solve(const Matrix& right) const {
  Matrix result(right.rows(), right.cols());
  for (Eigen::Index j = 0; j < right.cols(); ++j)
    solve(right.data() + j * right.rows(), result.data() + j * right.rows());
  return result;
}

double SparseCholesky::operations() const { return factors_->operations; }
double SparseCholesky::entries() const { return factors_->entries; }

std::optional<int> SparseCholesky::negative_eigenvalues(const SparseMatrix& matrix) {
  cholmod_common& common = factors_->common;
  cholmod_sparse seen = view(matrix);
  // The known order, for factors L D L^T.
  const auto* order = static_cast<const int*>(factors_->factor->Perm);
  std::vector<int> kept(order, order + factors_->factor->n);
  const int supernodal = common.supernodal, final_ll = common.final_ll, methods = common.nmethods;
  const int ordering = common.method[0].ordering;
  common.supernodal = CHOLMOD_SIMPLICIAL;
  common.final_ll = 0;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  cholmod_factor* factor = cholmod_analyze_p(&seen, kept.data(), nullptr, 0, &common);
  if (factor) cholmod_factorize(&seen, factor, &common);
  std::optional<int> count;
  if (factor && common.status == CHOLMOD_OK) {
    const auto* starts = static_cast<const int*>(factor->p);
    const auto* values = static_cast<const double*>(factor->x);
    count = 0;
    for (std::size_t j = 0; j < factor->n; ++j) *count += values[starts[j]] < 0.0;
    const Vector probe = Vector::LinSpaced(matrix.rows(), 1.0, 2.0);
    const Vector right = matrix * probe;
    cholmod_dense seen_right = view(right.data(), factor->n, 1);
    cholmod_dense* found = cholmod_solve(CHOLMOD_A, factor, &seen_right, &common);
    const Eigen::Map<const Vector> solution(static_cast<const double*>(found->x), matrix.rows());
    const double scale = (matrix.cwiseAbs() * solution.cwiseAbs() + right.cwiseAbs()).norm();
    if (!((matrix * solution - right).norm() <= kInertiaResidual * scale)) count.reset();
    cholmod_free_dense(&found, &common);
  }
  cholmod_free_factor(&factor, &common);
  const bool lacks_memory = common.status == CHOLMOD_OUT_OF_MEMORY;
  common.supernodal = supernodal;
  common.final_ll = final_ll;
  common.nmethods = methods;
  common.method[0].ordering = ordering;
  if (lacks_memory) count.reset();
  return count;
}

}  // namespace graze
