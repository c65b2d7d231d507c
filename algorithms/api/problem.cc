#include "algorithms/api/problem.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <stdexcept>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument(what); }

/// Root of `i` in a union-find forest, halving the path on the way.
int find_root(std::vector<int>& parent, int i) {
  while (parent[index(i)] != i) {
    parent[index(i)] = parent[index(parent[index(i)])];
    i = parent[index(i)];
  }
  return i;
}

/// A 64-bit mixing step (multiply, rotate, multiply): order matters, every bit counts.
std::uint64_t mix(std::uint64_t hash, std::uint64_t value) noexcept {
  hash ^= value * 0x9E3779B97F4A7C15ULL;
  hash = (hash << 27) | (hash >> 37);
  return hash * 0xD6E8FEB86659FD93ULL + 1;
}

}  // namespace

std::string AssociationProblem::fingerprint() const {
  std::uint64_t hash = mix(index(rows()), index(columns()));
  for (int r = 0; r < rows(); ++r) {
    hash = mix(hash, (index(dimension(r)) << 1) | static_cast<std::uint64_t>(use(r)));
  }
  for (const int begin : column_begins_) hash = mix(hash, index(begin));
  for (const int row : row_indices_) hash = mix(hash, index(row));
  constexpr double kUnitsPerNat = 1 << 20;
  for (const double c : costs_) {
    hash = mix(hash, static_cast<std::uint64_t>(std::llround(c * kUnitsPerNat)));
  }
  hash ^= hash >> 32;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

void ProblemBuilder::clear() {
  row_use_.clear();
  row_dimension_.clear();
  costs_.clear();
  column_begins_.resize(1);
  row_indices_.clear();
  dimensions_ = -1;
}

int ProblemBuilder::add_row(int dimension, RowUse use) {
  row_dimension_.push_back(dimension);
  row_use_.push_back(use);
  return rows() - 1;
}

int ProblemBuilder::add_column(double cost, std::span<const int> rows) {
  costs_.push_back(cost);
  row_indices_.insert(row_indices_.end(), rows.begin(), rows.end());
  std::sort(row_indices_.end() - std::ssize(rows), row_indices_.end());
  column_begins_.push_back(static_cast<int>(row_indices_.size()));
  return columns() - 1;
}

namespace {

void check_rows(const AssociationProblem& p) {
  for (int r = 0; r < p.rows(); ++r) {
    if (p.dimension(r) < 0) refuse("row " + std::to_string(r) + ": its dimension is negative");
  }
}

void check_column(const AssociationProblem& p, int j) {
  const std::string where = "column " + std::to_string(j) + ": ";
  if (!std::isfinite(p.cost(j))) refuse(where + "its cost is not a finite number");
  if (std::abs(p.cost(j)) > 1e12) refuse(where + "its cost is beyond 1e12 nats");
  const auto rows = p.rows_of(j);
  if (rows.empty()) refuse(where + "it uses no row");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] < 0 || rows[i] >= p.rows()) {
      refuse(where + "it uses row " + std::to_string(rows[i]) + ", but there are rows 0 to " +
             std::to_string(p.rows() - 1));
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (p.dimension(rows[k]) == p.dimension(rows[i])) {
        refuse(where + "it uses two rows of dimension " + std::to_string(p.dimension(rows[i])));
      }
    }
  }
}

int count_dimensions(std::vector<int> dimensions) {
  std::sort(dimensions.begin(), dimensions.end());
  return static_cast<int>(std::unique(dimensions.begin(), dimensions.end()) - dimensions.begin());
}

