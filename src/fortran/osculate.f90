! Osculate from Fortran: the C API of osculate/osculate.h, which describes every function, unit and frame. Names are
! those of C. Handles are type(c_ptr). Columns are contiguous arrays with the target attribute, given by c_loc.
! Bodies are counted from 0 as in C: declare their columns (0:n-1), or subtract 1 from the indices of pairs.
module osculate
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_int, c_int32_t, c_loc, c_null_char, &
    c_null_ptr, c_ptr, c_size_t
  implicit none
  private :: c_char, c_double, c_f_pointer, c_int, c_int32_t, c_loc, c_null_char, c_null_ptr, c_ptr, c_size_t
  private :: c_error_message, c_version, c_strlen, text_at, terminated

  ! OSCULATE_ABI_VERSION of the header; the library's own is osculate_abi_version().
  integer(c_int), parameter :: OSCULATE_MODULE_ABI_VERSION = 1

  ! What functions return.
  integer(c_int), parameter :: OSCULATE_OK = 0
  integer(c_int), parameter :: OSCULATE_NULL_POINTER = 1
  integer(c_int), parameter :: OSCULATE_INVALID_INPUT = 2
  integer(c_int), parameter :: OSCULATE_OUT_OF_MEMORY = 3
  integer(c_int), parameter :: OSCULATE_INTERNAL_ERROR = 4

  ! Side of a cylinder that is solid.
  integer(c_int), parameter :: OSCULATE_SOLID_INSIDE = 0
  integer(c_int), parameter :: OSCULATE_SOLID_OUTSIDE = 1

  ! Status of a contact.
  integer(c_int32_t), parameter :: OSCULATE_TOUCHING = 0
  integer(c_int32_t), parameter :: OSCULATE_SEPARATED = 1
  integer(c_int32_t), parameter :: OSCULATE_AMBIGUOUS = 2
  integer(c_int32_t), parameter :: OSCULATE_FLAT = 3
  integer(c_int32_t), parameter :: OSCULATE_NOT_CONVERGED = 4
  integer(c_int32_t), parameter :: OSCULATE_DEGENERATE = 5

  ! How far to go when bodies do not touch.
  integer(c_int), parameter :: OSCULATE_GAP_RESOLVE = 0
  integer(c_int), parameter :: OSCULATE_GAP_SKIP = 1

  ! What a law needs and makes: bits of osculate_law_needs.
  integer(c_int), parameter :: OSCULATE_NEEDS_ANGULAR_VELOCITY = 1
  integer(c_int), parameter :: OSCULATE_NEEDS_MEAN_ANGULAR_VELOCITY = 2
  integer(c_int), parameter :: OSCULATE_NEEDS_REDUCED_MASS = 4
  integer(c_int), parameter :: OSCULATE_NEEDS_EFFECTIVE_RADIUS = 8
  integer(c_int), parameter :: OSCULATE_MAKES_COUPLES = 16

  ! Status of a force.
  integer(c_int32_t), parameter :: OSCULATE_OPEN = 0
  integer(c_int32_t), parameter :: OSCULATE_CLOSED = 1
  integer(c_int32_t), parameter :: OSCULATE_LARGE_CONTACT = 2
  integer(c_int32_t), parameter :: OSCULATE_LAW_NOT_CONVERGED = 3
  integer(c_int32_t), parameter :: OSCULATE_BAD_NUMBER = 4

  type, bind(C) :: osculate_pose
    real(c_double) :: position(3) = 0.0_c_double
    real(c_double) :: orientation(4) = [1.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double]
  end type

  type, bind(C) :: osculate_contact
    integer(c_int32_t) :: status
    real(c_double) :: normal(3)
    real(c_double) :: overlap
    real(c_double) :: on_1(3)
    real(c_double) :: on_2(3)
    real(c_double) :: curvature_1(2)
    real(c_double) :: direction_1(3)
    real(c_double) :: curvature_2(2)
    real(c_double) :: direction_2(3)
    real(c_double) :: R_i
    real(c_double) :: R_j
    real(c_double) :: major_axis(3)
  end type

  type, bind(C) :: osculate_bodies
    integer(c_size_t) :: size = 0
    type(c_ptr) :: shape = c_null_ptr
    type(c_ptr) :: position(3) = c_null_ptr
    type(c_ptr) :: orientation(4) = c_null_ptr
  end type

  type, bind(C) :: osculate_contact_columns
    type(c_ptr) :: status = c_null_ptr
    type(c_ptr) :: normal(3) = c_null_ptr
    type(c_ptr) :: overlap = c_null_ptr
    type(c_ptr) :: on_1(3) = c_null_ptr
    type(c_ptr) :: on_2(3) = c_null_ptr
    type(c_ptr) :: curvature_1(2) = c_null_ptr
    type(c_ptr) :: direction_1(3) = c_null_ptr
    type(c_ptr) :: curvature_2(2) = c_null_ptr
    type(c_ptr) :: direction_2(3) = c_null_ptr
    type(c_ptr) :: R_i = c_null_ptr
    type(c_ptr) :: R_j = c_null_ptr
    type(c_ptr) :: major_axis(3) = c_null_ptr
  end type

  type, bind(C) :: osculate_material
    real(c_double) :: youngs_modulus
    real(c_double) :: poissons_ratio
  end type

  type, bind(C) :: osculate_law_setting
    type(c_ptr) :: law = c_null_ptr
    type(c_ptr) :: parameter = c_null_ptr
    real(c_double) :: value = 0.0_c_double
  end type

  type, bind(C) :: osculate_approach
    real(c_double) :: R_i
    real(c_double) :: R_j
    real(c_double) :: overlap
    real(c_double) :: normal(3)
    real(c_double) :: major_axis(3)
    real(c_double) :: velocity(3)
    real(c_double) :: angular_velocity(3) = 0.0_c_double
    real(c_double) :: mean_angular_velocity(3) = 0.0_c_double
    real(c_double) :: reduced_mass = 0.0_c_double
    real(c_double) :: effective_radius = 0.0_c_double
    real(c_double) :: smallest_radius = 0.0_c_double
    real(c_double) :: time_step
  end type

  type, bind(C) :: osculate_force
    integer(c_int32_t) :: status
    real(c_double) :: force(3)
    real(c_double) :: couple(3)
    real(c_double) :: normal_force
    real(c_double) :: a_c
    real(c_double) :: axis_ratio
    real(c_double) :: stiffness
    real(c_double) :: stored_normal
    real(c_double) :: stored_tangential
    real(c_double) :: viscous_loss
    real(c_double) :: friction_loss
    real(c_double) :: hysteresis_loss
  end type

  type, bind(C) :: osculate_approach_columns
    integer(c_size_t) :: size = 0
    type(c_ptr) :: R_i = c_null_ptr
    type(c_ptr) :: R_j = c_null_ptr
    type(c_ptr) :: overlap = c_null_ptr
    type(c_ptr) :: normal(3) = c_null_ptr
    type(c_ptr) :: major_axis(3) = c_null_ptr
    type(c_ptr) :: velocity(3) = c_null_ptr
    type(c_ptr) :: angular_velocity(3) = c_null_ptr
    type(c_ptr) :: mean_angular_velocity(3) = c_null_ptr
    type(c_ptr) :: reduced_mass = c_null_ptr
    type(c_ptr) :: effective_radius = c_null_ptr
    type(c_ptr) :: smallest_radius = c_null_ptr
    real(c_double) :: time_step = 0.0_c_double
  end type

  type, bind(C) :: osculate_force_columns
    type(c_ptr) :: status = c_null_ptr
    type(c_ptr) :: force(3) = c_null_ptr
    type(c_ptr) :: couple(3) = c_null_ptr
    type(c_ptr) :: normal_force = c_null_ptr
    type(c_ptr) :: a_c = c_null_ptr
    type(c_ptr) :: axis_ratio = c_null_ptr
    type(c_ptr) :: stiffness = c_null_ptr
    type(c_ptr) :: stored_normal = c_null_ptr
    type(c_ptr) :: stored_tangential = c_null_ptr
    type(c_ptr) :: viscous_loss = c_null_ptr
    type(c_ptr) :: friction_loss = c_null_ptr
    type(c_ptr) :: hysteresis_loss = c_null_ptr
  end type

  ! A parameter of a law, or with `parameter` left blank the law alone: what osculate_compose_law takes.
  type :: osculate_setting
    character(len=64) :: law = ""
    character(len=64) :: parameter = ""
    real(c_double) :: value = 0.0_c_double
  end type

  interface
    function osculate_abi_version() bind(C) result(version)
      import :: c_int
      integer(c_int) :: version
    end function

    function c_version() bind(C, name="osculate_version") result(text)
      import :: c_ptr
      type(c_ptr) :: text
    end function

    function c_error_message() bind(C, name="osculate_error_message") result(text)
      import :: c_ptr
      type(c_ptr) :: text
    end function

    function c_strlen(text) bind(C, name="strlen") result(length)
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
      integer(c_size_t) :: length
    end function

    function osculate_new_sphere(radius, shape) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      real(c_double), value :: radius
      type(c_ptr), intent(inout) :: shape
      integer(c_int) :: error
    end function

    function osculate_new_ellipsoid(half_axes, shape) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: half_axes(3)
      type(c_ptr), intent(inout) :: shape
      integer(c_int) :: error
    end function

    function osculate_new_superquadric(half_axes, n1, n2, shape) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: half_axes(3)
      real(c_double), value :: n1, n2
      type(c_ptr), intent(inout) :: shape
      integer(c_int) :: error
    end function

    ! normals(3, planes)
    function osculate_new_potential_particle(planes, normals, distances, sphericity, edge_radius, sphere_radius, &
        shape) bind(C) result(error)
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: planes
      real(c_double), intent(in) :: normals(3, *), distances(*)
      real(c_double), value :: sphericity, edge_radius, sphere_radius
      type(c_ptr), intent(inout) :: shape
      integer(c_int) :: error
    end function

    function osculate_new_half_space(shape) bind(C) result(error)
      import :: c_int, c_ptr
      type(c_ptr), intent(inout) :: shape
      integer(c_int) :: error
    end function

    function osculate_new_cylinder(radius, solid, shape) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      real(c_double), value :: radius
      integer(c_int), value :: solid
      type(c_ptr), intent(inout) :: shape
      integer(c_int) :: error
    end function

    function osculate_new_sphere_container(radius, shape) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      real(c_double), value :: radius
      type(c_ptr), intent(inout) :: shape
      integer(c_int) :: error
    end function

    subroutine osculate_free_shape(shape) bind(C)
      import :: c_ptr
      type(c_ptr), value :: shape
    end subroutine

    function osculate_bounding_radius(shape, radius) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      type(c_ptr), value :: shape
      real(c_double), intent(out) :: radius
      integer(c_int) :: error
    end function

    function osculate_mass_properties(shape, volume, centroid, inertia) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      type(c_ptr), value :: shape
      real(c_double), intent(out) :: volume, centroid(3), inertia(3, 3)
      integer(c_int) :: error
    end function

    function osculate_cache_size() bind(C) result(bytes)
      import :: c_size_t
      integer(c_size_t) :: bytes
    end function

    ! cache: c_loc of osculate_cache_size() bytes, or c_null_ptr
    function osculate_find_contact(shape_1, pose_1, shape_2, pose_2, gap, cache, contact) bind(C) result(error)
      import :: c_int, c_ptr, osculate_contact, osculate_pose
      type(c_ptr), value :: shape_1, shape_2, cache
      type(osculate_pose), intent(in) :: pose_1, pose_2
      integer(c_int), value :: gap
      type(osculate_contact), intent(inout) :: contact
      integer(c_int) :: error
    end function

    function osculate_find_contacts(bodies, pairs, body_1, body_2, gap, caches, contacts) bind(C) result(error)
      import :: c_int, c_int32_t, c_ptr, c_size_t, osculate_bodies, osculate_contact_columns
      type(osculate_bodies), intent(in) :: bodies
      integer(c_size_t), value :: pairs
      integer(c_int32_t), intent(in) :: body_1(*), body_2(*)
      integer(c_int), value :: gap
      type(c_ptr), value :: caches
      type(osculate_contact_columns), intent(in) :: contacts
      integer(c_int) :: error
    end function

    ! osculate_compose_law takes Fortran strings.
    function osculate_new_law(count, settings, material_1, material_2, law) bind(C) result(error)
      import :: c_int, c_ptr, c_size_t, osculate_law_setting, osculate_material
      integer(c_size_t), value :: count
      type(osculate_law_setting), intent(in) :: settings(*)
      type(osculate_material), intent(in) :: material_1, material_2
      type(c_ptr), intent(inout) :: law
      integer(c_int) :: error
    end function

    subroutine osculate_free_law(law) bind(C)
      import :: c_ptr
      type(c_ptr), value :: law
    end subroutine

    function osculate_memory_size(law) bind(C) result(bytes)
      import :: c_ptr, c_size_t
      type(c_ptr), value :: law
      integer(c_size_t) :: bytes
    end function

    function osculate_law_needs(law) bind(C) result(needs)
      import :: c_int, c_ptr
      type(c_ptr), value :: law
      integer(c_int) :: needs
    end function

    function osculate_interaction_range(law, R_i, R_j, range) bind(C) result(error)
      import :: c_double, c_int, c_ptr
      type(c_ptr), value :: law
      real(c_double), value :: R_i, R_j
      real(c_double), intent(out) :: range
      integer(c_int) :: error
    end function

    function osculate_evaluate_force(law, approach, memory, force) bind(C) result(error)
      import :: c_int, c_ptr, osculate_approach, osculate_force
      type(c_ptr), value :: law, memory
      type(osculate_approach), intent(in) :: approach
      type(osculate_force), intent(inout) :: force
      integer(c_int) :: error
    end function

    function osculate_evaluate_forces(law, approach, memories, forces) bind(C) result(error)
      import :: c_int, c_ptr, osculate_approach_columns, osculate_force_columns
      type(c_ptr), value :: law, memories
      type(osculate_approach_columns), intent(in) :: approach
      type(osculate_force_columns), intent(in) :: forces
      integer(c_int) :: error
    end function
  end interface

