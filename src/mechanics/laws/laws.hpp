#pragma once
// Every law of the registry; law_registry.cpp lists them.

#include "mechanics/laws/law_part.hpp"

namespace osculate::laws {

extern const Law hertz, hertz_sphere, linear, walton_braun;
extern const Law jkr, dmt;
extern const Law greenwood_williamson;
extern const Law jamari_schipper;
extern const Law brilliantov, tsuji, kuwabara_kono, linear_dashpot, dashpot;
extern const Law mindlin, cundall_strack, di_renzo, tsuji_tangential, langston, zheng, walton_braun_friction, sliding,
    viscous_friction, viscous_sliding;
extern const Law twisting;
extern const Law vermeulen_johnson, kalker;

}  // namespace osculate::laws
