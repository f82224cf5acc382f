# WebAssembly: the library builds, and a film is described and evaluated under Node.
need_target wasm32-unknown-unknown
need_tool node nodejs
step cargo build --locked --release --lib --target wasm32-unknown-unknown
step node checks/wasm.mjs "$(target_folder)/wasm32-unknown-unknown/release/pellicle.wasm"