/// Numbers the components of the row-column graph in the order of their first column.
std::vector<int> number_components(const AssociationProblem& p, Shape& shape) {
  std::vector<int> parent(index(p.rows()));
  std::iota(parent.begin(), parent.end(), 0);
  for (int j = 0; j < p.columns(); ++j) {
    const auto rows = p.rows_of(j);
    const int root = find_root(parent, rows[0]);
    for (const int r : rows.subspan(1)) parent[index(find_root(parent, r))] = root;
  }
  std::vector<int> number(index(p.rows()), -1);
  std::vector<int> component(index(p.columns()));
  std::vector<int> size;
  for (int j = 0; j < p.columns(); ++j) {
    int& c = number[index(find_root(parent, p.rows_of(j)[0]))];
    if (c < 0) {
      c = static_cast<int>(size.size());
      size.push_back(0);
    }
    ++size[index(c)];
    component[index(j)] = c;
  }
  shape.components = static_cast<int>(size.size());
  shape.largest_component_columns = size.empty() ? 0 : *std::max_element(size.begin(), size.end());
  return component;
}

void describe_rows(const AssociationProblem& p, Shape& shape) {
  std::vector<char> alone(index(p.rows()), 0);
  for (int j = 0; j < p.columns(); ++j) {
    const auto rows = p.rows_of(j);
    if (rows.size() == 1) alone[index(rows[0])] = 1;
    shape.known_tracks = shape.known_tracks && std::any_of(rows.begin(), rows.end(), [&](int r) {
                           return p.dimension(r) == 0;
                         });
  }
  for (int r = 0; r < p.rows(); ++r) {
    if (p.use(r) != RowUse::kExactlyOnce) continue;
    shape.has_exactly_once_rows = true;
    shape.always_feasible = shape.always_feasible && alone[index(r)] != 0;
  }
}

/// Shape::is_axial. O(nonzeros + rows log dimensions).
bool is_axial(const AssociationProblem& p) {
  std::map<int, std::vector<int>> rows_of_dimension;
  for (int r = 0; r < p.rows(); ++r) {
    if (p.use(r) != RowUse::kExactlyOnce) return false;
    rows_of_dimension[p.dimension(r)].push_back(r);
  }
  if (rows_of_dimension.size() < 2) return false;
  const std::size_t size = rows_of_dimension.begin()->second.size();
  const auto columns = index(p.columns());
  std::size_t combinations = 1;
  std::vector<std::size_t> weight(index(p.rows()));  // they sum to the number of a combination
  for (const auto& [dimension, rows] : rows_of_dimension) {
    if (rows.size() != size || combinations > columns) return false;
    for (std::size_t i = 0; i < size; ++i) weight[index(rows[i])] = i * combinations;
    combinations *= size;
  }
  if (combinations != columns) return false;
  std::vector<char> seen(columns, 0);
  for (int j = 0; j < p.columns(); ++j) {
    const auto rows = p.rows_of(j);
    if (rows.size() != rows_of_dimension.size()) return false;
    std::size_t combination = 0;
    for (const int r : rows) combination += weight[index(r)];
    if (seen[combination] != 0) return false;
    seen[combination] = 1;
  }
  return true;
}

}  // namespace

AssociationProblem ProblemBuilder::build() const {
  AssociationProblem p;
  p.row_use_ = row_use_;
  p.row_dimension_ = row_dimension_;
  p.costs_ = costs_;
  p.column_begins_ = column_begins_;
  p.row_indices_ = row_indices_;
  check_rows(p);
  for (int j = 0; j < p.columns(); ++j) check_column(p, j);
  p.shape_.rows = p.rows();
  p.shape_.columns = p.columns();
  p.shape_.nonzeros = p.nonzeros();
  p.shape_.dimensions = dimensions_ >= 0 ? dimensions_ : count_dimensions(row_dimension_);
  p.component_ = number_components(p, p.shape_);
  describe_rows(p, p.shape_);
  p.shape_.is_axial = is_axial(p);
  return p;
}

std::vector<double> coasting_costs(const AssociationProblem& problem) {
  std::vector<double> coasting(index(problem.rows()), 0.0);
  for (int j = 0; j < problem.columns(); ++j) {
    const auto rows = problem.rows_of(j);
    if (rows.size() != 1 || problem.dimension(rows[0]) != 0) continue;
    double& least = coasting[index(rows[0])];
    least = std::min(least, problem.cost(j));
  }
  return coasting;
}

}  // namespace mda
