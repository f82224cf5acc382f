#pragma once

// Times the films and prints their table; returns whether they keep their tolerance.
bool bench_films();
