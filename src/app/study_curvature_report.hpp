#pragma once
// The curvature study's results as tables for the terminal, columns for files, and a picture.

#include <string>
#include <vector>

#include "io/plot.hpp"
#include "validation/curvature_models/spread.hpp"

namespace osculate::app {

/// What the errors are against, in words.
struct CurvatureStudyTitle {
  std::string reference;
  int orientations;
};

std::string curvature_study_text(const std::vector<validation::curvature_models::CaseErrors>& errors,
                                 const CurvatureStudyTitle& title);

/// One column of all contacts.
struct StudyColumn {
  std::string name;
  std::string meaning;  ///< with the unit
  std::vector<double> values;
};
/// Every contact, one a row.
std::vector<StudyColumn> curvature_study_columns(const std::vector<validation::curvature_models::CaseErrors>& errors);

std::string csv_of(const std::vector<StudyColumn>& columns);
std::string json_of(const std::vector<StudyColumn>& columns);
std::string hdf5_of(const std::vector<StudyColumn>& columns, const CurvatureStudyTitle& title);

io::Plot curvature_study_plot(const std::vector<validation::curvature_models::CaseErrors>& errors,
                              const CurvatureStudyTitle& title);

}  // namespace osculate::app
