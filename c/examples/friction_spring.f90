! SPDX-License-Identifier: Apache-2.0
! Skeleton of a friction spring for OpenRadioss, in the shape of its user property RUSER29: an AXIAL connector whose clamping
! force is constant, as of a slip joint or a friction damper. What a real one still needs: its reader in the starter (LECG29),
! which leaves the numbers of friction_numbers() in the property, and the mass and stiffness for the time step (RINI29).
! uvar: 15 numbers of the friction, the position, and a 1 of an element that has begun.
module friction_spring
  use, intrinsic :: iso_c_binding
  use slip_law
  implicit none
  integer, parameter :: position_at = slip_state_numbers + 1, begun_at = slip_state_numbers + 2
  type(c_ptr), save :: friction = c_null_ptr
contains
  !> Takes the law's numbers, of slip_law_pack or `slipbench export CASE --to numbers`.
  subroutine take_numbers(numbers)
    real(c_double), intent(in) :: numbers(:)
    type(slip_error) :: error
    friction = slip_law_unpack(numbers, size(numbers, kind=c_size_t), error)
    if (.not. c_associated(friction)) error stop slip_message(error)
  end subroutine
end module

subroutine ruser29(nel, iout, iprop, uvar, nuvar, fx, fy, fz, xmom, ymom, zmom, e, off, stifm, stifr, viscm, viscr, mass, &
    xiner, dt, xl, vx, ry1, rz1, rx, ry2, rz2, fr_wave)
  use, intrinsic :: iso_c_binding
  use slip_law
  use friction_spring
  implicit none
  integer, intent(in) :: nel, iout, iprop, nuvar
  real(c_double), intent(inout) :: uvar(nuvar, nel)
  real(c_double), intent(inout), dimension(nel) :: fx, fy, fz, xmom, ymom, zmom, e, off, stifm, stifr, viscm, viscr
  real(c_double), intent(inout), dimension(nel) :: mass, xiner, fr_wave
  real(c_double), intent(in) :: dt
  real(c_double), intent(in), dimension(nel) :: xl, vx, ry1, rz1, rx, ry2, rz2
  type(slip_increment) :: increment
  type(slip_result) :: result(1)
  type(slip_error) :: error
  real(c_double) :: state(slip_state_numbers), force(6), to_motion(6, 6), to_force(6, 6)
  integer :: i

  do i = 1, nel
    if (uvar(begun_at, i) == 0) then
      call slip_law_initial_state(friction, state)
      uvar(1:slip_state_numbers, i) = state
      uvar(begun_at, i) = 1
    end if
    increment%duration = dt
    increment%begin(1) = uvar(position_at, i)
    increment%end(1) = uvar(position_at, i) + vx(i) * dt
    state = uvar(1:slip_state_numbers, i)
    if (slip_law_tangent(friction, increment, state, state, force, result, to_motion, to_force, error) /= slip_ok) then
      error stop slip_message(error)
    end if
    uvar(1:slip_state_numbers, i) = state
    uvar(position_at, i) = increment%end(1)
    fx(i) = force(1) * off(i)
    ! What friction took and what its elastic slip holds.
    e(i) = e(i) + result(1)%work
    ! In slip the tangent may be 0 or, where friction falls with the rate, negative: the time step wants the stick's.
    stifm(i) = max(stifm(i), to_motion(1, 1))
  end do
end subroutine
