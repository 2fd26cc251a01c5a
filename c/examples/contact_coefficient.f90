! SPDX-License-Identifier: Apache-2.0
! A friction law as the coefficient of a contact, in the shape of Abaqus/Standard's FRIC_COEF: stick, slip and the pressure are the
! solver's. props are the law's numbers as slip_law_pack or `slipbench export CASE --to numbers` gives them, tables and all.
subroutine fric_coef(fcoef, fcoefderiv, nblock, nprops, ntemp, nfields, jflags, rdata, surfint, surfslv, surfmst, props, &
    sliprate, pressure, tempavg, fieldavg)
  use, intrinsic :: iso_c_binding
  use slip_law
  implicit none
  integer, intent(in) :: nblock, nprops, ntemp, nfields, jflags(*)
  real(c_double), intent(in) :: rdata(*), props(nprops)
  character(len=80), intent(in) :: surfint, surfslv, surfmst
  real(c_double), intent(in) :: sliprate(nblock), pressure(nblock), tempavg(nblock), fieldavg(nblock, nfields)
  real(c_double), intent(out) :: fcoef(nblock), fcoefderiv(nblock, 3)
  type(c_ptr), save :: law = c_null_ptr
  type(slip_error) :: error
  real(c_double) :: fields(slip_fields)
  integer :: k, count

  if (.not. c_associated(law)) then
    law = slip_law_unpack(props, int(nprops, c_size_t), error)
    if (.not. c_associated(law)) error stop slip_message(error)
  end if
  count = min(nfields, slip_fields)
  do k = 1, nblock
    fields(1:count) = fieldavg(k, 1:count)
    if (slip_law_coefficient(law, 0_c_size_t, sliprate(k), max(pressure(k), 0.0_c_double), tempavg(k), fields, &
        int(count, c_size_t), fcoef(k), fcoefderiv(k, 1), fcoefderiv(k, 2), error) /= slip_ok) error stop slip_message(error)
    ! The law gives no slope to the temperature; without it the iteration is slower, its result the same.
    fcoefderiv(k, 3) = 0
  end do
end subroutine
