! SPDX-License-Identifier: Apache-2.0
! A SLOT connector with friction as a user element of an explicit solver, in the shape of Abaqus/Explicit's VUEL: two nodes of
! three displacements; component 1 is the slot, a penalty stiffness holds 2 and 3, and what it holds with is the normal force.
!
! props: (1) penalty stiffness of the held components [F/L], (2) mass of a node, (3) static and (4) kinetic coefficient,
! (5) their decay [T/L], (6) elastic slip [L]. svars: 15 numbers of the friction, then the position of the slot: u - du is
! rounded and would put the begin of an increment beside the end of the one before.
module slot_connector
  use, intrinsic :: iso_c_binding
  use slip_law
  implicit none
  private
  public :: friction_of, position_at
  integer, parameter :: position_at = slip_state_numbers + 1
  !> Frictions that were made, and the properties (3) to (6) that each is of.
  integer, parameter :: most = 64
  integer, save :: made = 0
  type(c_ptr), save :: laws(most) = c_null_ptr
  real(c_double), save :: of_props(4, most) = 0
  character(kind=c_char), target, save :: connection(5) = [character(kind=c_char) :: 'S', 'L', 'O', 'T', c_null_char]
  character(len=18, kind=c_char), target, save :: decay_law = 'exponential_decay' // c_null_char
  character(len=8, kind=c_char), target, save :: key(3) = &
      [character(len=8) :: 'static' // c_null_char, 'kinetic' // c_null_char, 'decay' // c_null_char]
contains
  !> Returns the friction of a set of properties: the one that was made of the same before, or a new one. Elements share it: it
  !> never changes. A solver that calls from several threads makes it under a lock of its own.
  type(c_ptr) function friction_of(props) result(law)
    real(c_double), intent(in) :: props(*)
    integer :: i
    do i = 1, made
      if (all(of_props(:, i) == props(3:6))) then
        law = laws(i)
        return
      end if
    end do
    if (made == most) error stop 'slot_connector: more sets of properties than it has room for: raise most'
    law = make_friction(props)
    made = made + 1
    of_props(:, made) = props(3:6)
    laws(made) = law
  end function

  !> Makes the friction of a set of properties.
  type(c_ptr) function make_friction(props) result(law)
    real(c_double), intent(in) :: props(*)
    type(slip_number), target :: numbers(3)
    type(slip_definition) :: definition(1)
    type(slip_error) :: error
    integer :: i
    do i = 1, 3
      numbers(i)%key = c_loc(key(i))
      numbers(i)%value = props(2 + i)
    end do
    definition(1)%size = c_sizeof(definition(1))
    definition(1)%connection = c_loc(connection)
    definition(1)%law = c_loc(decay_law)
    definition(1)%numbers = c_loc(numbers)
    definition(1)%number_count = 3
    definition(1)%elastic_slip = props(6)
    law = slip_law_create(definition, 1_c_size_t, error)
    if (.not. c_associated(law)) error stop slip_message(error)
  end function
end module

subroutine vuel(nblock, rhs, amass, dtimeStable, svars, nsvars, energy, nnode, ndofel, props, nprops, jprops, njprops, &
    coords, ncrd, u, du, v, a, jtype, jelem, time, period, dtimeCur, dtimePrev, kstep, kinc, lflags, dMassScaleFactor, &
    predef, npredef, jdltyp, adlmag)
  use, intrinsic :: iso_c_binding
  use slip_law
  use slot_connector
  implicit none
  integer, intent(in) :: nblock, nsvars, nnode, ndofel, nprops, njprops, ncrd, jtype, kstep, kinc, npredef, jdltyp
  integer, intent(in) :: jprops(njprops), jelem(nblock), lflags(*)
  real(c_double), intent(in) :: props(nprops), coords(nblock, nnode, ncrd)
  real(c_double), intent(in), dimension(nblock, ndofel) :: u, du, v, a
  real(c_double), intent(in) :: time(2), period, dtimeCur, dtimePrev, dMassScaleFactor(nblock)
  real(c_double), intent(in) :: predef(nblock, nnode, npredef, 2), adlmag(nblock)
  real(c_double), intent(inout) :: rhs(nblock, ndofel), amass(nblock, ndofel, ndofel), dtimeStable(nblock)
  real(c_double), intent(inout) :: svars(nblock, nsvars), energy(nblock, *)
  integer, parameter :: mass_matrix = 1, internal_force = 2, operation = 3
  integer, parameter :: plastic_energy = 1, internal_energy = 3
  type(c_ptr) :: friction
  type(slip_increment) :: increment
  type(slip_result) :: result(1)
  type(slip_error) :: error
  real(c_double) :: state(slip_state_numbers), force(6), held(2)
  integer :: k, i

  friction = friction_of(props)
  do k = 1, nblock
    if (lflags(operation) == mass_matrix) then
      do i = 1, ndofel
        amass(k, i, i) = props(2)
      end do
      ! The penalty between two masses of m: omega = sqrt(2 K/m), and no step longer than 2/omega.
      dtimeStable(k) = sqrt(2 * props(2) / props(1))
      ! The regime of a state of zeros would be "open".
      call slip_law_initial_state(friction, state)
      svars(k, 1:slip_state_numbers) = state
      svars(k, position_at) = 0
    else if (lflags(operation) == internal_force) then
      held = -props(1) * (u(k, 5:6) - u(k, 2:3))
      increment%duration = dtimeCur
      increment%begin(1) = svars(k, position_at)
      increment%end(1) = u(k, 4) - u(k, 1)
      increment%force(2:3) = held
      state = svars(k, 1:slip_state_numbers)
      if (slip_law_update(friction, increment, state, state, force, result, error) /= slip_ok) then
        error stop slip_message(error)
      end if
      svars(k, 1:slip_state_numbers) = state
      svars(k, position_at) = increment%end(1)
      ! Internal forces: on the second node as the connector resists, on the first one against it.
      rhs(k, 4:6) = [force(1), -held]
      rhs(k, 1:3) = -rhs(k, 4:6)
      energy(k, plastic_energy) = energy(k, plastic_energy) + result(1)%dissipation
      energy(k, internal_energy) = result(1)%stored_energy + 0.5_c_double * dot_product(held, held) / props(1)
      dtimeStable(k) = sqrt(2 * props(2) / props(1))
    end if
  end do
end subroutine
