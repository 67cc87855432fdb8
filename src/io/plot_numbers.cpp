#include "io/plot_numbers.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <iterator>
#include <stdexcept>

namespace osculate::io {
namespace {

/// A text as one field: in quotes, quotes doubled.
std::string field(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

/// An HDF5 object, closed with its owner.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 refused to make a part of a file");
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { close_(id_); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t result) {
  if (result < 0) throw std::runtime_error("HDF5 could not write");
}

Handle group(hid_t parent, const std::string& name) {
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

void set_text(hid_t object, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, text.empty() ? 1 : text.size()));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, type, text.c_str()));
}

void set_numbers(hid_t parent, const char* name, const std::vector<double>& values) {
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle data(H5Dcreate2(parent, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  require(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

void write_plot(hid_t file, const NamedPlot& named) {
  const Handle of_plot = group(file, named.name);
  set_text(of_plot, "title", named.plot.title);
  set_text(of_plot, "caption", named.caption);
  for (std::size_t i = 0; i < named.plot.panels.size(); ++i) {
    const Panel& panel = named.plot.panels[i];
    const Handle of_panel = group(of_plot, fmt::format("panel_{}", i + 1));
    set_text(of_panel, "title", panel.title);
    set_text(of_panel, "x", panel.x.label);
    set_text(of_panel, "y", panel.y.label);
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
      const Handle of_curve = group(of_panel, fmt::format("curve_{}", k + 1));
      set_text(of_curve, "name", panel.curves[k].name);
      set_numbers(of_curve, "x", panel.curves[k].x);
      set_numbers(of_curve, "y", panel.curves[k].y);
    }
  }
}

}  // namespace

std::string csv_of(const Plot& plot) {
  std::string csv = "panel,curve,along_x,along_y,x,y\n";
  for (const auto& panel : plot.panels) {
    for (const auto& curve : panel.curves) {
      const std::string start =
          fmt::format("{},{},{},{}", field(panel.title), field(curve.name), field(panel.x.label), field(panel.y.label));
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        fmt::format_to(std::back_inserter(csv), "{},{:.17g},{:.17g}\n", start, curve.x[i], curve.y[i]);
    }
  }
  return csv;
}

std::string hdf5_of(std::span<const NamedPlot> plots) {
  // A file that never leaves memory, so that the caller writes it as it does all others.
  constexpr std::size_t grow_by = 1U << 20U;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(access, grow_by, 0));
  const Handle file(H5Fcreate("plots", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  for (const auto& plot : plots) write_plot(file, plot);
  require(H5Fflush(file, H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) throw std::runtime_error("HDF5 could not give its file");
  std::string image(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file, image.data(), image.size()) != size)
    throw std::runtime_error("HDF5 could not give its file");
  return image;
}

}  // namespace osculate::io
