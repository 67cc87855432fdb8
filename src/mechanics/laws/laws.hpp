#pragma once
// The registry's lines: one a law. A new law is its own file, a line here and in law_registry.cpp, and its test.

#include "mechanics/laws/law_part.hpp"

namespace osculate::laws {

extern const Law hertz, hertz_sphere;
extern const Law brilliantov, tsuji;
extern const Law mindlin;
extern const Law cundall_strack, di_renzo, tsuji_tangential;

}  // namespace osculate::laws
