# What `./x package` makes, for every platform, and programs built from it without cargo.
run_package
