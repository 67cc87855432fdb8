! Sizes of the module's types in bytes, in the order of the test's list.
subroutine osculate_test_sizes(sizes) bind(C)
  use, intrinsic :: iso_c_binding
  use osculate
  implicit none
  integer(c_size_t), intent(out) :: sizes(10)
  type(osculate_pose) :: pose
  type(osculate_contact) :: contact
  type(osculate_bodies) :: bodies
  type(osculate_contact_columns) :: contact_columns
  type(osculate_material) :: material
  type(osculate_law_setting) :: law_setting
  type(osculate_approach) :: approach
  type(osculate_force) :: force
  type(osculate_approach_columns) :: approach_columns
  type(osculate_force_columns) :: force_columns
  sizes = [c_sizeof(pose), c_sizeof(contact), c_sizeof(bodies), c_sizeof(contact_columns), c_sizeof(material), &
    c_sizeof(law_setting), c_sizeof(approach), c_sizeof(force), c_sizeof(approach_columns), &
    c_sizeof(force_columns)]
end subroutine
