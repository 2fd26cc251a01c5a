! SPDX-License-Identifier: Apache-2.0
! The friction law of slipbench for Fortran: the functions and structures of slipbench/c/slip_law.h under their own names.
! Compile it with the compiler of your program and link slipbench_c. Matrices arrive transposed, for C counts by rows:
! to_motion(j, i) is df_i/du_j. Components count from 1 here.
module slip_law
  use, intrinsic :: iso_c_binding
  implicit none

  integer(c_int), parameter :: slip_law_interface = 1
  integer, parameter :: slip_components = 6, slip_fields = 16, slip_definitions = 16, slip_state_numbers = 15
  integer(c_int), parameter :: slip_ok = 0, slip_bad_definition = 1, slip_bad_argument = 2, slip_not_finite = 3, &
      slip_no_solution = 4, slip_no_memory = 5
  integer(c_int), parameter :: slip_open = 0, slip_stick = 1, slip_slip = 2

  !> What went wrong; slip_message(error) is it as a text.
  type, bind(c) :: slip_error
    integer(c_int) :: status = slip_ok
    character(kind=c_char) :: message(508) = c_null_char
  end type

  !> A parameter: its key, a text that ends with c_null_char and stays where it is, and its value.
  type, bind(c) :: slip_number
    type(c_ptr) :: key = c_null_ptr
    real(c_double) :: value = 0
  end type

  !> One friction definition in numbers; set size = c_sizeof(definition).
  type, bind(c) :: slip_definition
    integer(c_size_t) :: size = 0
    type(c_ptr) :: connection = c_null_ptr
    type(c_ptr) :: geometry = c_null_ptr
    integer(c_size_t) :: geometry_count = 0
    type(c_ptr) :: law = c_null_ptr
    type(c_ptr) :: numbers = c_null_ptr
    integer(c_size_t) :: number_count = 0
    real(c_double) :: slip_scale(6) = 0, contact_weight(6) = 0
    real(c_double) :: internal_contact_force = 0, elastic_slip = 0, stick_stiffness = 0, force_limit = 0
  end type

  !> An increment of the connector: dt, positions CP at its begin and end, constraint forces at its end.
  type, bind(c) :: slip_increment
    real(c_double) :: duration = 0
    real(c_double) :: begin(6) = 0, end(6) = 0, reference(6) = 0, force(6) = 0
    real(c_double) :: temperature = 0
    type(c_ptr) :: fields = c_null_ptr
    integer(c_size_t) :: field_count = 0
  end type

  !> One definition at the end of an increment.
  type, bind(c) :: slip_result
    real(c_double) :: limit, normal_force, mu, slip_increment, slip_rate, dissipation, stored_energy, work
    integer(c_int) :: regime
  end type

  interface
    integer(c_int) function slip_law_version() bind(c)
      import :: c_int
    end function

    type(c_ptr) function slip_law_create(definitions, count, error) bind(c)
      import :: c_ptr, c_size_t, slip_definition, slip_error
      type(slip_definition), intent(in) :: definitions(*)
      integer(c_size_t), value :: count
      type(slip_error), intent(out) :: error
    end function

    type(c_ptr) function slip_law_unpack(numbers, count, error) bind(c)
      import :: c_ptr, c_size_t, c_double, slip_error
      real(c_double), intent(in) :: numbers(*)
      integer(c_size_t), value :: count
      type(slip_error), intent(out) :: error
    end function

    integer(c_size_t) function slip_law_pack(law, numbers, capacity) bind(c)
      import :: c_ptr, c_size_t, c_double
      type(c_ptr), value :: law
      real(c_double), intent(out) :: numbers(*)
      integer(c_size_t), value :: capacity
    end function

    subroutine slip_law_destroy(law) bind(c)
      import :: c_ptr
      type(c_ptr), value :: law
    end subroutine

    integer(c_size_t) function slip_law_definitions(law) bind(c)
      import :: c_ptr, c_size_t
      type(c_ptr), value :: law
    end function

    integer(c_size_t) function slip_law_state_size(law) bind(c)
      import :: c_ptr, c_size_t
      type(c_ptr), value :: law
    end function

    subroutine slip_law_initial_state(law, state) bind(c)
      import :: c_ptr, c_double
      type(c_ptr), value :: law
      real(c_double), intent(out) :: state(*)
    end subroutine

    integer(c_int) function slip_law_update(law, increment, old_state, new_state, force, results, error) bind(c)
      import :: c_ptr, c_int, c_double, slip_increment, slip_result, slip_error
      type(c_ptr), value :: law
      type(slip_increment), intent(in) :: increment
      real(c_double), intent(in) :: old_state(*)
      real(c_double), intent(inout) :: new_state(*)
      real(c_double), intent(inout) :: force(6)
      type(slip_result), intent(inout) :: results(*)
      type(slip_error), intent(inout) :: error
    end function

    integer(c_int) function slip_law_tangent(law, increment, old_state, new_state, force, results, to_motion, to_force, &
        error) bind(c)
      import :: c_ptr, c_int, c_double, slip_increment, slip_result, slip_error
      type(c_ptr), value :: law
      type(slip_increment), intent(in) :: increment
      real(c_double), intent(in) :: old_state(*)
      real(c_double), intent(inout) :: new_state(*)
      real(c_double), intent(inout) :: force(6)
      type(slip_result), intent(inout) :: results(*)
      real(c_double), intent(inout) :: to_motion(6, 6), to_force(6, 6)
      type(slip_error), intent(inout) :: error
    end function

    integer(c_int) function slip_law_coefficient(law, definition, slip_rate, contact_force, temperature, fields, &
        field_count, mu, to_slip_rate, to_contact_force, error) bind(c)
      import :: c_ptr, c_int, c_size_t, c_double, slip_error
      type(c_ptr), value :: law
      integer(c_size_t), value :: definition, field_count  ! definition counts from 0
      real(c_double), value :: slip_rate, contact_force, temperature
      real(c_double), intent(in) :: fields(*)
      real(c_double), intent(inout) :: mu, to_slip_rate, to_contact_force
      type(slip_error), intent(inout) :: error
    end function
  end interface

contains

  !> Returns the sentence of an error.
  function slip_message(error) result(text)
    type(slip_error), intent(in) :: error
    character(len=:), allocatable :: text
    integer :: i
    text = ""
    do i = 1, size(error%message)
      if (error%message(i) == c_null_char) exit
      text = text // error%message(i)
    end do
  end function

end module slip_law
