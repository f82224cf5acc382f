// One symbol is enough: the table behind pellicle_get_api() holds the linked functions.
#include "support.hpp"

TEST_CASE("table: another ABI version has none") {
    for (const std::uint32_t version : {0u, PELLICLE_ABI_VERSION + 1u, UINT32_MAX}) {
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

TEST_CASE("table: every entry is the linked function of that name") {
    const PellicleApi *api = pellicle_get_api(PELLICLE_ABI_VERSION);
    REQUIRE_NE(api, nullptr);
#define CHECK_ENTRY(name) CHECK((api->name == &pellicle_##name))
    CHECK_ENTRY(abi_version);
    CHECK_ENTRY(version_string);
    CHECK_ENTRY(status_string);
    CHECK_ENTRY(last_error);
    CHECK_ENTRY(model_count);
    CHECK_ENTRY(model_info);
    CHECK_ENTRY(model_param);
    CHECK_ENTRY(bsdf_create);
    CHECK_ENTRY(bsdf_retain);
    CHECK_ENTRY(bsdf_release);
    CHECK_ENTRY(bsdf_info);
    CHECK_ENTRY(bsdf_eval);
    CHECK_ENTRY(bsdf_sample);
    CHECK_ENTRY(bsdf_albedo);
    CHECK_ENTRY(bsdf_eval_batch);
    CHECK_ENTRY(bsdf_sample_batch);
    CHECK_ENTRY(film_create);
    CHECK_ENTRY(film_retain);
    CHECK_ENTRY(film_release);
    CHECK_ENTRY(film_plan);
    CHECK_ENTRY(film_reflectance);
    CHECK_ENTRY(film_eval);
    CHECK_ENTRY(film_reflectance_batch);
    CHECK_ENTRY(film_reference);
    CHECK_ENTRY(film_spectrum);
#undef CHECK_ENTRY
}

TEST_CASE("table: the version text is the package's") {
    CHECK_EQ(std::string(pellicle_version_string()), PELLICLE_EXPECTED_VERSION);
}
