#include "io/plot_numbers.hpp"

#include <hdf5.h>

#include <catch2/catch.hpp>
#include <vector>

using namespace osculate;

namespace {

const io::NamedPlot named{.name = "fig1",
                          .caption = "Überlappung δ",
                          .plot = {.title = "A plot",
                                   .panels = {{.title = "first, \"quoted\"",
                                               .x = {.label = "x [m]"},
                                               .y = {.label = "y [N]"},
                                               .curves = {{.name = "one", .x = {0.1, 1.0 / 3.0}, .y = {-2.5e-300, 7.0}},
                                                          {.name = "two", .x = {1.0}, .y = {2.0}}}}}}};

std::vector<double> numbers(hid_t file, const char* path) {
  const hid_t data = H5Dopen2(file, path, H5P_DEFAULT);
  const hid_t space = H5Dget_space(data);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(data);
  return values;
}

std::string text(hid_t file, const char* object, const char* name) {
  const hid_t attribute = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  std::string value(H5Tget_size(type), '\0');
  H5Aread(attribute, type, value.data());
  H5Tclose(type);
  H5Aclose(attribute);
  return value;
}

}  // namespace

TEST_CASE("A plot's CSV has every point with all digits, and quotes what needs it") {
  CHECK(io::csv_of(named.plot) ==
        "panel,curve,along_x,along_y,x,y\n"
        "\"first, \"\"quoted\"\"\",\"one\",\"x [m]\",\"y [N]\",0.10000000000000001,-2.5e-300\n"
        "\"first, \"\"quoted\"\"\",\"one\",\"x [m]\",\"y [N]\",0.33333333333333331,7\n"
        "\"first, \"\"quoted\"\"\",\"two\",\"x [m]\",\"y [N]\",1,2\n");
}

TEST_CASE("The HDF5 library reads back every number and text of a plot") {
  std::string image = io::hdf5_of({&named, 1});
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, 1U << 16U, 0);
  H5Pset_file_image(access, image.data(), image.size());
  const hid_t file = H5Fopen("read back", H5F_ACC_RDONLY, access);
  REQUIRE(file >= 0);
  CHECK(numbers(file, "/fig1/panel_1/curve_1/x") == named.plot.panels[0].curves[0].x);
  CHECK(numbers(file, "/fig1/panel_1/curve_1/y") == named.plot.panels[0].curves[0].y);
  CHECK(numbers(file, "/fig1/panel_1/curve_2/y") == named.plot.panels[0].curves[1].y);
  CHECK(text(file, "/fig1", "caption") == named.caption);
  CHECK(text(file, "/fig1/panel_1", "y") == "y [N]");
  CHECK(text(file, "/fig1/panel_1/curve_2", "name") == "two");
  H5Fclose(file);
  H5Pclose(access);
}
