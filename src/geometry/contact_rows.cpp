#include "geometry/contact_rows.hpp"

namespace osculate {

void set_row(ContactColumns& contacts, std::size_t i, const ContactGeometry& contact) {
  std::size_t k = 0;
  const auto put = [&](double value) { contacts.columns[k++][i] = value; };
  const auto put_vector = [&](const Vec3& v) {
    for (double value : v) put(value);
  };
  contacts.statuses[i] = contact.status;
  put_vector(contact.normal);
  put(contact.overlap);
  put_vector(contact.on_1);
  put_vector(contact.on_2);
  for (const PrincipalCurvatures& curvature : {contact.curvature_1, contact.curvature_2}) {
    put(curvature.max);
    put(curvature.min);
    put_vector(curvature.max_direction);
  }
  put(contact.relative.R_i);
  put(contact.relative.R_j);
  put_vector(contact.relative.major_axis);
}

}  // namespace osculate
