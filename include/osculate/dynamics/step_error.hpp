#pragma once
// Trouble during a run: the state is no longer one that mechanics could have led to.

#include <stdexcept>
#include <string>

namespace osculate {

/// `what()` reads "step <n>, t = <t> s: <what happened, to which bodies>".
class StepError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace osculate
