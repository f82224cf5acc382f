# The shared library exports the functions of the header, all of them and nothing else.
run_ctest abi.exported_symbols pellicle_cargo
