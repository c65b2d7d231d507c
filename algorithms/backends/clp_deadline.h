// Stops Clp at the deadline of a Budget. Only for the sources of this folder: it shows Clp's
// headers.
#pragma once

#include <ClpEventHandler.hpp>

#include "algorithms/api/associator.h"

namespace mda {

/// Stops the simplex method at a point of wall time; Clp's own limit counts the CPU time of the
/// whole process, so it would depend on the other threads. Clp works on a copy, hence the reference
/// to the flag; budget and flag must outlive the model.
class ClpDeadline : public ClpEventHandler {
 public:
  ClpDeadline(const Budget& budget, bool& stopped) : budget_(&budget), stopped_(&stopped) {}

  int event(Event which) override {
    constexpr int kGoOn = -1;
    constexpr int kStop = 0;
    if (which != endOfIteration || !budget_->expired()) return kGoOn;
    *stopped_ = true;
    return kStop;
  }

  [[nodiscard]] ClpEventHandler* clone() const override { return new ClpDeadline(*this); }

 private:
  const Budget* budget_;
  bool* stopped_;
};

}  // namespace mda
