! SPDX-License-Identifier: Apache-2.0
!
! quick_look.c in Fortran 2008: gfortran quick_look.f90 $(pkg-config --libs wellstrat)

module wellstrat
    use, intrinsic :: iso_c_binding
    implicit none

    type, bind(c) :: context
        integer(c_int32_t) :: patternid, sampleid
    end type

    type, bind(c) :: domain
        integer(c_int32_t) :: generator
        integer(c_int16_t) :: slot, splits
    end type

    integer(c_int32_t), parameter :: pmj = 0, joint = 1, long = 2, blue = 3, random = 4

    interface
        integer(c_int) function camera_domain(generator, camera) &
            bind(c, name="wellstrat_camera_domain")
            import
            integer(c_int32_t), value :: generator
            type(domain) :: camera
        end function

        type(context) function camera_context(x, y, frame, sampleid, seed) &
            bind(c, name="wellstrat_camera_context")
            import
            integer(c_int32_t), value :: x, y, frame, sampleid, seed
        end function

        integer(c_int) function new_domains(parent, scramble, n, parents, child, children) &
            bind(c, name="wellstrat_new_domains")
            import
            type(domain), value :: parent
            integer(c_int32_t), value :: scramble
            integer(c_size_t), value :: n
            type(context) :: parents(*), children(*)
            type(domain) :: child
        end function

        integer(c_int) function draw_samples_2d(drawn, n, contexts, xis) &
            bind(c, name="wellstrat_draw_samples_2d")
            import
            type(domain), value :: drawn
            integer(c_size_t), value :: n
            type(context) :: contexts(*)
            real(c_float) :: xis(2, *)
        end function
    end interface

contains

    subroutine require(status)
        integer(c_int), value :: status
        if (status /= 0) error stop "wellstrat failed"
    end subroutine
end module

program quick_look
    use wellstrat
    implicit none
    type(domain) :: pixel, light
    type(context) :: contexts(4), light_contexts(4)
    real(c_float) :: xi(2, 4), on_light(2, 4)
    integer(c_size_t), parameter :: n = 4
    integer :: i

    call require(camera_domain(pmj, pixel))
    do i = 1, 4 ! four samples of pixel (320, 200) in frame 1
        contexts(i) = camera_context(320, 200, 1, i - 1, 0)
    end do
    call require(new_domains(pixel, int(z"5d1c9a37"), n, contexts, light, light_contexts))

    call require(draw_samples_2d(pixel, n, contexts, xi))
    call require(draw_samples_2d(light, n, light_contexts, on_light))
    do i = 1, 4
        print '(A,I0,4(A,F5.3),A)', "sample ", i - 1, ": pixel (", xi(1, i), ", ", xi(2, i), &
            ")  light (", on_light(1, i), ", ", on_light(2, i), ")"
    end do
end program
