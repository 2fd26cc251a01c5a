! SPDX-License-Identifier: Apache-2.0
! A solver in Fortran of its own: a SLOT under 100 N slips at mu N.
program fortran_consumer
  use, intrinsic :: iso_c_binding
  use slip_law
  implicit none
  character(len=5, kind=c_char), target :: slot = 'SLOT' // c_null_char
  character(len=9, kind=c_char), target :: constant = 'constant' // c_null_char
  character(len=3, kind=c_char), target :: key = 'mu' // c_null_char
  type(slip_number), target :: numbers(1)
  type(slip_definition) :: pad(1)
  type(slip_error) :: error
  type(slip_increment) :: increment
  type(slip_result) :: result(1)
  type(c_ptr) :: law
  real(c_double) :: state(slip_state_numbers), force(6)

  if (slip_law_version() /= slip_law_interface) error stop "another interface"
  numbers(1)%key = c_loc(key)
  numbers(1)%value = 0.25_c_double
  pad(1)%size = c_sizeof(pad(1))
  pad(1)%connection = c_loc(slot)
  pad(1)%law = c_loc(constant)
  pad(1)%numbers = c_loc(numbers)
  pad(1)%number_count = 1
  pad(1)%elastic_slip = 0.01_c_double
  law = slip_law_create(pad, 1_c_size_t, error)
  if (.not. c_associated(law)) error stop slip_message(error)
  call slip_law_initial_state(law, state)
  increment%duration = 1
  increment%end(1) = 1
  increment%force(2) = 100
  if (slip_law_update(law, increment, state, state, force, result, error) /= slip_ok) error stop slip_message(error)
  if (force(1) /= 25 .or. result(1)%regime /= slip_slip) error stop "another force than mu N"
  call slip_law_destroy(law)
end program
