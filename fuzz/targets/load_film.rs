#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| pellicle_studies::ffi_fuzz::run("load_film", data));
