#pragma once
// What is kept of a running simulation: frames, contacts, rows of the series.

#include "io/results_file.hpp"
#include "io/scene.hpp"
#include "osculate/dynamics/simulation.hpp"

namespace osculate::app {

io::ResultsHead head_of(const io::Scene& scene, const Simulation& simulation);
io::ParticleFrame frame_of(const io::Scene& scene, const Simulation& simulation);
io::ContactFrame contacts_of(const Simulation& simulation);

/// Names of the columns of the series, and one row of them.
std::vector<std::string> series_names(const io::Scene& scene);
std::vector<double> series_row(const io::Scene& scene, const Simulation& simulation);

}  // namespace osculate::app
