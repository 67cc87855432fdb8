#pragma once
// Contacts one by one into columns.

#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate {

void set_row(ContactColumns& contacts, std::size_t i, const ContactGeometry& contact);

}  // namespace osculate
