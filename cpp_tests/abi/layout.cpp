// The headers alone compile as pedantic C++17, twice, and have the layout that is kept.
#include <pellicle.hpp>
#include <pellicle.hpp>

#include <pellicle.h>

#include <type_traits>

#define LAW(condition) static_assert(condition, #condition);

#include "layout.h"

// A container of handles must move them, not copy (and retain) them.
template <class Handle> constexpr bool moves = std::is_nothrow_move_constructible_v<Handle> &&
    std::is_nothrow_move_assignable_v<Handle> && std::is_nothrow_destructible_v<Handle> &&
    std::is_copy_constructible_v<Handle>;
static_assert(moves<pellicle::Bsdf>);
static_assert(moves<pellicle::Film>);
