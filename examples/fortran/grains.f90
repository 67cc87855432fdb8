! Osculate in a Fortran program: two grains on a floor, their contacts and forces over a few time steps.
!   make && ./grains        (PKG_CONFIG_PATH: where osculate-fortran.pc is)
program grains
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
  use osculate
  implicit none
  integer, parameter :: dp = c_double, bodies = 3, pairs = 3, steps = 3

  ! Bodies, counted from 0: a floor, a blocky grain that lies on it, an ellipsoid that slides and rolls over the
  ! grain.
  type(c_ptr), target :: shape(0:bodies-1) = c_null_ptr
  real(dp), target :: x(0:bodies-1, 3) = reshape([0.0_dp, 0.0_dp, 2e-3_dp, 0.0_dp, 0.0_dp, 1e-3_dp, &
    0.0_dp, 2.703e-3_dp, 7.6662e-3_dp], [bodies, 3])  ! [m]
  real(dp), target :: q(0:bodies-1, 4) = reshape([1.0_dp, 0.9822618062296308_dp, 0.8660254037844386_dp, &
    0.0_dp, 0.10023079655404396_dp, 0.0_dp, 0.0_dp, 0.15034619483106593_dp, 0.5_dp, &
    0.0_dp, 0.05011539827702198_dp, 0.0_dp], [bodies, 4])
  real(dp) :: v(0:bodies-1, 3) = reshape([0.0_dp, 0.0_dp, 0.05_dp, 0.0_dp, 0.0_dp, 0.02_dp, &
    0.0_dp, 0.0_dp, -0.01_dp], [bodies, 3])  ! [m/s]
  real(dp) :: w(0:bodies-1, 3) = reshape([0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 2.0_dp, 10.0_dp, &
    0.0_dp, -1.0_dp, 5.0_dp], [bodies, 3])  ! [rad/s]
  real(dp) :: mass(0:bodies-1) = [0.0_dp, 4e-4_dp, 3e-4_dp]  ! [kg]
  type(osculate_bodies) :: placed

  ! Pairs that may touch, and what each of them remembers: zeros at first. A pair that leaves the list takes its bytes
  ! with it, one that comes brings zeros.
  integer(c_int32_t) :: body_1(pairs) = [0, 1, 0], body_2(pairs) = [1, 2, 2]
  integer(c_int8_t), allocatable, target :: caches(:), memories(:)

  ! Columns: what contacts say goes to the law as it is.
  integer(c_int32_t), target :: status(pairs), law_status(pairs)
  real(dp), target :: normal(pairs, 3), overlap(pairs), on_1(pairs, 3), on_2(pairs, 3), R_i(pairs), R_j(pairs)
  real(dp), target :: major(pairs, 3)
  real(dp), target :: velocity(pairs, 3), rotation(pairs, 3), reduced_mass(pairs), force(pairs, 3), normal_force(pairs)
  real(dp) :: arm_1(pairs, 3), arm_2(pairs, 3), body_force(0:bodies-1, 3), torque(0:bodies-1, 3)
  type(osculate_contact_columns) :: contacts
  type(osculate_approach_columns) :: approach
  type(osculate_force_columns) :: forces
  type(osculate_material) :: glass = osculate_material(71e9_dp, 0.22_dp)
  type(c_ptr) :: law = c_null_ptr
  integer :: i, j, k, step

  if (osculate_abi_version() /= OSCULATE_MODULE_ABI_VERSION) error stop "compiled for another libosculate_c"
  mass(0) = ieee_value(mass(0), ieee_positive_inf)
  call check(osculate_new_half_space(shape(0)))
  call check(osculate_new_superquadric([5e-3_dp, 3e-3_dp, 2e-3_dp], 2.5_dp, 3.0_dp, shape(1)))
  call check(osculate_new_ellipsoid([4e-3_dp, 3e-3_dp, 2.5e-3_dp], shape(2)))
  placed%size = bodies
  placed%shape = c_loc(shape)
  placed%position = columns(x)
  placed%orientation = [(c_loc(q(0, k)), k = 1, 4)]

  ! The law by the names of its parts, bound to the materials of both bodies.
  call check(osculate_compose_law([osculate_setting("hertz"), osculate_setting("tsuji", "restitution", 0.8_dp), &
    osculate_setting("mindlin", "friction", 0.4_dp)], glass, glass, law))
  allocate (caches(pairs * osculate_cache_size()), memories(pairs * osculate_memory_size(law)), source=0_c_int8_t)

  contacts%status = c_loc(status)
  contacts%normal = columns(normal)
  contacts%overlap = c_loc(overlap)
  contacts%on_1 = columns(on_1)
  contacts%on_2 = columns(on_2)
  contacts%R_i = c_loc(R_i)
  contacts%R_j = c_loc(R_j)
  contacts%major_axis = columns(major)
  approach%size = pairs
  approach%R_i = c_loc(R_i)
  approach%R_j = c_loc(R_j)
  approach%overlap = c_loc(overlap)
  approach%normal = columns(normal)
  approach%major_axis = columns(major)
  approach%velocity = columns(velocity)
  approach%mean_angular_velocity = columns(rotation)
  approach%reduced_mass = c_loc(reduced_mass)
  approach%time_step = 1e-6_dp
  forces%status = c_loc(law_status)
  forces%force = columns(force)
  forces%normal_force = c_loc(normal_force)

  do step = 1, steps
    call check(osculate_find_contacts(placed, int(pairs, c_size_t), body_1, body_2, OSCULATE_GAP_SKIP, &
      c_loc(caches), contacts))

    do k = 1, pairs
      i = body_1(k)
      j = body_2(k)
      arm_1(k, :) = 0.5_dp * (on_1(k, :) + on_2(k, :)) - x(i, :)
      arm_2(k, :) = 0.5_dp * (on_1(k, :) + on_2(k, :)) - x(j, :)
      velocity(k, :) = v(j, :) + cross(w(j, :), arm_2(k, :)) - v(i, :) - cross(w(i, :), arm_1(k, :))
      rotation(k, :) = 0.5_dp * (w(i, :) + w(j, :))
      reduced_mass(k) = 1.0_dp / (1.0_dp / mass(i) + 1.0_dp / mass(j))
    end do
    call check(osculate_evaluate_forces(law, approach, c_loc(memories), forces))

    body_force = 0.0_dp
    torque = 0.0_dp
    do k = 1, pairs
      i = body_1(k)
      j = body_2(k)
      body_force(i, :) = body_force(i, :) + force(k, :)
      body_force(j, :) = body_force(j, :) - force(k, :)
      torque(i, :) = torque(i, :) + cross(arm_1(k, :), force(k, :))
      torque(j, :) = torque(j, :) - cross(arm_2(k, :), force(k, :))
    end do

    ! Here a host moves its bodies by its own integrator; these go on as they go.
    x = x + v * approach%time_step
  end do

  do k = 1, pairs
    if (status(k) /= OSCULATE_TOUCHING) cycle
    print "(a, i0, 1x, i0, 9es24.16)", "contact ", body_1(k), body_2(k), normal(k, :), overlap(k), R_i(k), R_j(k), &
      force(k, :)
  end do
  do i = 1, bodies - 1
    print "(a, i0, 6es24.16)", "body ", i, body_force(i, :), torque(i, :)
  end do

  call osculate_free_law(law)
  do i = 0, bodies - 1
    call osculate_free_shape(shape(i))
  end do

contains

  subroutine check(error)
    integer(c_int), intent(in) :: error
    if (error == OSCULATE_OK) return
    print "(a)", osculate_error_message()
    error stop
  end subroutine

  pure function cross(a, b) result(c)
    real(dp), intent(in) :: a(3), b(3)
    real(dp) :: c(3)
    c = [a(2) * b(3) - a(3) * b(2), a(3) * b(1) - a(1) * b(3), a(1) * b(2) - a(2) * b(1)]
  end function

  ! Where the three columns of vectors stand.
  function columns(vectors) result(pointers)
    real(dp), intent(in), target, contiguous :: vectors(:, :)
    type(c_ptr) :: pointers(3)
    integer :: c
    pointers = [(c_loc(vectors(1, c)), c = 1, 3)]
  end function
end program
