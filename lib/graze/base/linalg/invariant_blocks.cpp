#include "graze/base/linalg/detail/invariant_blocks.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <optional>
#include <utility>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/base/linalg/detail/products.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

// A diagonal block of the Schur form: one row, or two for a conjugate pair.
struct ResolventCell {
  Eigen::Index first = 0, size = 1;
  std::size_t cluster = 0;
};

std::vector<ResolventCell> cells_of(const Matrix& schur) {
  std::vector<ResolventCell> cells;
  for (Eigen::Index i = 0; i < schur.rows();) {
    const Eigen::Index size = i + 1 < schur.rows() && schur(i + 1, i) != 0.0 ? 2 : 1;
    cells.push_back({i, size, cells.size()});
    i += size;
  }
  return cells;
}

// Y of a Y - Y b = c, not finite where a and b share an eigenvalue; at most two rows and columns.
Matrix sylvester(const Matrix& a, const Matrix& b, const Matrix& c) {
  const Eigen::Index rows = a.rows(), columns = b.rows();
  Matrix whole = Matrix::Zero(rows * columns, rows * columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    whole.block(j * rows, j * rows, rows, rows) += a;
    for (Eigen::Index k = 0; k < columns; ++k)
      whole.block(j * rows, k * rows, rows, rows).diagonal().array() -= b(k, j);
  }
  const Vector right = Eigen::Map<const Vector>(c.data(), c.size());
  const Vector y = LuFactors(whole).solve(right);
  return Eigen::Map<const Matrix>(y.data(), rows, columns);
}

class Decoupling {
 public:
  explicit Decoupling(const Matrix& schur) : schur_(schur), cells_(cells_of(schur)) {}

  // Each failure joins two clusters, so it ends. False where its time is over before.
  bool run(double largest) {
    while (const auto pair = inseparable(largest)) {
      const std::size_t from = std::max(pair->first, pair->second);
      const std::size_t to = std::min(pair->first, pair->second);
      for (ResolventCell& cell : cells_)
        if (cell.cluster == from) cell.cluster = to;
    }
    return !StopScope::is_over();
  }

  const Matrix& transformation() const { return y_; }
  const Matrix& diagonal() const { return d_; }
  // The rows of every cluster, ascending.
  std::vector<std::vector<Eigen::Index>> clusters() const {
    std::vector<std::vector<Eigen::Index>> list(cells_.size());
    for (const ResolventCell& cell : cells_)
      for (Eigen::Index i = 0; i < cell.size; ++i) list[cell.cluster].push_back(cell.first + i);
    std::erase_if(list, [](const auto& rows) { return rows.empty(); });
    return list;
  }

 private:
  static Matrix part(const Matrix& of, const ResolventCell& row, const ResolventCell& column) {
    return of.block(row.first, column.first, row.size, column.size);
  }

  // Solves T Y = Y D column by column, upwards: within a cluster Y stays the identity and D takes
  // what is left. Returns the first two clusters that it cannot part.
  std::optional<std::pair<std::size_t, std::size_t>> inseparable(double largest) {
    const Eigen::Index n = schur_.rows();
    y_ = Matrix::Identity(n, n);
    d_ = Matrix::Zero(n, n);
    for (std::size_t j = 0; j < cells_.size() && !StopScope::is_over(); ++j) {
      const ResolventCell& column = cells_[j];
      d_.block(column.first, column.first, column.size, column.size) = part(schur_, column, column);
      for (std::size_t i = j; i-- > 0;) {
        const ResolventCell& row = cells_[i];
        const Eigen::Index below = row.first + row.size;
        const Eigen::Index count = column.first + column.size - below;
        Matrix left = product<double>(schur_.block(row.first, below, row.size, count),
                                      y_.block(below, column.first, count, column.size));
        left -= product<double>(y_.block(row.first, below, row.size, count),
                                d_.block(below, column.first, count, column.size));
        if (row.cluster == column.cluster) {
          d_.block(row.first, column.first, row.size, column.size) = left;
          continue;
        }
        const Matrix y = sylvester(part(schur_, row, row), part(schur_, column, column), -left);
        if (!(y.cwiseAbs().maxCoeff() <= largest)) return std::pair{row.cluster, column.cluster};
        y_.block(row.first, column.first, row.size, column.size) = y;
      }
    }
    return {};
  }

  const Matrix& schur_;
  std::vector<ResolventCell> cells_;
  Matrix y_, d_;
};

}  // namespace

std::vector<InvariantBlock> invariant_blocks(const Matrix& matrix, double largest) {
  const Eigen::Index n = matrix.rows();
  const std::vector<InvariantBlock> whole{{matrix, Matrix::Identity(n, n), Matrix::Identity(n, n)}};
  if (StopScope::is_over()) return whole;
  const Eigen::RealSchur<Matrix> schur(matrix);
  if (schur.info() != Eigen::Success) return whole;
  Decoupling decoupling(schur.matrixT());
  if (!decoupling.run(largest)) return whole;
  const Matrix basis = product<double>(schur.matrixU(), decoupling.transformation());
  const Matrix coordinates = decoupling.transformation().triangularView<Eigen::UnitUpper>().solve(
      Matrix(schur.matrixU().transpose()));
  std::vector<InvariantBlock> blocks;
  for (const std::vector<Eigen::Index>& rows : decoupling.clusters())
    blocks.push_back({decoupling.diagonal()(rows, rows), basis(Eigen::all, rows),
                      coordinates(rows, Eigen::all)});
  return blocks;
}

}  // namespace graze
