# Films keep their tolerance: random stacks against the reference, 100, or [--stacks N]; 1000 take an hour or two.
if (($# == 0)); then set -- --stacks 100; fi
study film_tolerance "$@"
