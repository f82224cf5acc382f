# A program compiled against the first header of this ABI version runs with today's library.
run_ctest abi.older abi_older
