// One symbol is enough: the table behind pellicle_get_api() holds the linked functions.
#include "support.hpp"

#ifdef _WIN32
#include <windows.h>
#endif

namespace {

// The function that the program is linked with. On Windows the program's own address of a function in a DLL is that
// of a jump to it, and the DLL tells the function's.
template <class Function> Function *linked(Function *function, [[maybe_unused]] const char *name) {
#ifdef _WIN32
    if (const HMODULE dll = GetModuleHandleA("pellicle.dll"))
        return reinterpret_cast<Function *>(reinterpret_cast<void (*)()>(GetProcAddress(dll, name)));
#endif
    return function;
}

} // namespace

TEST_CASE("table: another ABI version has none") {
    for (const std::uint32_t version : {PELLICLE_ABI_VERSION + 1u, UINT32_MAX}) {
        CAPTURE(version);
        CHECK_EQ(pellicle_get_api(version), nullptr);
    }
}

TEST_CASE("table: the ABI version of the header is the library's, and the table's size is its own") {
    CHECK_EQ(pellicle_abi_version(), PELLICLE_ABI_VERSION);
    const PellicleApi *api = pellicle_get_api(PELLICLE_ABI_VERSION);
    REQUIRE_NE(api, nullptr);
    CHECK_EQ(api->size, sizeof *api);
    CHECK_EQ(pellicle_get_api(PELLICLE_ABI_VERSION), api);
}

// functions.inc has every function that the header declares but pellicle_get_api() itself: none can be forgotten.
TEST_CASE("table: every function of the header has an entry, which is the linked function of that name") {
    const PellicleApi *api = pellicle_get_api(PELLICLE_ABI_VERSION);
    REQUIRE_NE(api, nullptr);
    std::size_t size = sizeof api->size;
#define FUNCTION(name) \
    CHECK((api->name == linked(&pellicle_##name, "pellicle_" #name)));                                                                  \
    size += sizeof api->name;
#include "functions.inc"
#undef FUNCTION
    CHECK_EQ(api->size, size);
}

TEST_CASE("table: the version text is the package's") {
    CHECK_EQ(std::string(pellicle_version_string()), PELLICLE_EXPECTED_VERSION);
}
