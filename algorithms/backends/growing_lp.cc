#include "algorithms/backends/growing_lp.h"

#include <ClpSimplex.hpp>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "algorithms/backends/clp_deadline.h"

namespace mda {

class GrowingLp::Model : public ClpSimplex {};

GrowingLp::GrowingLp(int rows) : model_(std::make_unique<Model>()), rows_(rows) {
  model_->setLogLevel(0);
  model_->setPrimalTolerance(1e-9);
  model_->setDualTolerance(1e-9);
  model_->setPerturbation(100);  // off: duals are to be exact
  model_->scaling(0);            // off: coefficients are small whole numbers
  model_->resize(rows, 0);
  for (int r = 0; r < rows; ++r) model_->setRowBounds(r, -COIN_DBL_MAX, 1.0);
}

GrowingLp::~GrowingLp() = default;

void GrowingLp::add_column(double cost, std::span<const Entry> entries) {
  costs_.push_back(cost);
  for (const Entry& entry : entries) {
    at_.push_back(entry.at);
    coefficients_.push_back(entry.coefficient);
  }
  begins_.push_back(static_cast<int>(at_.size()));
  ++columns_;
}

void GrowingLp::flush() {
  if (costs_.empty()) return;
  model_->addColumns(static_cast<int>(costs_.size()), nullptr, nullptr, costs_.data(),
                     begins_.data(), at_.data(), coefficients_.data());
  costs_.clear();
  begins_.resize(1);
  at_.clear();
  coefficients_.clear();
}

void GrowingLp::add_row(double right_hand_side, std::span<const Entry> entries) {
  flush();
  std::vector<int> columns;
  std::vector<double> coefficients;
  for (const Entry& entry : entries) {
    columns.push_back(entry.at);
    coefficients.push_back(entry.coefficient);
  }
  model_->addRow(static_cast<int>(columns.size()), columns.data(), coefficients.data(),
                 -COIN_DBL_MAX, right_hand_side);
  ++rows_;
}

void GrowingLp::remove_rows(std::span<const int> rows) {
  flush();
  model_->deleteRows(static_cast<int>(rows.size()), rows.data());
  rows_ -= static_cast<int>(rows.size());
}

void GrowingLp::remove_columns(std::span<const int> columns) {
  flush();
  model_->deleteColumns(static_cast<int>(columns.size()), columns.data());
  columns_ -= static_cast<int>(columns.size());
}

void GrowingLp::forbid(int column, bool forbidden) {
  flush();
  model_->setColumnUpper(column, forbidden ? 0.0 : COIN_DBL_MAX);
}

Outcome GrowingLp::solve(Method method, const Budget& budget) {
  flush();
  if (budget.expired()) return Outcome::kDeadline;
  bool stopped = false;
  const ClpDeadline handler(budget, stopped);
  model_->passInEventHandler(&handler);
  if (method == Method::kPrimal) {
    model_->primal();
  } else {
    model_->dual();
  }
  iterations_ += model_->numberIterations();
  if (stopped) return Outcome::kDeadline;
  if (!model_->isProvenOptimal()) model_->primal();
  if (stopped) return Outcome::kDeadline;
  if (!model_->isProvenOptimal()) {
    throw std::runtime_error("Clp gave up with status " + std::to_string(model_->status()));
  }
  value_ = model_->objectiveValue();
  return Outcome::kOptimal;
}

double GrowingLp::value_without(std::span<const int> columns, int most_steps,
                                const Budget& budget) {
  bool stopped = false;
  const ClpDeadline handler(budget, stopped);
  model_->passInEventHandler(&handler);
  const auto variables = static_cast<std::size_t>(rows_) + static_cast<std::size_t>(columns_);
  const std::vector<unsigned char> basis(model_->statusArray(), model_->statusArray() + variables);
  const int usual_steps = model_->maximumIterations();
  model_->setMaximumIterations(most_steps);
  for (const int j : columns) model_->setColumnUpper(j, 0.0);
  model_->dual();
  iterations_ += model_->numberIterations();
  const double value = model_->objectiveValue();
  for (const int j : columns) model_->setColumnUpper(j, COIN_DBL_MAX);
  model_->setMaximumIterations(usual_steps);
  std::ranges::copy(basis, model_->statusArray());
  return value;
}

std::span<const double> GrowingLp::x() const {
  return {model_->primalColumnSolution(), static_cast<std::size_t>(columns_)};
}

std::vector<double> GrowingLp::multipliers() const {
  const double* prices = model_->dualRowSolution();
  std::vector<double> multipliers(static_cast<std::size_t>(rows_));
  for (int r = 0; r < rows_; ++r)
    multipliers[static_cast<std::size_t>(r)] = std::max(0.0, -prices[r]);
  return multipliers;
}

bool GrowingLp::is_slack(int row) const { return model_->getRowStatus(row) == ClpSimplex::basic; }

}  // namespace mda
