! SPDX-License-Identifier: Apache-2.0
! The harness that plays the solver. doors KIND < ROWS > RESULTS:
!   law          a fixture of random definitions; prints how many there were, and stops at the first number that differs
!   connector    the user element slot_connector: properties, then rows "dt CP1 f2 f3"; prints the friction force of each
!   coefficient  the contact's coefficient: count and numbers of the law, then rows "rate pressure"; prints mu and its slopes
!   spring       the friction spring: count and numbers, then rows "dt rate"; prints the force of each
program doors
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit, iostat_end
  implicit none
  character(len=20) :: kind
  call get_command_argument(1, kind)
  select case (kind)
  case ("law"); call all_laws()
  case ("connector"); call run_connector()
  case ("coefficient"); call run_coefficient()
  case ("spring"); call run_spring()
  case default; error stop "doors law|connector|coefficient|spring"
  end select

contains

  !> Reads a count and so many numbers.
  function counted_numbers() result(numbers)
    real(c_double), allocatable :: numbers(:)
    integer :: count
    read *, count
    allocate(numbers(count))
    read *, numbers
  end function

  !> Reads a line of so many numbers; .false. behind the last.
  logical function next(row)
    real(c_double), intent(out) :: row(:)
    integer :: status
    read (*, *, iostat=status) row
    next = status == 0
    if (status /= 0 .and. status /= iostat_end) error stop "a row cannot be read"
  end function

  subroutine all_laws()
    use slip_law
    integer, parameter :: told = 6 + slip_state_numbers + 9
    type(c_ptr) :: law
    type(slip_error) :: error
    type(slip_increment) :: increment
    type(slip_result) :: one(1)
    real(c_double), target :: fields(2)
    real(c_double), allocatable :: numbers(:), again(:)
    real(c_double) :: state(slip_state_numbers), force(6), row(28), wanted(told), found(told)
    integer :: count, rows, i, j
    if (slip_law_version() /= slip_law_interface) error stop "another version of the library"
    read *, count
    do i = 1, count
      numbers = counted_numbers()
      law = slip_law_unpack(numbers, size(numbers, kind=c_size_t), error)
      if (.not. c_associated(law)) error stop slip_message(error)
      allocate(again(size(numbers)))
      if (slip_law_pack(law, again, size(again, kind=c_size_t)) /= size(numbers)) error stop "packed otherwise"
      if (any(again /= numbers)) error stop "other numbers come back"
      deallocate(again)
      call slip_law_initial_state(law, state)
      read *, rows
      do j = 1, rows
        read *, row, wanted
        increment%duration = row(1)
        increment%begin = row(2:7)
        increment%end = row(8:13)
        increment%reference = row(14:19)
        increment%force = row(20:25)
        increment%temperature = row(26)
        fields = row(27:28)
        increment%fields = c_loc(fields)
        increment%field_count = 2
        if (slip_law_update(law, increment, state, state, force, one, error) /= slip_ok) error stop slip_message(error)
        found = [force, state, one(1)%limit, one(1)%normal_force, one(1)%mu, one(1)%slip_increment, one(1)%slip_rate, &
            one(1)%dissipation, one(1)%stored_energy, one(1)%work, real(one(1)%regime, c_double)]
        if (any(found /= wanted)) then
          write (error_unit, *) "definition", i, "row", j, "number", findloc(found /= wanted, .true., 1)
          error stop "another number than the law's"
        end if
      end do
      call slip_law_destroy(law)
    end do
    print *, count
  end subroutine

  subroutine run_connector()
    use slip_law, only: slip_state_numbers
    ! The numbers of the friction, and the position.
    integer, parameter :: operation = 3, n = slip_state_numbers + 1
    real(c_double) :: props(6), other(6), rhs(1, 6), amass(1, 6, 6), stable(1), svars(1, n), energy(1, 12), u(1, 6), old(1, 6)
    real(c_double) :: nothing(1, 6), row(4), coords(1, 2, 3), predef(1, 2, 1, 2), one(1)
    integer :: lflags(3), none(1)
    external :: vuel
    nothing = 0; coords = 0; predef = 0; one = 0; none = 0; energy = 0; u = 0; amass = 0; rhs = 0; lflags = 0; row = 0
    read *, props
    lflags(operation) = 1
    ! Elements of another set come first: each set keeps its own friction.
    other = props
    other(3:4) = 2 * props(3:4)
    call vuel(1, rhs, amass, stable, svars, n, energy, 2, 6, other, 6, none, 1, coords, 3, u, u, nothing, nothing, 1, none, &
        [0.0_c_double, 0.0_c_double], 1.0_c_double, row(1), row(1), 1, 1, lflags, one, predef, 1, 0, one)
    amass = 0
    do
      old = u
      u(1, 4:6) = [row(2), -row(3:4) / props(1)]
      call vuel(1, rhs, amass, stable, svars, n, energy, 2, 6, props, 6, none, 1, coords, 3, u, u - old, nothing, nothing, 1, &
          none, [row(1), row(1)], 1.0_c_double, row(1), row(1), 1, 1, lflags, one, predef, 1, 0, one)
      if (lflags(operation) == 2) print '(3es26.17e3)', rhs(1, 4), energy(1, 1), stable(1)
      lflags(operation) = 2
      if (.not. next(row)) exit
    end do
  end subroutine

  subroutine run_coefficient()
    real(c_double), allocatable :: props(:)
    real(c_double) :: row(2), mu(1), slopes(1, 3), nothing(1, 1), one(1)
    character(80), parameter :: names(3) = [character(80) :: "interaction", "secondary", "main"]
    external :: fric_coef
    props = counted_numbers()
    nothing = 0; one = 0
    do while (next(row))
      call fric_coef(mu, slopes, 1, size(props), 1, 0, [0], one, names(1), names(2), names(3), props, row(1), &
          row(2), one, nothing)
      print '(3es26.17e3)', mu, slopes(1, 1:2)
    end do
  end subroutine

  subroutine run_spring()
    use friction_spring, only: take_numbers
    use slip_law, only: slip_state_numbers
    ! The numbers of the friction, the position, and the 1 of an element that has begun.
    integer, parameter :: n = slip_state_numbers + 2
    real(c_double) :: row(2), uvar(n, 1), fx(1), e(1), stiff(1), off(1), zero(1), rest(1)
    external :: ruser29
    call take_numbers(counted_numbers())
    uvar = 0; e = 0; off = 1; zero = 0; rest = 0
    do while (next(row))
      stiff = 0
      call ruser29(1, 6, 1, uvar, n, fx, rest, rest, rest, rest, rest, e, off, stiff, rest, rest, rest, rest, rest, row(1), zero, &
          row(2), zero, zero, zero, zero, zero, rest)
      print '(3es26.17e3)', fx, e, stiff
    end do
  end subroutine
end program