contains

  ! What the last failing call of this thread found.
  function osculate_error_message() result(text)
    character(len=:), allocatable :: text
    text = text_at(c_error_message())
  end function

  function osculate_version() result(text)
    character(len=:), allocatable :: text
    text = text_at(c_version())
  end function

  ! osculate_new_law with Fortran strings.
  function osculate_compose_law(settings, material_1, material_2, law) result(error)
    type(osculate_setting), intent(in) :: settings(:)
    type(osculate_material), intent(in) :: material_1, material_2
    type(c_ptr), intent(inout) :: law
    integer(c_int) :: error
    character(kind=c_char, len=65), target :: names(2, size(settings))
    type(osculate_law_setting) :: c_settings(size(settings))
    integer :: i
    do i = 1, size(settings)
      names(1, i) = terminated(settings(i)%law)
      names(2, i) = terminated(settings(i)%parameter)
      c_settings(i)%law = c_loc(names(1, i))
      if (len_trim(settings(i)%parameter) > 0) c_settings(i)%parameter = c_loc(names(2, i))
      c_settings(i)%value = settings(i)%value
    end do
    error = osculate_new_law(size(settings, kind=c_size_t), c_settings, material_1, material_2, law)
  end function

  function terminated(text) result(c_text)
    character(len=*), intent(in) :: text
    character(kind=c_char, len=65) :: c_text
    c_text = trim(text) // c_null_char
  end function

  function text_at(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: i, length
    length = int(c_strlen(pointer))
    call c_f_pointer(pointer, letters, [length])
    allocate (character(len=length) :: text)
    do i = 1, length
      text(i:i) = letters(i)
    end do
  end function
end module
