#pragma once

// Prints single calls beside C++ virtual functions. Returns whether both compute the same.
bool bench_virtual_calls();
