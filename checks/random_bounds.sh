# Random evaluations of all models and films stay within their bounds: 1e8, or [--evaluations N]; 1e9 take half an
# hour.
if (($# == 0)); then set -- --evaluations 1e8; fi
study random_bounds "$@"
